// SPDX-License-Identifier: GPL-3.0-or-later
// Values of NetCDF variables are what the attributes make of the stored numbers: fill values and limits are held
// against these before they are scaled; and what is taken of a file is told (D3, S20).
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

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
                 std::string("1 of 2, time 6 (hours since 2000-01-01) ?"));
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
