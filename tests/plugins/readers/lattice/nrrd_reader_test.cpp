// SPDX-License-Identifier: GPL-3.0-or-later
// Every way of writing a volume down as NRRD that is read.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QtTest>

#include <stop_token>

using namespace tetra;

namespace {

using Three = QList<double>;

Result<Dataset> readFile(const std::filesystem::path& path, const Progress& progress = {})
{
    return asLoaded<LatticeReader>().read(path, {}, progress);
}

QString textOf(const Result<Dataset>& result)
{
    return result.ok() ? QString() : QString::fromStdString(result.error().text());
}

} // namespace

class NrrdReaderTest : public QObject {
    Q_OBJECT

private slots:
    void knowsEveryTypeName_data();
    void knowsEveryTypeName();
    void readsEveryEncodingAndOrder_data();
    void readsEveryEncodingAndOrder();
    void bearsEverySpelling_data();
    void bearsEverySpelling();
    void findsTheSamples_data();
    void findsTheSamples();
    void readsDetachedData_data();
    void readsDetachedData();
    void placesTheLattice_data();
    void placesTheLattice();
    void readsText_data();
    void readsText();
    void acceptsConstantData();
    void namesTheSource();
    void isKnownByItsFirstBytes();
    void reportsProgressAndCancels();

private:
    TestFolder folder_;
};

void NrrdReaderTest::knowsEveryTypeName_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<SampleType>("type");
    const auto rows = [](SampleType type, const QList<QByteArray>& names) {
        for (const QByteArray& name : names)
            QTest::newRow(name) << name << type;
    };
    rows(SampleType::Int8, {"signed char", "int8", "int8_t"});
    rows(SampleType::UInt8, {"uchar", "unsigned char", "uint8", "uint8_t", "UINT8", "Unsigned  Char"});
    rows(SampleType::Int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"});
    rows(SampleType::UInt16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"});
    rows(SampleType::Int32, {"int", "signed int", "int32", "int32_t"});
    rows(SampleType::UInt32, {"uint", "unsigned int", "uint32", "uint32_t"});
    rows(SampleType::Float32, {"float"});
    rows(SampleType::Float64, {"double"});
}

void NrrdReaderTest::knowsEveryTypeName()
{
    QFETCH(QByteArray, name);
    QFETCH(SampleType, type);
    const auto path =
        folder_.write("type.nrrd", nrrdHeader("type: " + name + "\nendian: little\n") + testSamples(type));
    const Result<Dataset> dataset = readFile(path);
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QCOMPARE(dataset->values.type(), type);
    QVERIFY(holdsTestSamples(dataset->values));
    QCOMPARE(dataset->values.range().maximum, 59.0);
}

void NrrdReaderTest::readsEveryEncodingAndOrder_data()
{
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<bool>("big");
    QTest::addColumn<QByteArray>("encoding");
    for (int number = 0; number < 8; ++number)
        for (const bool big : {false, true})
            for (const char* encoding : {"raw", "gzip", "gz"}) {
                const auto type = static_cast<SampleType>(number);
                const QByteArray name(sampleTypeName(type).data());
                QTest::newRow(name + (big ? " big " : " little ") + encoding) << type << big << QByteArray(encoding);
            }
}

void NrrdReaderTest::readsEveryEncodingAndOrder()
{
    QFETCH(SampleType, type);
    QFETCH(bool, big);
    QFETCH(QByteArray, encoding);
    const QByteArray samples = testSamples(type, big ? std::endian::big : std::endian::little);
    const QByteArray header = nrrdHeader(QByteArray("type: ") + sampleTypeName(type).data() +
                                         "\nencoding: " + encoding + "\nendian: " + (big ? "big" : "little") + "\n");
    const auto path = folder_.write("volume.nrrd", header + (encoding == "raw" ? samples : gzipped(samples)));
    const Result<Dataset> dataset = readFile(path);
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{3, 4, 5}));
    QCOMPARE(dataset->values.type(), type);
    QVERIFY(holdsTestSamples(dataset->values));
}

void NrrdReaderTest::bearsEverySpelling_data()
{
    QTest::addColumn<QByteArray>("header");
    const QByteArray usual = "dimension: 3\nsizes: 3 4 5\ntype: uint8\nencoding: raw\n";
    for (const char version : {'1', '2', '3', '4', '5'})
        QTest::newRow(QByteArray("version ") + version) << QByteArray("NRRD000") + version + "\n" + usual + "\n";
    const QByteArray magic = "NRRD0005\n";
    QTest::newRow("comments") << magic + "# one\n#two: 3\n" + usual + "#\n\n";
    QTest::newRow("key and value") << magic + "my key:=any: value\n" + usual + "sizes:=not the field\n\n";
    QTest::newRow("CR LF") << QByteArray(magic + usual + "\n").replace("\n", "\r\n");
    QTest::newRow("capitals") << magic + "Dimension: 3\nSIZES: 3 4 5\nType: uint8\nencoding: RAW\n\n";
    QTest::newRow("any order") << magic + "encoding: raw\ntype: uint8\nsizes: 3 4 5\ndimension: 3\n\n";
    QTest::newRow("blanks") << magic + "dimension:   3 \nsizes:\t3  4\t5  \ntype: uint8\nencoding: raw\n\n";
    QTest::newRow("no blank") << magic + "dimension:3\nsizes:3 4 5\ntype:uint8\nencoding:raw\n\n";
    QTest::newRow("fields of no use here")
        << magic + usual +
               "content: me\nmin: 0\nmax: 1\nold min: 0\noldmax: 3\nsample units: \"K\"\n"
               "labels: \"x\" \"y y\" \"z\"\nunits: \"mm\" \"mm\" \"mm\"\nthicknesses: 1 nan 1\n"
               "space: left-posterior-superior\nspace units: \"mm\" \"mm\" \"mm\"\n"
               "measurement frame: (1,0,0) (0,1,0) (0,0,1)\nnumber: 60\nblock size: 1\n\n";
    QTest::newRow("four dimensions") << magic + "dimension: 4\nsizes: 1 3 4 5\ntype: uint8\nencoding: raw\n"
                                                "kinds: vector domain domain domain\nspacings: nan 1 1 1\n\n";
    QTest::newRow("five dimensions") << magic + "dimension: 5\nsizes: 3 1 4 5 1\ntype: uint8\nencoding: raw\n\n";
    QTest::newRow("kinds") << magic + usual + "kinds: domain space time\n\n";
    QTest::newRow("unknown kinds") << magic + usual + "kinds: ??? none domain\n\n";
    QTest::newRow("needless endian") << magic + usual + "endian: big\n\n";
}

void NrrdReaderTest::bearsEverySpelling()
{
    QFETCH(QByteArray, header);
    const Result<Dataset> dataset = readFile(folder_.write("spelling.nrrd", header + testSamples(SampleType::UInt8)));
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QVERIFY(holdsTestSamples(dataset->values));
    QCOMPARE(dataset->lattice.spacing, Eigen::Vector3d(1, 1, 1));
}

void NrrdReaderTest::findsTheSamples_data()
{
    QTest::addColumn<QByteArray>("file");
    const QByteArray samples = testSamples(SampleType::UInt8);
    QTest::newRow("line skip") << nrrdHeader("line skip: 2\n") + "one\ntwo\n" + samples;
    QTest::newRow("byte skip") << nrrdHeader("byteskip: 5\n") + "12345" + samples;
    QTest::newRow("both skips") << nrrdHeader("lineskip: 1\nbyte skip: 3\n") + "a line\n123" + samples;
    QTest::newRow("at the end") << nrrdHeader("byte skip: -1\n") + "whatever stands here" + samples;
    QTest::newRow("at the end, nothing before") << nrrdHeader("byte skip: -1\n") + samples;
    const QByteArray gzip = "encoding: gzip\n";
    QTest::newRow("gzip") << nrrdHeader(gzip) + gzipped(samples);
    QTest::newRow("gzip, several members")
        << nrrdHeader(gzip) + gzipped(samples.left(7)) + gzipped("") + gzipped(samples.mid(7));
    QTest::newRow("gzip, padded") << nrrdHeader(gzip) + gzipped(samples) + QByteArray(100, '\0');
    QTest::newRow("gzip, line skip") << nrrdHeader(gzip + "line skip: 1\n") + "packed:\n" + gzipped(samples);
    QTest::newRow("gzip, byte skip") << nrrdHeader(gzip + "byte skip: 4\n") + gzipped("1234" + samples);
}

void NrrdReaderTest::findsTheSamples()
{
    QFETCH(QByteArray, file);
    const Result<Dataset> dataset = readFile(folder_.write("skips.nrrd", file));
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QVERIFY(holdsTestSamples(dataset->values));
}

void NrrdReaderTest::readsDetachedData_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("field");
    QTest::addColumn<QByteArray>("ending");
    QTest::newRow("plain") << QByteArray("data.raw") << QByteArray("data file: data.raw\n") << QByteArray("");
    QTest::newRow("empty line at the end")
        << QByteArray("data.raw") << QByteArray("data file: data.raw\n") << QByteArray("\n");
    QTest::newRow("old spelling") << QByteArray("data.raw") << QByteArray("datafile: data.raw\n") << QByteArray("");
    QTest::newRow("dot") << QByteArray("data.raw") << QByteArray("data file: ./data.raw\n") << QByteArray("");
    QTest::newRow("blanks in the name") << QByteArray("the data 1 2 3.raw")
                                        << QByteArray("data file: the data 1 2 3.raw\n") << QByteArray("");
    QTest::newRow("not ASCII") << QByteArray("d\u00e4ta.raw") << QByteArray("data file: d\u00e4ta.raw\n")
                               << QByteArray("");
    QTest::newRow("CR LF") << QByteArray("data.raw") << QByteArray("data file: data.raw\r\n") << QByteArray("\r\n");
    QTest::newRow("absolute") << QByteArray("data.raw")
                              << "data file: " + QByteArray::fromStdString((folder_.path() / "data.raw").string()) +
                                     "\n"
                              << QByteArray("");
}

void NrrdReaderTest::readsDetachedData()
{
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, field);
    QFETCH(QByteArray, ending);
    folder_.write(name, testSamples(SampleType::UInt8));
    QByteArray header = nrrdHeader(field);
    header.chop(1);
    const Result<Dataset> dataset = readFile(folder_.write("detached.nhdr", header + ending));
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QVERIFY(holdsTestSamples(dataset->values));
    QCOMPARE(dataset->source.name, std::string("detached.nhdr"));
}

void NrrdReaderTest::placesTheLattice_data()
{
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<Three>("spacing");
    QTest::addColumn<Three>("origin");
    const auto row = [](const char* name, const QByteArray& fields, const Three& spacing, const Three& origin) {
        QTest::newRow(name) << fields << spacing << origin;
    };
    const Three one = {1, 1, 1};
    const Three zero = {0, 0, 0};
    row("nothing", "", one, zero);
    row("spacings", "spacings: 0.5 1 2.25\n", {0.5, 1, 2.25}, zero);
    row("unknown spacings", "spacings: nan nan NaN\n", one, zero);
    row("axis mins", "spacings: 1 2 3\naxis mins: -1 10 0.5\n", {1, 2, 3}, {-1, 10, 0.5});
    row("axis mins of cells", "spacings: 1 2 3\naxismins: 0 0 0\ncenters: cell cell node\n", {1, 2, 3}, {0.5, 1, 0});
    row("axis mins and maxs", "axis mins: 0 0 0\naxis maxs: 1 6 2\n", {0.5, 2, 0.5}, zero);
    row("mins and maxs of cells", "axis mins: 0 0 0\naxis maxs: 6 4 10\ncenterings: cell cell cell\n", {2, 1, 2},
        {1, 0.5, 1});
    row("space directions",
        "space dimension: 3\nspace directions: (0.5,0,0) (0,0.1,0) (0,0,3)\nspace origin: (1,2,-3)\n", {0.5, 0.1, 3},
        {1, 2, -3});
    row("blanks in vectors", "space directions: ( 2, 0 ,0 )(0,3,0)   (0,0,4)\nspace origin: ( 1 , 2 , 3 )\n", {2, 3, 4},
        {1, 2, 3});
    row("axes exchanged", "space directions: (0,2,0) (0,0,3) (4,0,0)\nspace origin: (10,20,30)\n", {2, 3, 4},
        {10, 20, 30});
    row("turned", "space directions: (3,4,0) (-4,3,0) (0,0,1)\nspace origin: (5,0,7)\n", {5, 5, 1}, {5, 0, 7});
    row("unknown origin", "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (nan,nan,nan)\n", one, zero);
    row("origin without directions", "spacings: 1 1 2\nspace origin: (1,2,3)\n", {1, 1, 2}, {1, 2, 3});
}

void NrrdReaderTest::placesTheLattice()
{
    QFETCH(QByteArray, fields);
    QFETCH(Three, spacing);
    QFETCH(Three, origin);
    const Result<Dataset> dataset =
        readFile(folder_.write("placed.nrrd", nrrdHeader(fields) + testSamples(SampleType::UInt8)));
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    for (int axis = 0; axis < 3; ++axis) {
        QCOMPARE(dataset->lattice.spacing[axis], spacing[axis]);
        QCOMPARE(dataset->lattice.origin[axis] + 1, origin[axis] + 1); // QCOMPARE knows no tolerance at 0
    }
}

void NrrdReaderTest::readsText_data()
{
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Three>("values");
    const auto row = [](const char* name, const char* type, const char* text, const Three& values) {
        QTest::newRow(name) << QByteArray(type) << QByteArray(text) << values;
    };
    row("lines", "uint8", "1 2\n3 4\r\n\n5 6 7\t8\n", {1, 2, 3, 4, 5, 6, 7, 8});
    row("commas", "int16", "-1,2,-3, 4 , 5,6,7,-32768", {-1, 2, -3, 4, 5, 6, 7, -32768});
    row("fractions", "float", "1.5 -2.25 1e3 .5 5. +1 0 1e-60", {1.5, -2.25, 1000, 0.5, 5, 1, 0, 0});
    row("doubles", "double", "1e300 1 2 3 4 5 6 0.1", {1e300, 1, 2, 3, 4, 5, 6, 0.1});
    row("limits", "uint32", "4294967295 0 0 0 0 0 0 1", {4294967295.0, 0, 0, 0, 0, 0, 0, 1});
}

void NrrdReaderTest::readsText()
{
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, text);
    QFETCH(Three, values);
    for (const char* encoding : {"ascii", "text", "txt"}) {
        const QByteArray header = nrrdHeader("sizes: 2 2 2\ntype: " + type + "\nencoding: " + encoding + "\n");
        const Result<Dataset> dataset = readFile(folder_.write("text.nrrd", header + text));
        QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
        for (int n = 0; n < 8; ++n)
            QCOMPARE(dataset->values.at(static_cast<std::uint64_t>(n)), values[n]);
    }
}

void NrrdReaderTest::acceptsConstantData()
{
    const Result<Dataset> dataset =
        readFile(folder_.write("constant.nrrd", nrrdHeader("") + QByteArray(testPoints, 7)));
    QVERIFY2(dataset.ok(), qPrintable(textOf(dataset)));
    QCOMPARE(dataset->values.range().extent(), 0.0);
}

void NrrdReaderTest::namesTheSource()
{
    const QByteArray samples = testSamples(SampleType::UInt8);
    const auto raw = folder_.write("a.nrrd", nrrdHeader("") + samples);
    const auto packed = folder_.write("b.nrrd", nrrdHeader("encoding: gzip\n") + gzipped(samples));
    const Result<Dataset> first = readFile(raw);
    const Result<Dataset> second = readFile(packed);
    QCOMPARE(first->source.path, raw);
    QCOMPARE(first->source.name, std::string("a.nrrd"));
    QVERIFY(first->source.hash != 0);
    QCOMPARE(quint64(first->source.hash), quint64(second->source.hash)); // of the samples, not of the file
}

void NrrdReaderTest::isKnownByItsFirstBytes()
{
    const QByteArray nrrd = "NRRD0004\n";
    const auto bytes = std::as_bytes(std::span(nrrd.data(), static_cast<std::size_t>(nrrd.size())));
    const LatticeReader reader;
    QCOMPARE(reader.score("any.name", bytes), 1.0);
    QVERIFY(reader.score("volume.NHDR", {}) > 0.5);
    QVERIFY(reader.score("volume.raw", {}) > 0 && reader.score("volume.raw", {}) < 0.5);
    QCOMPARE(reader.score("picture.png", {}), 0.0);
    QVERIFY(!reader.nameFilters().empty());
}

void NrrdReaderTest::reportsProgressAndCancels()
{
    for (const QByteArray encoding : {"raw", "gzip", "ascii"}) {
        constexpr qsizetype points = 2097152; // 128^3
        QByteArray samples(points * 4, '\1');
        if (encoding == "gzip")
            samples = gzipped(samples);
        if (encoding == "ascii")
            samples = QByteArray("1 ").repeated(points);
        const auto path = folder_.write(
            "long.nrrd",
            nrrdHeader("sizes: 128 128 128\ntype: int\nendian: little\nencoding: " + encoding + "\n") + samples);
        double last = 0;
        int reports = 0;
        bool monotonic = true;
        const auto watch = [&](double fraction, const Message& activity) {
            monotonic = monotonic && fraction >= last && fraction <= 1 && !activity.empty();
            last = fraction;
            ++reports;
        };
        QVERIFY(readFile(path, Progress({}, watch)).ok());
        QVERIFY(monotonic && reports >= 3);
        QCOMPARE(last, 1.0);

        std::stop_source stop;
        const auto stopAfterTheFirst = [&](double, const Message&) { stop.request_stop(); };
        const Result<Dataset> stopped = readFile(path, Progress(stop.get_token(), stopAfterTheFirst));
        QVERIFY(!stopped.ok());
        QCOMPARE(stopped.error().kind, ErrorKind::Cancelled);
    }
}

QTEST_GUILESS_MAIN(NrrdReaderTest)
#include "nrrd_reader_test.moc"
