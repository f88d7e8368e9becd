// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays in HDF5 files by their paths: their numbers as they were written, whatever their type and storage, and what
// was taken of several arrays, steps, channels and components is told (D3, S20).
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/hdf5/hdf5_test_files.h"

#include <QTest>

#include <cmath>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

const std::vector<hsize_t> cube = {3, 4, 5};

std::vector<double> valuesOf(const Dataset& dataset)
{
    std::vector<double> values;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        values.push_back(dataset.values.at(point));
    return values;
}

} // namespace

class Hdf5ArraysTest : public QObject {
    Q_OBJECT

private slots:
    void typesAndStorages_data()
    {
        QTest::addColumn<qint64>("inFile");
        QTest::addColumn<int>("type");
        int count = 0;
        const auto row = [&count](const char* name, hid_t inFile, SampleType type) {
            constexpr std::array storages = {"in one piece", "in chunks", "packed"}; // in turn
            QTest::addRow("%s, %s", name, storages[std::size_t(count++ % 3)]) << qint64(inFile) << int(type);
        };
        row("int8", H5T_STD_I8LE, SampleType::Int8);
        row("uint8", H5T_STD_U8BE, SampleType::UInt8);
        row("int16", H5T_STD_I16BE, SampleType::Int16);
        row("uint16", H5T_STD_U16LE, SampleType::UInt16);
        row("int32", H5T_STD_I32BE, SampleType::Int32);
        row("uint32", H5T_STD_U32LE, SampleType::UInt32);
        row("int64", H5T_STD_I64LE, SampleType::Int32);
        row("uint64", H5T_STD_U64BE, SampleType::Int32);
        row("float", H5T_IEEE_F32BE, SampleType::Float32);
        row("float", H5T_IEEE_F32LE, SampleType::Float32);
        row("float", H5T_IEEE_F32LE, SampleType::Float32);
        row("double", H5T_IEEE_F64LE, SampleType::Float64);
    }
    void typesAndStorages()
    {
        QFETCH(qint64, inFile);
        QFETCH(int, type);
        const QByteArray tag = QTest::currentDataTag();
        Hdf5Storage storage{.type = hid_t(inFile)};
        if (!tag.endsWith("in one piece"))
            storage.chunk = {2, 3, 4};
        storage.isPacked = tag.endsWith("packed");
        const auto values = steps<double>(60, 1, 1);
        const Dataset dataset =
            read([&](Hdf5TestFile& file) { file.add<double>("/fields/density", cube, values, storage); });
        QCOMPARE(int(dataset.values.type()), type);
        QCOMPARE(dataset.lattice.size, (std::array<std::uint32_t, 3>{5, 4, 3}));
        QCOMPARE(valuesOf(dataset), values);
        QCOMPARE(dataset.source.valueName, std::string("/fields/density"));
        QCOMPARE(takenOf(dataset.source.taken, TakenPart::Array), std::string());
        QCOMPARE(takenOf(dataset.source.taken, TakenPart::Places),
                 std::string("axes z, y, x: the last one runs fastest ?"));
    }

    void halfPrecisionFloats()
    {
        const hid_t half = H5Tcopy(H5T_IEEE_F32LE); // as NumPy's float16
        mustBeDone(H5Tset_fields(half, 15, 10, 5, 0, 10) >= 0 && H5Tset_size(half, 2) >= 0 &&
                   H5Tset_ebias(half, 15) >= 0);
        const auto values = steps<double>(60, -2, 0.0625);
        const Dataset dataset = read([&](Hdf5TestFile& file) { file.add<double>("/a", cube, values, {.type = half}); });
        H5Tclose(half);
        QCOMPARE(dataset.values.type(), SampleType::Float32);
        QCOMPARE(valuesOf(dataset), values);
    }

    void wideIntegersBecomeDoubles()
    {
        auto numbers = steps<std::int64_t>(60, 0, 1);
        numbers[7] = std::int64_t(1) << 40;
        const Dataset dataset = read([&](Hdf5TestFile& file) { file.add<std::int64_t>("/a", cube, numbers); });
        QCOMPARE(dataset.values.type(), SampleType::Float64);
        QCOMPARE(dataset.values.at(7), std::ldexp(1.0, 40));
        QVERIFY2(textOf(dataset.remarks).find("64-bit") != std::string::npos, textOf(dataset.remarks).c_str());
    }

    void truthValues()
    {
        const hid_t boolean = H5Tenum_create(H5T_NATIVE_INT8); // as h5py writes NumPy's
        for (const std::int8_t value : {0, 1})
            H5Tenum_insert(boolean, value == 0 ? "FALSE" : "TRUE", &value);
        std::vector<std::int8_t> values(60);
        for (std::size_t at = 0; at < 60; at += 7)
            values[at] = 1;
        const Dataset dataset = read([&](Hdf5TestFile& file) {
            file.define("/mask", cube, {.type = boolean});
            file.write("/mask", boolean, values.data());
        });
        H5Tclose(boolean);
        QCOMPARE(dataset.values.at(14), 1.);
        QCOMPARE(dataset.values.at(15), 0.);
    }

    void complexNumbers()
    {
        const hid_t complex = H5Tcreate(H5T_COMPOUND, 16);
        mustBeDone(H5Tinsert(complex, "r", 0, H5T_NATIVE_DOUBLE) >= 0 &&
                   H5Tinsert(complex, "i", 8, H5T_NATIVE_DOUBLE) >= 0);
        std::vector<double> pairs;
        for (int at = 0; at < 60; ++at)
            pairs.insert(pairs.end(), {3. * at, 4. * at});
        write([&](Hdf5TestFile& file) {
            file.define("/psi", cube, {.type = complex});
            file.write("/psi", complex, pairs.data());
        });
        H5Tclose(complex);
        expect({}, steps<double>(60, 0, 5), TakenPart::Component, "magnitude of 2 ?");
        expect({{"component", std::string("0")}}, steps<double>(60, 0, 3), TakenPart::Component, "0 of 2, from 0: r");
        expect({{"component", std::string("1")}}, steps<double>(60, 0, 4), TakenPart::Component, "1 of 2, from 0: i");
        refuse({{"component", std::string("2")}}, "components, counted from 0");
    }

    void elementsThatAreArrays()
    {
        const hsize_t two = 2;
        const hid_t pair = H5Tarray_create2(H5T_NATIVE_INT16, 1, &two);
        std::vector<std::int16_t> pairs;
        for (int at = 0; at < 60; ++at)
            pairs.insert(pairs.end(), {std::int16_t(at), std::int16_t(-at)});
        write([&](Hdf5TestFile& file) {
            file.define("/v", cube, {.type = pair});
            file.write("/v", pair, pairs.data());
        });
        H5Tclose(pair);
        expect({{"component", std::string("1")}}, steps<double>(60, 0, -1), TakenPart::Component, "1 of 2, from 0");
    }

    void oneOfSeveral()
    {
        write([](Hdf5TestFile& file) {
            file.add<float>("/aaa", {2, 2, 2}, steps<float>(8, 100, 1));
            file.add<float>("/fields/density", cube, steps<float>(60, 0, 1));
            file.add<float>("/fields/zzz", {3, 4, 4}, steps<float>(48, 200, 1));
            file.add<float>("/table", {100, 100}, steps<float>(10000, 0, 1));
            file.texts("/fields/density", "units", {"kg m-3"});
        });
        const auto wanted = steps<double>(60, 0, 1);
        expect({}, wanted, TakenPart::Array, "/fields/density ?");
        for (const char* name : {"/fields/density", "fields/density", "density", "2"})
            expect({{"array", std::string(name)}}, wanted, TakenPart::Array, "/fields/density");
        expect({{"array", std::string("/aaa")}}, steps<double>(8, 100, 1), TakenPart::Array, "/aaa");
        refuse({{"array", std::string("/nothing")}}, "'/fields/zzz' (3 x 4 x 4, float)");
        refuse({{"array", std::string("/table")}}, "does not extend along three dimensions");
        const auto contents = builtHdf5Reader().probe(path(), {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->arrays.size(), std::size_t(3));
        QCOMPARE(contents->arrays[1].name, std::string("/fields/density"));
        QCOMPARE(contents->arrays[1].unit, std::string("kg m-3"));
        QCOMPARE(contents->points, std::uint64_t(60));
        QVERIFY(textOf(contents->leftOut).find("'/aaa' (2 x 2 x 2, float)") != std::string::npos);
    }

    void linksInsideTheFile()
    {
        write([](Hdf5TestFile& file) {
            file.add<float>("/a", cube, steps<float>(60, 0, 1));
            file.group("/g");
            mustBeDone(H5Lcreate_hard(file.id(), "/", file.id(), "/g/up", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
                       H5Lcreate_hard(file.id(), "/a", file.id(), "/g/same", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
                       H5Lcreate_soft("/g/same", file.id(), "/latest", H5P_DEFAULT, H5P_DEFAULT) >= 0 &&
                       H5Lcreate_soft("/round", file.id(), "/round", H5P_DEFAULT, H5P_DEFAULT) >= 0);
        });
        expect({}, steps<double>(60, 0, 1), TakenPart::Array, "");
        expect({{"array", std::string("/latest")}}, steps<double>(60, 0, 1), TakenPart::Array, "");
        expect({{"array", std::string("/g/up/g/up/a")}}, steps<double>(60, 0, 1), TakenPart::Array, "");
        refuse({{"array", std::string("/round")}}, "it has no array '/round'");
    }

    void stepsAndChannels_data()
    {
        QTest::addColumn<QString>("names"); // of four dimensions
        QTest::addColumn<QString>("time");
        QTest::addColumn<QString>("channel");
        QTest::newRow("no names") << ""
                                  << "2 of 2 ?"
                                  << "";
        QTest::newRow("time") << "time z y x"
                              << "2 of 2"
                              << "";
        QTest::newRow("channels") << "c z y x"
                                  << ""
                                  << "2 of 2";
    }
    void stepsAndChannels()
    {
        QFETCH(QString, names);
        QFETCH(QString, time);
        QFETCH(QString, channel);
        write([&](Hdf5TestFile& file) {
            file.add<float>("/a", {2, 3, 4, 5}, steps<float>(120, 0, 1));
            std::vector<std::string> labels;
            for (const QString& name : names.split(' '))
                labels.push_back(name.toStdString());
            if (labels.size() == 4)
                file.texts("/a", "DIMENSION_LABELS", labels);
        });
        const ParameterValues second = channel.isEmpty() ? ParameterValues{{"time", std::int64_t(2)}}
                                                         : ParameterValues{{"channel", std::string("2")}};
        const Dataset dataset = expect(second, steps<double>(60, 60, 1), TakenPart::TimeStep, time.toStdString());
        QCOMPARE(takenOf(dataset.source.taken, TakenPart::Channel), channel.toStdString());
        expect({}, steps<double>(60, 0, 1), TakenPart::Array, "");
        refuse({{"time", std::int64_t(3)}}, "and number 3 was requested.");
    }

    void fewEntriesAtTheEndAreComponents()
    {
        write([](Hdf5TestFile& file) { file.add<double>("/v", {3, 4, 5, 2}, steps<double>(120, 0, 1)); });
        expect({{"component", std::string("1")}}, steps<double>(60, 1, 2), TakenPart::Component, "1 of 2, from 0 ?");
        const Dataset whole = read({});
        QCOMPARE(takenOf(whole.source.taken, TakenPart::Component), std::string("magnitude of 2 ?"));
        QCOMPARE(whole.values.at(3), std::hypot(6., 7.));
    }

    void dimensionsOfOneAndFurtherOnes()
    {
        write([](Hdf5TestFile& file) {
            file.add<float>("/ilastik", {1, 3, 4, 5, 1}, steps<float>(60, 0, 1));
            file.texts("/ilastik", "axistags",
                       {R"({"axes": [{"key": "t"}, {"key": "z"}, {"key": "y"}, {"key": "x"}, {"key": "c"}]})"});
            file.add<float>("/five", {2, 3, 3, 4, 5}, steps<float>(360, 0, 1));
        });
        const Dataset ilastik =
            expect({{"array", std::string("/ilastik")}}, steps<double>(60, 0, 1), TakenPart::TimeStep, "");
        QCOMPARE(takenOf(ilastik.source.taken, TakenPart::Places), std::string("x, y, z"));
        const ParameterValues values{
            {"array", std::string("/five")}, {"time", std::int64_t(2)}, {"index", std::string("d2=3")}};
        const Dataset five = expect(values, steps<double>(60, 300, 1), TakenPart::Block, "d2 3 of 3");
        QCOMPARE(takenOf(five.source.taken, TakenPart::TimeStep), std::string("2 of 2 ?"));
        refuse({{"array", std::string("/five")}, {"index", std::string("d2=4")}}, "numbers along 'd2'");
        refuse({{"array", std::string("/five")}, {"index", std::string("d3=1")}}, "no further dimension 'd3'");
    }

    void whatNeXusShows()
    {
        write([](Hdf5TestFile& file) {
            file.add<float>("/entry/data/counts", cube, steps<float>(60, 0, 1));
            file.add<float>("/entry/detector/raw", {4, 5, 6}, steps<float>(120, 0, 1));
            file.texts("/entry/data", "signal", {"counts"});
        });
        expect({}, steps<double>(60, 0, 1), TakenPart::Array, "/entry/data/counts");
    }

    void whatIsNoValue()
    {
        write([](Hdf5TestFile& file) {
            file.add<std::int16_t>("/said", cube, steps<std::int16_t>(60, 0, 1));
            file.numbers<std::int16_t>("/said", "_FillValue", {4});
            file.numbers<std::int16_t>("/said", "valid_range", {0, 50});
            file.add<float>("/given", cube, steps<float>(60, 0, 1), {.fill = {7}});
            file.add<std::int16_t>("/scaled", cube, steps<std::int16_t>(60, 0, 1));
            file.numbers<double>("/scaled", "scale_factor", {0.25});
            file.numbers<double>("/scaled", "add_offset", {-3});
            file.numbers<std::int16_t>("/scaled", "missing_value", {5});
        });
        const Dataset said = expectHole("/said", 4, "4");
        QVERIFY(textOf(said.source.leftOut).find("'valid_range', which is not used") != std::string::npos);
        expectHole("/given", 7, "7, the array's fill value ?");
        const Dataset scaled = expectHole("/scaled", 5, "5");
        QCOMPARE(scaled.values.at(8), 8 * 0.25 - 3);
    }

    /// Chunks that nobody wrote have the fill value, which is told; where it was given it stands for no value.
    void chunksThatNobodyWrote()
    {
        write([](Hdf5TestFile& file) {
            writeFirstChunk(file, "/zeros", {});
            writeFirstChunk(file, "/given", {-9});
        });
        const Dataset zeros = read({{"array", std::string("/zeros")}});
        QCOMPARE(zeros.values.at(1), 2.);
        QCOMPARE(zeros.values.at(63), 0.);
        QCOMPARE(takenOf(zeros.source.taken, TakenPart::Fill),
                 std::string("0 in 7 of 8 chunks, which were never written ?"));
        const Dataset given = read({{"array", std::string("/given")}});
        QCOMPARE(given.values.at(1), 2.);
        QCOMPARE(given.values.notFiniteCount(), std::uint64_t(56));
        QCOMPARE(takenOf(given.source.taken, TakenPart::Fill), std::string("-9, the array's fill value ?"));
    }

    /// Bytes made by hand: nine of them, then a copy that reaches into itself.
    void packedByLzf()
    {
        const QByteArray packed("\x08\x00\x01\x02\x03\x04\x05\x06\x07\x08\xe0\x09\x08", 13);
        writeLzf(packed);
        const Dataset dataset = read(ParameterValues{});
        for (std::uint64_t point = 0; point < 27; ++point)
            QCOMPARE(dataset.values.at(point), double(point % 9));
        QByteArray farBack = packed;
        farBack[12] = 9;
        for (const QByteArray& damaged : {packed.left(12), packed.left(11), packed.left(10), packed.left(5), farBack}) {
            writeLzf(damaged);
            refuse({}, nullptr);
        }
    }

    void behindABlockOfTheUser()
    {
        {
            Hdf5TestFile file(path(), 512); // as MATLAB writes it
            file.add<double>("/a", cube, steps<double>(60, 0, 1));
        }
        expect({}, steps<double>(60, 0, 1), TakenPart::Array, "");
    }

private:
    static std::size_t notRun(unsigned, std::size_t, const unsigned[], std::size_t, std::size_t*, void**) { return 0; }

    void writeLzf(const QByteArray& packed) const
    {
        const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, 32000, 1, 1, "lzf", nullptr, nullptr, notRun};
        mustBeDone(H5Zregister(&filter) >= 0);
        {
            const Hdf5TestFile file(path());
            const hsize_t size[] = {3, 3, 3}, first[] = {0, 0, 0};
            const unsigned numbers[] = {4, 0x105, 27};
            const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(3, size, nullptr);
            mustBeDone(H5Pset_chunk(creation, 3, size) >= 0 && H5Pset_filter(creation, 32000, 0, 3, numbers) >= 0);
            const hid_t array =
                H5Dcreate2(file.id(), "/a", H5T_NATIVE_UINT8, space, H5P_DEFAULT, creation, H5P_DEFAULT);
            mustBeDone(H5Dwrite_chunk(array, H5P_DEFAULT, 0, first, std::size_t(packed.size()), packed.constData()) >=
                       0);
            H5Dclose(array);
            H5Sclose(space);
            H5Pclose(creation);
        }
        H5Zunregister(32000);
    }

    static void writeFirstChunk(Hdf5TestFile& file, const char* name, const std::vector<double>& fill)
    {
        file.define(name, {4, 4, 4}, {.type = H5T_NATIVE_FLOAT, .chunk = {2, 2, 2}, .fill = fill});
        const hid_t array = H5Dopen2(file.id(), name, H5P_DEFAULT);
        const auto values = steps<float>(8, 1, 1);
        const hsize_t first[] = {0, 0, 0};
        mustBeDone(H5Dwrite_chunk(array, H5P_DEFAULT, 0, first, 32, values.data()) >= 0);
        H5Dclose(array);
    }

    fs::path path() const { return folder_.path("file.h5"); }

    template <class Write> void write(const Write& write) const requires std::is_invocable_v<Write, Hdf5TestFile&>
    {
        Hdf5TestFile file(path());
        write(file);
    }

    Dataset read(const ParameterValues& values) const
    {
        const auto dataset = builtHdf5Reader().read(path(), values, {});
        if (!dataset)
            qFatal("%s", dataset.error().text().c_str());
        return *dataset;
    }

    template <class Write> Dataset read(const Write& write) const requires std::is_invocable_v<Write, Hdf5TestFile&>
    {
        this->write(write);
        return read(ParameterValues{});
    }

    /// These values, and this told of a part, by read() and by probe().
    Dataset expect(const ParameterValues& values, const std::vector<double>& numbers, TakenPart part,
                   const std::string& told) const
    {
        Dataset dataset = read(values);
        const auto contents = builtHdf5Reader().probe(path(), values, {});
        [&] {
            QCOMPARE(valuesOf(dataset), numbers);
            QCOMPARE(takenOf(dataset.source.taken, part), told);
            QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
            QVERIFY(contents->taken == dataset.source.taken);
            QVERIFY(contents->leftOut == dataset.source.leftOut);
            QCOMPARE(contents->lattice.size, dataset.lattice.size);
        }();
        return dataset;
    }

    Dataset expectHole(const char* array, std::uint64_t hole, const std::string& told) const
    {
        Dataset dataset = read({{"array", std::string(array)}});
        [&] {
            QCOMPARE(dataset.values.notFiniteCount(), std::uint64_t(1));
            QVERIFY(std::isnan(dataset.values.at(hole)));
            QCOMPARE(takenOf(dataset.source.taken, TakenPart::Fill), told);
        }();
        return dataset;
    }

    /// With these words, by read() and by probe(); damaged numbers, without words, by read() alone.
    void refuse(const ParameterValues& values, const char* words) const
    {
        const auto dataset = builtHdf5Reader().read(path(), values, {});
        QVERIFY(!dataset.ok());
        if (words == nullptr)
            return;
        QVERIFY2(dataset.error().text().find(words) != std::string::npos, dataset.error().text().c_str());
        const auto probed = builtHdf5Reader().probe(path(), values, {});
        QVERIFY(!probed.ok());
        QCOMPARE(probed.error().text(), dataset.error().text());
    }

    Hdf5Folder folder_;
};

QTEST_GUILESS_MAIN(Hdf5ArraysTest)
#include "hdf5_arrays_test.moc"
