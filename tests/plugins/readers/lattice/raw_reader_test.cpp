// SPDX-License-Identifier: GPL-3.0-or-later
// Raw files: what the user's description makes of them, and what is said when it does not fit.
#include "plugins/readers/lattice/lattice_reader.h"
#include "plugins/readers/lattice/raw/raw_guess.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QtTest>

#include <limits>

using namespace tetra;

namespace {

QStringList guessTexts(std::string_view name, std::uint64_t bytes)
{
    QStringList texts;
    for (const RawGuess& guess : guessRawLayouts(name, bytes))
        texts << QString("%1x%2x%3 %4")
                     .arg(guess.size[0])
                     .arg(guess.size[1])
                     .arg(guess.size[2])
                     .arg(QString::fromUtf8(sampleTypeName(guess.type).data()));
    return texts;
}

} // namespace

class RawReaderTest : public QObject {
    Q_OBJECT

private slots:
    void describesItsParameters();
    void readsEveryTypeAndOrder_data();
    void readsEveryTypeAndOrder();
    void placesTheLattice();
    void skipsAHeader();
    void staysInItsFileWhereItCan_data();
    void staysInItsFileWhereItCan();
    void knowsThatItsFileWasCut();
    void refuses_data();
    void refuses();
    void guesses_data();
    void guesses();
    void guessesFillTheFile();
    void probesWithoutTheSamples();

private:
    TestFolder folder_;
};

void RawReaderTest::describesItsParameters()
{
    const std::vector<Parameter> parameters = asLoaded<LatticeReader>().parameters();
    QStringList ids;
    for (const Parameter& parameter : parameters) {
        ids << QString::fromStdString(parameter.id);
        QVERIFY(!parameter.label.empty() && parameter.explanation.ends_with('.'));
    }
    QCOMPARE(ids, QStringList({"size", "type", "byte-order", "skip", "spacing", "origin", "unit", "array", "component",
                               "time", "axes"}));
}

void RawReaderTest::readsEveryTypeAndOrder_data()
{
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<bool>("big");
    for (int number = 0; number < 8; ++number)
        for (const bool big : {false, true}) {
            const auto type = static_cast<SampleType>(number);
            QTest::newRow(QByteArray(sampleTypeName(type).data()) + (big ? " big" : " little")) << type << big;
        }
}

void RawReaderTest::readsEveryTypeAndOrder()
{
    QFETCH(SampleType, type);
    QFETCH(bool, big);
    const auto path = folder_.write("volume.raw", testSamples(type, big ? std::endian::big : std::endian::little));
    const ParameterValues values = {{"size", std::string("3x4x5")},
                                    {"type", std::string(sampleTypeName(type))},
                                    {"byte-order", std::string(big ? "big" : "little")}};
    const Result<Dataset> dataset = asLoaded<LatticeReader>().read(path, values, {});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{3, 4, 5}));
    QCOMPARE(dataset->lattice.spacing, Eigen::Vector3d(1, 1, 1));
    QCOMPARE(dataset->lattice.origin, Eigen::Vector3d(0, 0, 0));
    QCOMPARE(dataset->values.type(), type);
    QVERIFY(holdsTestSamples(dataset->values));
    QCOMPARE(dataset->remarks.size(), std::size_t(1));
    QVERIFY(dataset->remarks[0].text().find("1 x 1 x 1 is assumed") != std::string::npos);
}

void RawReaderTest::placesTheLattice()
{
    const auto path = folder_.write("placed.raw", testSamples(SampleType::UInt8));
    for (const char* size : {"3x4x5", "3X4X5", "3,4,5", " 3 4  5 ", "3*4*5", "3 x 4 x 5"}) {
        const Result<Dataset> dataset = asLoaded<LatticeReader>().read(path,
                                                                       {{"size", std::string(size)},
                                                                        {"spacing", std::string("1x2x0.5")},
                                                                        {"origin", std::string("-1, 1e2, .5")},
                                                                        {"unit", std::string("mm")}},
                                                                       {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->lattice.spacing, Eigen::Vector3d(1, 2, 0.5));
        QCOMPARE(dataset->lattice.origin, Eigen::Vector3d(-1, 100, 0.5));
        QCOMPARE(dataset->lengthUnit, std::string("mm"));
        QVERIFY(dataset->remarks.empty());
    }
}

void RawReaderTest::skipsAHeader()
{
    const auto path = folder_.write("headed.dat", "header." + testSamples(SampleType::UInt8));
    const Result<Dataset> dataset =
        asLoaded<LatticeReader>().read(path, {{"size", std::string("3x4x5")}, {"skip", std::int64_t(7)}}, {});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QVERIFY(holdsTestSamples(dataset->values));
}

/// Volumes larger than the memory (B6): not copied unless that is needed.
void RawReaderTest::staysInItsFileWhereItCan_data()
{
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<bool>("native");
    QTest::addColumn<int>("skip");
    QTest::addColumn<bool>("mapped");
    QTest::newRow("bytes") << SampleType::UInt8 << false << 0 << true;
    QTest::newRow("bytes behind a header") << SampleType::Int8 << true << 5 << true;
    QTest::newRow("double") << SampleType::Float64 << true << 0 << true;
    QTest::newRow("aligned") << SampleType::Float32 << true << 12 << true;
    QTest::newRow("not aligned") << SampleType::Float32 << true << 6 << false;
    QTest::newRow("double as if float") << SampleType::Float64 << true << 4 << false;
    QTest::newRow("the other order") << SampleType::UInt16 << false << 0 << false;
}
void RawReaderTest::staysInItsFileWhereItCan()
{
    QFETCH(SampleType, type);
    QFETCH(bool, native);
    QFETCH(int, skip);
    QFETCH(bool, mapped);
    const bool little = native == (std::endian::native == std::endian::little);
    const auto path = folder_.write(
        "volume.raw", QByteArray(skip, 'x') + testSamples(type, little ? std::endian::little : std::endian::big));
    const auto dataset = asLoaded<LatticeReader>().read(path,
                                                        {{"size", std::string("3x4x5")},
                                                         {"type", std::string(sampleTypeName(type))},
                                                         {"byte-order", std::string(little ? "little" : "big")},
                                                         {"skip", std::int64_t(skip)}},
                                                        {});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QVERIFY(holdsTestSamples(dataset->values));
    QCOMPARE(dataset->values.range().maximum, testPoints - 1.0);
    QCOMPARE(dataset->source.hash, contentHash(dataset->values, nullptr));
    QCOMPARE(dataset->mappedFile != nullptr, mapped);
    QVERIFY(dataset->checkIntact());
}

void RawReaderTest::knowsThatItsFileWasCut()
{
    const auto path = folder_.write("cut.raw", testSamples(SampleType::UInt8));
    const auto dataset = asLoaded<LatticeReader>().read(path, {{"size", std::string("3x4x5")}}, {});
    QVERIFY(dataset.ok());
    std::filesystem::resize_file(path, 30);
    const Status intact = dataset->checkIntact();
    QVERIFY(!intact);
    QCOMPARE(intact.error().kind, ErrorKind::BadInput);
    QVERIFY(intact.error().text().find("cut.raw") != std::string::npos);
}

void RawReaderTest::refuses_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<ParameterValues>("values");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QList<QByteArray>>("words");
    const QByteArray samples = testSamples(SampleType::UInt8);
    const auto row = [&](const char* name, const QByteArray& file, const ParameterValues& values, ErrorKind kind,
                         const QList<QByteArray>& words) {
        QTest::newRow(name) << file << values << static_cast<int>(kind) << words;
    };
    const auto text = [](const char* id, const char* value) {
        return std::pair<const std::string, ParameterValue>(id, std::string(value));
    };
    const auto size = text("size", "3x4x5");
    const auto wrongUsage = ErrorKind::WrongUsage;
    const auto badInput = ErrorKind::BadInput;
    row("empty", "", {size}, badInput, {"empty"});
    row("nothing described", samples, {}, wrongUsage, {"60 bytes", "size and type", "for example --size"});
    row("a cube", QByteArray(32768, 1), {}, wrongUsage, {"32768 bytes", "--size 32x32x32 --type uint8"});
    row("a cube after a header", QByteArray(32768 + 10, 1), {{"skip", std::int64_t(10)}}, wrongUsage,
        {"--size 32x32x32 --type uint8"});
    row("size with two numbers", samples, {text("size", "12x5")}, wrongUsage, {"'12x5'", "64x64x32"});
    row("size with four numbers", samples, {text("size", "3x4x5x1")}, wrongUsage, {"'3x4x5x1'"});
    row("size not whole", samples, {text("size", "3x4x5.0")}, wrongUsage, {"'3x4x5.0'"});
    row("size negative", samples, {text("size", "3x-4x5")}, wrongUsage, {"'3x-4x5'"});
    row("one slice", samples, {text("size", "12x5x1")}, badInput, {"12 x 5 x 1", "at least 2"});
    row("absurd size", samples, {text("size", "4000000000x4000000000x4000000000")}, badInput,
        {"more than any machine"});
    row("unknown type", samples, {size, text("type", "number")}, wrongUsage, {"'number'", "uint8"});
    row("int128", samples, {size, text("type", "int128")}, wrongUsage, {"int128", "double"});
    row("unknown order", samples, {size, text("byte-order", "both")}, wrongUsage, {"'both'"});
    row("spacing not understood", samples, {size, text("spacing", "1")}, wrongUsage, {"'1' for 'spacing'"});
    row("spacing zero", samples, {size, text("spacing", "1x1x0")}, badInput, {"positive"});
    row("spacing NaN", samples, {size, text("spacing", "1 1 nan")}, badInput, {"positive"});
    row("origin infinite", samples, {size, text("origin", "0,0,inf")}, badInput, {"finite"});
    row("skip negative", samples, {size, {"skip", std::int64_t(-1)}}, wrongUsage, {"negative"});
    row("cut short", samples.left(59), {size}, badInput, {"60 bytes", "only 59 bytes"});
    row("too long", samples + "x", {size}, badInput, {"60 bytes", "61", "1 too many"});
    row("another type", samples, {size, text("type", "uint16")}, badInput, {"120 bytes", "only 60 bytes"});
    row("skip too much", samples, {size, {"skip", std::int64_t(1)}}, badInput, {"only 59 bytes"});
    row("skip beyond the end", samples, {size, {"skip", std::int64_t(1) << 60}}, badInput, {"only 0 bytes"});
}

void RawReaderTest::refuses()
{
    QFETCH(QByteArray, file);
    QFETCH(ParameterValues, values);
    QFETCH(int, kind);
    QFETCH(QList<QByteArray>, words);
    const Result<Dataset> dataset = asLoaded<LatticeReader>().read(folder_.write("wrong.raw", file), values, {});
    QVERIFY(!dataset.ok());
    const QByteArray text = QByteArray::fromStdString(dataset.error().text());
    QVERIFY2(static_cast<int>(dataset.error().kind) == kind, text);
    QVERIFY2(text.contains("wrong.raw") && text.endsWith('.'), text);
    for (const QByteArray& word : words)
        QVERIFY2(text.contains(word), text);
}

void RawReaderTest::guesses_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint64>("bytes");
    QTest::addColumn<QStringList>("texts");
    const auto row = [](const char* name, quint64 bytes, const QStringList& texts) {
        QTest::newRow(name) << name << bytes << texts;
    };
    row("bonsai_256x256x128_uint8.raw", 8388608, {"256x256x128 uint8"});
    row("head.64x64x93-int16.raw", 761856, {"64x64x93 int16"});
    row("headed_64X64X93.raw", 1523712, {"64x64x93 float"});
    row("Molecule_U8_X100_Y100_Z120.binary", 1200000, {"100x100x120 uint8"});
    row("head-z93-x64-y64.f32.raw", 1523712, {"64x64x93 float"});
    row("only_X100_Z120_u8.raw", 12000, {});
    row("wrong_10x10x10_uint8.raw", 68921, {"41x41x41 uint8"});
    row("cube.raw", 262144,
        {"64x64x64 uint8", "32x32x32 double", "128x128x16 uint8", "64x64x32 uint16", "64x64x16 float"});
    row("prime.raw", 1000003, {});
    row("empty.raw", 0, {});
    row("huge.raw", ~quint64(0), {});
}

void RawReaderTest::guesses()
{
    QFETCH(QString, name);
    QFETCH(quint64, bytes);
    QFETCH(QStringList, texts);
    QCOMPARE(guessTexts(name.toStdString(), bytes), texts);
}

void RawReaderTest::guessesFillTheFile()
{
    for (std::uint64_t bytes = 0; bytes < 3'000'000; bytes += 512) {
        const std::vector<RawGuess> guesses = guessRawLayouts("x.raw", bytes);
        QVERIFY(guesses.size() <= 5);
        for (const RawGuess& guess : guesses)
            QCOMPARE(std::uint64_t(guess.size[0]) * guess.size[1] * guess.size[2] * sampleSize(guess.type), bytes);
    }
}

void RawReaderTest::probesWithoutTheSamples()
{
    const auto path = folder_.write("v_3x4x5_uint16.raw", testSamples(SampleType::UInt16));
    const auto guessed = asLoaded<LatticeReader>().probe(path, {}, {});
    QVERIFY(guessed);
    QCOMPARE(guessed->points, std::uint64_t(0));
    QCOMPARE(guessed->suggestions.size(), std::size_t(1));
    const auto contents = asLoaded<LatticeReader>().probe(path, guessed->suggestions[0], {});
    QVERIFY(contents);
    QCOMPARE(contents->lattice.size, (std::array<std::uint32_t, 3>{3, 4, 5}));
    QCOMPARE(contents->points, std::uint64_t(60));
    QCOMPARE(contents->type, std::optional(SampleType::UInt16));
    QVERIFY(contents->suggestions.empty());
    for (const char* size : {"3x4x4", "3x4x6", "3x4"}) { // refused as they are when they are read
        const ParameterValues values = {{"size", std::string(size)}, {"type", std::string("uint16")}};
        const auto probed = asLoaded<LatticeReader>().probe(path, values, {});
        const auto read = asLoaded<LatticeReader>().read(path, values, {});
        QVERIFY(!probed && !read);
        QCOMPARE(probed.error().text(), read.error().text());
        QCOMPARE(probed.error().kind, read.error().kind);
    }
    const auto nrrd = folder_.write("v.nrrd", nrrdHeader("spacings: 1 2 3\n") + testSamples(SampleType::UInt8));
    const auto told = asLoaded<LatticeReader>().probe(nrrd, {}, {});
    QVERIFY2(told, told ? "" : told.error().text().c_str());
    const auto whole = asLoaded<LatticeReader>().read(nrrd, {}, {});
    QVERIFY(whole);
    QCOMPARE(told->lattice.size, whole->lattice.size);
    QCOMPARE(told->lattice.spacing, whole->lattice.spacing);
    QCOMPARE(told->type, std::optional(whole->values.type()));
    const auto cut = folder_.write("cut.nrrd", nrrdHeader("") + testSamples(SampleType::UInt8).left(50));
    QVERIFY(!asLoaded<LatticeReader>().probe(cut, {}, {}));
    QVERIFY(!asLoaded<LatticeReader>().probe(folder_.path() / "missing.nrrd", {}, {}));
}

QTEST_GUILESS_MAIN(RawReaderTest)
#include "raw_reader_test.moc"
