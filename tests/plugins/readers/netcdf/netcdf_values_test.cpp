// SPDX-License-Identifier: GPL-3.0-or-later
// Values of NetCDF variables are what the attributes make of the stored numbers: fill values and limits are held
// against these before they are scaled; and what is taken of a file is told (D3, S20).
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

#include <array>
#include <functional>
#include <limits>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

using Attributes = std::function<void(NetCdfTestFile&, int variable)>;

/// A variable "q" of 3 x 3 x 3 numbers with these attributes.
template <class T>
void writeNumbers(const fs::path& path, const std::vector<T>& numbers, const Attributes& attributes, int mode)
{
    NetCdfTestFile file(path, mode);
    const int z = file.dimension("z", 3), y = file.dimension("y", 3), x = file.dimension("x", 3);
    const int q = file.define("q", NetCdfTestFile::typeOf<T>(), {z, y, x});
    attributes(file, q);
    file.put(q, numbers);
}

/// 0, 1, 2 ... 26.
template <class T> std::vector<T> counted()
{
    return steps<T>(27, 0, 1);
}

} // namespace

class NetCdfValuesTest : public QObject {
    Q_OBJECT

private slots:
    void typesAreKept()
    {
        expectType<std::int8_t>(SampleType::Int8);
        expectType<std::uint8_t>(SampleType::UInt8);
        expectType<std::int16_t>(SampleType::Int16);
        expectType<std::uint16_t>(SampleType::UInt16);
        expectType<std::int32_t>(SampleType::Int32);
        expectType<std::uint32_t>(SampleType::UInt32);
        expectType<std::int64_t>(SampleType::Int32);
        expectType<std::uint64_t>(SampleType::Int32);
        expectType<float>(SampleType::Float32);
        expectType<double>(SampleType::Float64);
    }

    void wideIntegersBecomeDoubles()
    {
        std::vector<std::int64_t> numbers = counted<std::int64_t>();
        numbers[5] = std::int64_t(1) << 40;
        const auto dataset = read<std::int64_t>(
            numbers, [](NetCdfTestFile&, int) {}, NC_NETCDF4);
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.type() == SampleType::Float64);
        QCOMPARE(dataset->values.at(5), std::ldexp(1.0, 40));
        QCOMPARE(dataset->remarks.size(), std::size_t(2)); // and the spacing
    }

    void scaledNumbers()
    {
        const auto doubles = read<std::int16_t>(counted<std::int16_t>(), [](NetCdfTestFile& file, int q) {
            file.numbers<double>(q, "scale_factor", {0.25});
            file.numbers<double>(q, "add_offset", {-3});
        });
        QVERIFY(doubles.ok() && doubles->values.type() == SampleType::Float64);
        QCOMPARE(doubles->values.at(26), 26 * 0.25 - 3);
        const auto floats = read<std::int16_t>(counted<std::int16_t>(), [](NetCdfTestFile& file, int q) {
            file.numbers<float>(q, "scale_factor", {0.1F});
        });
        QVERIFY(floats.ok() && floats->values.type() == SampleType::Float32);
        QCOMPARE(floats->values.at(3), double(float(3 * double(0.1F))));
    }

    void unsignedNumbersOfSignedTypes()
    {
        std::vector<std::int8_t> numbers = counted<std::int8_t>();
        numbers[1] = -1; // 255
        numbers[2] = -2; // 254: no value
        const auto dataset = read<std::int8_t>(numbers, [](NetCdfTestFile& file, int q) {
            file.text(q, "_Unsigned", "true");
            file.numbers<std::int8_t>(q, "_FillValue", {-2});
            file.numbers<double>(q, "scale_factor", {2});
        });
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->values.at(1), 510.);
        QCOMPARE(holesOf(*dataset), (std::vector<int>{2}));
    }

    void whatIsNoValue_data()
    {
        QTest::addColumn<int>("which");
        for (int which = 0; which < 9; ++which)
            QTest::addRow("%d", which) << which;
    }
    void whatIsNoValue()
    {
        QFETCH(int, which);
        const std::vector<Attributes> attributes{
            [](NetCdfTestFile& file, int q) { file.numbers<std::int16_t>(q, "_FillValue", {4}); },
            [](NetCdfTestFile& file, int q) {
                file.numbers<std::int16_t>(q, "missing_value", {4, 7});
            },
            [](NetCdfTestFile& file, int q) { file.numbers<double>(q, "missing_value", {4}); },
            [](NetCdfTestFile& file, int q) {
                file.numbers<std::int16_t>(q, "valid_range", {2, 24});
            },
            [](NetCdfTestFile& file, int q) { file.numbers<std::int16_t>(q, "valid_min", {3}); },
            [](NetCdfTestFile& file, int q) { file.numbers<std::int16_t>(q, "valid_max", {24}); },
            [](NetCdfTestFile& file, int q) {
                file.numbers<double>(q, "valid_range", {0.5, 2.5});
            },                                                                                     // of values
            [](NetCdfTestFile& file, int q) { file.numbers<double>(q, "missing_value", {0.75}); }, // likewise
            [](NetCdfTestFile& file, int q) {
                file.numbers<std::int16_t>(q, "_FillValue", {4});
                file.numbers<std::int16_t>(q, "missing_value", {7});
                file.numbers<std::int16_t>(q, "valid_min", {1});
            }};
        const std::vector<std::vector<int>> holes{{4},      {4, 7},  {4}, {0, 1, 25, 26}, {0, 1, 2},
                                                  {25, 26}, {0, 26}, {3}, {0, 4, 7}};
        const std::vector<std::string> told{"4",
                                            "4, 7",
                                            "4",
                                            "all beyond 2 to 24",
                                            "all below 3",
                                            "all above 24",
                                            "all beyond 0.5 to 2.5",
                                            "0.75",
                                            "4, 7, all below 1"};
        const auto number = std::size_t(which);
        const bool isOfValues = which == 6 || which == 7;
        const auto dataset = read<std::int16_t>(counted<std::int16_t>(), [&](NetCdfTestFile& file, int q) {
            file.numbers<double>(q, "scale_factor", {isOfValues ? which == 6 ? 0.1 : 0.25 : 100});
            attributes[number](file, q);
        });
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        const std::vector<int> expected = which == 6 ? std::vector<int>{0, 1, 2, 3, 4, 26} : holes[number];
        QCOMPARE(holesOf(*dataset), expected);
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Fill), told[number]);
        const auto contents = builtNetCdfReader().probe(folder_.path("q.nc"), {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->taken, dataset->source.taken);
    }

    /// 1e20 is not 1e20 in single precision.
    void roundedFillValues()
    {
        std::vector<float> numbers = counted<float>();
        numbers[3] = 1e20F;
        numbers[4] = -999.9F;
        const auto dataset = read<float>(numbers, [](NetCdfTestFile& file, int q) {
            file.numbers<double>(q, "missing_value", {1e20, -999.9});
        });
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(holesOf(*dataset), (std::vector<int>{3, 4}));
        const auto single = read<float>(numbers, [](NetCdfTestFile& file, int q) {
            file.numbers<float>(q, "missing_value", {1e20F, -999.9F});
        });
        QVERIFY2(single.ok(), single.ok() ? "" : single.error().text().c_str());
        QCOMPARE(takenOf(single->source.taken, TakenPart::Fill), std::string("1e+20, -999.9"));
    }

    /// What a file says to be unfilled has no number that the library fills with.
    void whatIsNotFilled()
    {
        const fs::path path = folder_.path("unfilled.nc");
        for (const int isUnfilled : {0, 1}) {
            int file = 0, q = 0;
            std::array<int, 3> dimensions{};
            QCOMPARE(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &file), NC_NOERR);
            for (std::size_t axis = 0; axis < 3; ++axis)
                QCOMPARE(nc_def_dim(file, std::array{"z", "y", "x"}[axis], 3, &dimensions[axis]), NC_NOERR);
            QCOMPARE(nc_def_var(file, "q", NC_FLOAT, 3, dimensions.data(), &q), NC_NOERR);
            QCOMPARE(nc_def_var_fill(file, q, isUnfilled, nullptr), NC_NOERR);
            std::vector<float> numbers = counted<float>();
            numbers[8] = NC_FILL_FLOAT;
            QCOMPARE(nc_put_var_float(file, q, numbers.data()), NC_NOERR);
            QCOMPARE(nc_close(file), NC_NOERR);
            const auto dataset = builtNetCdfReader().read(path, {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(holesOf(*dataset), isUnfilled != 0 ? std::vector<int>() : std::vector<int>{8});
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Fill),
                     isUnfilled != 0 ? std::string()
                                     : "9.96921e+36, with which the NetCDF library fills what was never written ?");
        }
    }

    /// The dates are those that cftime, another library, makes of the same numbers.
    void times_data()
    {
        QTest::addColumn<double>("time");
        QTest::addColumn<QString>("units");
        QTest::addColumn<QString>("calendar");
        QTest::addColumn<QString>("date");
        QTest::newRow("hours") << 1073364. << "hours since 1900-01-01 00:00:00.0"
                               << "gregorian"
                               << "2022-06-13 12:00";
        QTest::newRow("seconds") << 1655100005. << "seconds since 1970-01-01"
                                 << "proleptic_gregorian"
                                 << "2022-06-13 06:00:05";
        QTest::newRow("no calendar") << 59.5 << "days since 2000-1-1T00:00:00Z"
                                     << ""
                                     << "2000-02-29 12:00";
        QTest::newRow("no leap days") << 59.5 << "days since 2000-01-01"
                                      << "noleap"
                                      << "2000-03-01 12:00";
        QTest::newRow("all leap") << 59.5 << "days since 2001-01-01"
                                  << "366_day"
                                  << "2001-02-29 12:00";
        QTest::newRow("months of 30 days") << 59.25 << "days since 2001-01-01"
                                           << "360_day"
                                           << "2001-02-30 06:00";
        QTest::newRow("across the reform") << 1. << "days since 1582-10-04"
                                           << "standard"
                                           << "1582-10-15 00:00";
        QTest::newRow("without a reform") << 1. << "days since 1582-10-04"
                                          << "proleptic_gregorian"
                                          << "1582-10-05 00:00";
        QTest::newRow("Julian") << 1. << "days since 1900-02-28"
                                << "julian"
                                << "1900-02-29 00:00";
        QTest::newRow("before") << -90. << "minutes since 2000-03-01 01:00"
                                << "standard"
                                << "2000-02-29 23:30";
    }
    void times()
    {
        QFETCH(double, time);
        QFETCH(QString, units);
        QFETCH(QString, calendar);
        QFETCH(QString, date);
        QCOMPARE(timeTold(time, units, calendar),
                 QString("1 of 2, %1 (%2 %3) ?").arg(date).arg(time, 0, 'g', 17).arg(units));
    }

    void timesThatAreNoDates()
    {
        QCOMPARE(timeTold(3, "months since 2000-01-01", ""), QString("1 of 2, time 3 (months since 2000-01-01) ?"));
        for (const char* units : {"days since 2000-13-01", "days since then", "days since 2000-01-01 00:00 +02:00"})
            QCOMPARE(timeTold(3, units, ""), QString("1 of 2, time 3 (%1) ?").arg(units));
        QCOMPARE(timeTold(1e300, "days since 2000-01-01", ""),
                 QString("1 of 2, time 1e+300 (days since 2000-01-01) ?"));
        QCOMPARE(timeTold(3, "days since 2000-01-01", "martian"), QString("1 of 2, time 3 (days since 2000-01-01) ?"));
    }

    void variablesByTheirLongNames()
    {
        const fs::path path = folder_.path("names.nc");
        {
            NetCdfTestFile file(path);
            const int z = file.dimension("z", 3), y = file.dimension("y", 3), x = file.dimension("x", 3);
            const int q = file.add("q", {z, y, x}, counted<float>()),
                      t = file.add("t", {z, y, x}, steps<float>(27, 5, 1)),
                      u = file.add("u", {z, y, x}, steps<float>(27, 9, 1));
            file.text(q, "long_name", "Humidity");
            file.text(t, "long_name", "Temperature");
            file.text(t, "standard_name", "air_temperature");
            file.text(u, "long_name", "Humidity");
        }
        for (const char* name : {"t", "Temperature", "air_temperature"}) {
            const auto dataset = builtNetCdfReader().read(path, {{"array", std::string(name)}}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->values.at(0), 5.);
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Array), std::string("t"));
        }
        const auto twice = builtNetCdfReader().read(path, {{"array", std::string("Humidity")}}, {});
        QVERIFY(!twice.ok() && twice.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(twice.error().text().find("'q' (Humidity), 't' (Temperature), 'u' (Humidity)") != std::string::npos,
                 twice.error().text().c_str());
    }

    void whatNobodyWroteIsAHoleAndAGuess()
    {
        std::vector<std::int32_t> numbers = counted<std::int32_t>();
        numbers[8] = NC_FILL_INT;
        const auto dataset = read<std::int32_t>(numbers, [](NetCdfTestFile&, int) {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.type() == SampleType::Float64);
        QCOMPARE(holesOf(*dataset), (std::vector<int>{8}));
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Fill).starts_with("-2147483647, with which"));
        QVERIFY(takenOf(dataset->source.taken, TakenPart::Fill).ends_with(" ?"));
        std::vector<std::uint8_t> bytes = counted<std::uint8_t>();
        bytes[8] = 255; // of bytes every number is one
        QVERIFY(holesOf(*read<std::uint8_t>(
                            bytes, [](NetCdfTestFile&, int) {}, NC_NETCDF4))
                    .empty());
    }

    void sharedMissingCase()
    {
        const fs::path path = sharedCases() / "netcdf" / "missing_only.nc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = builtNetCdfReader().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.notFiniteCount() > 0);
        QVERIFY(dataset->values.range().minimum > 200);
        QCOMPARE(takenOf(dataset->source.taken, TakenPart::Fill), std::string("-999"));
    }

    void variablesTimesAndFurtherDimensions()
    {
        const fs::path path = folder_.path("choices.nc");
        {
            NetCdfTestFile file(path, NC_NETCDF4);
            const int t = file.dimension("time", 0), member = file.dimension("member", 3), z = file.dimension("z", 2),
                      y = file.dimension("y", 3), x = file.dimension("x", 4);
            file.add("time", {t}, std::vector<double>{6, 12}, "hours since 2000-01-01");
            file.add("surface", {t, y, x}, steps<float>(24, 0, 1));
            file.add("constant", {z, y, x}, std::vector<float>(24, 5));
            const int q = file.add("q", {t, member, z, y, x}, steps<float>(2 * 3 * 24, 0, 1), "K");
            file.numbers<float>(q, "actual_range", {0, 143});
            const int last = file.add("last", {z, y, x, t}, steps<float>(48, 0, 1));
            static_cast<void>(last);
            file.group("inner");
            file.add("deep", {z, y, x}, steps<float>(24, 0, 2));
        }
        const auto contents = builtNetCdfReader().probe(path, {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        std::vector<std::string> names;
        for (const FileArray& array : contents->arrays)
            names.push_back(array.name);
        QCOMPARE(names, (std::vector<std::string>{"constant", "q", "last", "inner/deep"}));
        QCOMPARE(contents->arrays[1].unit, std::string("K"));
        QVERIFY(contents->arrays[1].range && contents->arrays[1].range->maximum == 143);
        QCOMPARE(contents->timeSteps, (std::vector<double>{6, 12}));

        const auto automatic = builtNetCdfReader().read(path, {}, {});
        QVERIFY2(automatic.ok(), automatic.ok() ? "" : automatic.error().text().c_str());
        QCOMPARE(automatic->values.at(0), 0.);
        QCOMPARE(automatic->source.valueName, std::string("q"));
        QCOMPARE(automatic->source.taken, contents->taken);
        QCOMPARE(takenOf(automatic->source.taken, TakenPart::Array), std::string("q ?"));
        QCOMPARE(takenOf(automatic->source.taken, TakenPart::Block), std::string("member 1 of 3 ?"));
        QCOMPARE(takenOf(automatic->source.taken, TakenPart::TimeStep),
                 std::string("1 of 2, 2000-01-01 06:00 (6 hours since 2000-01-01) ?"));
        const ParameterValues choice{
            {"array", std::string("q")}, {"time", std::int64_t(2)}, {"index", std::string("member=3")}};
        const auto chosen = builtNetCdfReader().read(path, choice, {});
        QVERIFY2(chosen.ok(), chosen.ok() ? "" : chosen.error().text().c_str());
        QCOMPARE(chosen->values.at(0), 72. + 48);
        QCOMPARE(takenOf(chosen->source.taken, TakenPart::Block), std::string("member 3 of 3"));
        QCOMPARE(takenOf(chosen->source.taken, TakenPart::Array), std::string("q"));

        const auto first = [&](const char* array, std::int64_t time) {
            const auto dataset = builtNetCdfReader().read(path, {{"array", std::string(array)}, {"time", time}}, {});
            return dataset ? dataset->values.at(1) : -1;
        };
        QCOMPARE(first("last", 2), 3.); // times are the fastest
        QCOMPARE(first("inner/deep", 1), 2.);
        QCOMPARE(first("/inner/deep", 1), 2.);
        QCOMPARE(first("deep", 1), 2.);
        QCOMPARE(first("4", 1), 2.);
        for (const auto& [wrong, words] : std::vector<std::pair<ParameterValues, std::string>>{
                 {{{"array", std::string("surface")}}, "'surface' (time, y, x) does not extend along three"},
                 {{{"array", std::string("none")}}, "Choose one of these: 'constant', 'q', 'last', 'inner/deep'"},
                 {{{"time", std::int64_t(3)}, {"array", std::string("q")}}, "it has 2 time steps"},
                 {{{"index", std::string("member=4")}, {"array", std::string("q")}}, "it has 3 numbers along 'member'"},
                 {{{"index", std::string("run=1")}, {"array", std::string("q")}}, "no further dimension 'run'"},
                 {{{"index", std::string("member")}, {"array", std::string("q")}}, "is not understood"}}) {
            const auto refused = builtNetCdfReader().read(path, wrong, {});
            QVERIFY2(!refused.ok(), words.c_str());
            QVERIFY2(refused.error().kind == ErrorKind::WrongUsage, refused.error().text().c_str());
            QVERIFY2(refused.error().text().find(words) != std::string::npos, refused.error().text().c_str());
        }
    }

private:
    template <class T>
    Result<Dataset> read(const std::vector<T>& numbers, const Attributes& attributes, int mode = NC_64BIT_OFFSET)
    {
        writeNumbers<T>(folder_.path("q.nc"), numbers, attributes, mode);
        return builtNetCdfReader().read(folder_.path("q.nc"), {}, {}); // NaN in place of what is no value
    }

    /// What is told of the first of two times.
    QString timeTold(double time, const QString& units, const QString& calendar)
    {
        const fs::path path = folder_.path("times.nc");
        {
            NetCdfTestFile file(path);
            const int t = file.dimension("time", 2), z = file.dimension("z", 2), y = file.dimension("y", 2),
                      x = file.dimension("x", 2);
            const int times = file.add("time", {t}, std::vector<double>{time, time + 1}, qPrintable(units));
            if (!calendar.isEmpty())
                file.text(times, "calendar", calendar.toStdString());
            file.add("q", {t, z, y, x}, steps<float>(16, 0, 1));
        }
        const auto contents = builtNetCdfReader().probe(path, {}, {});
        return contents.ok() ? QString::fromStdString(takenOf(contents->taken, TakenPart::TimeStep))
                             : QString::fromStdString(contents.error().text());
    }

    static std::vector<int> holesOf(const Dataset& dataset)
    {
        std::vector<int> holes;
        for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
            if (!std::isfinite(dataset.values.at(point)))
                holes.push_back(int(point));
        return holes;
    }

    template <class T> void expectType(SampleType type)
    {
        const auto dataset = read<T>(
            counted<T>(), [](NetCdfTestFile&, int) {}, NC_NETCDF4);
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.type() == type);
        for (std::uint64_t point = 0; point < 27; ++point)
            QCOMPARE(dataset->values.at(point), double(point));
    }

    NetCdfFolder folder_;
};

QTEST_GUILESS_MAIN(NetCdfValuesTest)
#include "netcdf_values_test.moc"
