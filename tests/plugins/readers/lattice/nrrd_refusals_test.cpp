// SPDX-License-Identifier: GPL-3.0-or-later
// Every NRRD file that is refused, with the words that tell the user why (S20).
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QtTest>

#include <limits>

#include <sys/stat.h>
#include <unistd.h>

using namespace tetra;
namespace fs = std::filesystem;

class NrrdRefusalsTest : public QObject {
    Q_OBJECT

private slots:
    void ofFiles_data();
    void ofFiles();
    void samplesThatAreNotFiniteAreHoles_data();
    void samplesThatAreNotFiniteAreHoles();
    void ofWhatIsNoFile();
    void ofFilesThatMayNotBeRead();
    void ofDataFilesThatAreNotThere();
    void withoutTakingMemory();

private:
    TestFolder folder_;
};

namespace {

void checkRefused(const fs::path& path, const QList<QByteArray>& words, ErrorKind kind = ErrorKind::BadInput)
{
    const Result<Dataset> dataset = asLoaded<LatticeReader>().read(path, {}, {});
    QVERIFY(!dataset.ok());
    const QByteArray text = QByteArray::fromStdString(dataset.error().text());
    QVERIFY2(dataset.error().kind == kind, text);
    QVERIFY2(text.contains(QByteArray::fromStdString(path.filename().string())), text);
    QVERIFY2(text.endsWith('.'), text);
    for (const QByteArray& word : words)
        QVERIFY2(text.contains(word), text);
}

} // namespace

void NrrdRefusalsTest::ofFiles_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QList<QByteArray>>("words");
    const QByteArray samples = testSamples(SampleType::UInt8);
    const auto row = [](const char* name, const QByteArray& file, const QList<QByteArray>& words) {
        QTest::newRow(name) << file << words;
    };
    const auto fields = [&](const char* name, const QByteArray& text, const QList<QByteArray>& words) {
        row(name, nrrdHeader(text) + samples, words);
    };
    const auto list = [&](const char* name, const QByteArray& lastLines, const QList<QByteArray>& words) {
        row(name, nrrdHeader("").chopped(1) + lastLines, words);
    };
    row("empty", "", {"empty"});
    row("no NRRD", "P5 3 4 255\n", {"not an NRRD file"});
    row("a later version", "NRRD0006\n\n", {"version", "NRRD0006"});
    row("no version", "NRRD000\n\n", {"version"});
    row("no end of the header", "NRRD0004\n" + QByteArray("# long\n").repeated(200000), {"header does not end"});
    row("one endless line", "NRRD0004\n#" + QByteArray(2000000, 'x'), {"header does not end"});
    row("header only", nrrdHeader(""), {"60 bytes", "only 0 bytes"});
    row("cut header", "NRRD0004\ndimension: 3\nsiz", {"line 3", "siz"});

    row("no type", "NRRD0004\ndimension: 3\nsizes: 3 4 5\nencoding: raw\n\n" + samples, {"no field 'type'"});
    row("no dimension", "NRRD0004\ntype: uint8\nsizes: 3 4 5\nencoding: raw\n\n" + samples, {"no field 'dimension'"});
    row("no sizes", "NRRD0004\ndimension: 3\ntype: uint8\nencoding: raw\n\n" + samples, {"no field 'sizes'"});
    row("no encoding", "NRRD0004\ndimension: 3\nsizes: 3 4 5\ntype: uint8\n\n" + samples, {"no field 'encoding'"});
    row("no endian", nrrdHeader("type: short\n") + testSamples(SampleType::Int16), {"no field 'endian'"});
    fields("no field at all", "what is this\n", {"line 2", "what is this"});
    fields("unknown field", "spacing: 1 1 2\n", {"line 2", "unknown field 'spacing'"});
    fields("field twice", "sizes: 3 4 5\nsizes: 3 4 5\n", {"line 3", "second time"});
    fields("binary junk", QByteArray("\xff\x00\x01junk\n", 8), {"line 2"});

    fields("unknown type", "type: quaternion\n", {"'quaternion'", "uint8"});
    fields("block", "type: block\nblock size: 4\n", {"block"});
    fields("unknown endian", "type: short\nendian: middle\n", {"middle", "little or big"});
    fields("hex", "encoding: hex\n", {"'hex'", "gzip"});
    fields("bzip2", "encoding: bzip2\n", {"'bzip2'", "gzip"});
    list("list of files that is empty", "data file: LIST\n", {"names of 0 files", "line of its own"});
    list("list of too few files", "data file: LIST\na.raw\nb.raw\n", {"names of 2 files"});
    list("list of files of no dimension", "data file: LIST 0\n", {"from 1 to 3"});
    list("list of files of too many", "data file: LIST 4\n", {"from 1 to 3"});
    list("list of a name that cannot be", "data file: LIST 3\nsamples.\x01w\n", {"'samples.\\x01w'", "Correct it"});
    fields("control characters in a name", "data file: samples.\x01w\n", {"'samples.\\x01w'", "Correct it"});
    fields("pattern of too few files", "data file: slice%03d.raw 1 4 1\n", {"names 4 files", "sizes require"});
    fields("pattern of endless files", "data file: slice%03d.raw 1 1000000000 1\n", {"names 1000000000 files"});
    fields("pattern of more files than there are", "sizes: 3 4 300000\ndata file: slice%d.raw 1 300000 1\n",
           {"names 300000 files", "fewer"});
    fields("pattern without step", "data file: slice%03d.raw 1 5 0\n", {"the step"});
    fields("pattern of the wrong direction", "data file: slice%03d.raw 5 1 1\n", {"the step"});
    fields("pattern of words", "data file: slice%03d.raw one five 1\n", {"number of the first file"});
    fields("pattern of another kind", "data file: slice%s.raw 1 5 1\n", {"'%03d'"});
    fields("pattern without files", "data file: slice%03d.raw 1 5 1\n", {"slice001.raw", "No such file"});

    fields("dimension 0", "dimension: 0\nsizes:\n", {"sizes"});
    fields("dimension not a number", "dimension: three\n", {"dimension: three"});
    fields("dimension 17", "dimension: 17\n", {"1 to 16"});
    fields("two dimensions", "dimension: 2\nsizes: 12 5\n", {"2 dimensions", "volume has three"});
    fields("four dimensions", "dimension: 4\nsizes: 2 3 2 5\n", {"4 dimensions", "one component"});
    fields("four dimensions, two of them", "dimension: 4\nsizes: 1 12 5 1\n", {"4 dimensions", "2 of them"});
    fields("colours", "kinds: RGB-color domain domain\n", {"'rgb-color'", "component"});
    fields("too few sizes", "sizes: 12 5\n", {"sizes: 12 5", "3 axes"});
    fields("too many sizes", "sizes: 3 4 5 1\n", {"3 axes"});
    fields("size not a number", "sizes: 3 x 5\n", {"sizes: 3 x 5"});
    fields("size 0", "sizes: 3 0 5\n", {"whole numbers from 1"});
    fields("size negative", "sizes: 3 -4 5\n", {"whole numbers from 1"});
    fields("size fraction", "sizes: 3 4.0 5\n", {"whole numbers from 1"});
    fields("one point along x", "sizes: 1 12 5\n", {"1 x 12 x 5", "at least 2"});
    fields("one point along z", "sizes: 12 5 1\n", {"at least 2"});
    fields("huge axis", "sizes: 4294967296 2 2\n", {"more than any machine"});
    fields("huge product", "sizes: 4294967295 4294967295 4294967295\n", {"more than any machine"});
    fields("product that wraps around", "sizes: 2147483648 2147483648 4\n", {"more than any machine"});

    fields("some spacings", "spacings: 1 nan 1\n", {"some axes"});
    fields("zero spacing", "spacings: 1 0 1\n", {"positive"});
    fields("spacing not a number", "spacings: 1 1mm 1\n", {"spacings: 1 1mm 1"});
    fields("spacing too small", "spacings: 1 1 1e-30\naxis mins: 0 0 1e10\n", {"coincide"});
    fields("spacing too large", "spacings: 1 1 1e308\n", {"finite"});
    fields("directions alike", "space directions: (1,0,0) (1,0,0) (0,0,1)\n", {"in a plane"});
    fields("directions in a plane", "space directions: (1,0,0) (1,1,0) (2,-3,0)\n", {"in a plane"});
    fields("directions all but in a plane", "space directions: (1,0,0) (1,1,0) (2,-3,1e-7)\n", {"in a plane"});
    fields("direction of no length", "space directions: (0,0,0) (0,1,0) (0,0,1)\n", {"positive"});
    fields("direction without end", "space directions: (inf,0,0) (0,1,0) (0,0,1)\n", {"positive"});
    fields("direction in part unknown", "space directions: (nan,0,1) (0,1,0) (0,0,1)\n", {"positive"});
    fields("directions too long", "space directions: (1e308,1e308,0) (0,1,0) (0,0,1)\n", {"finite"});
    fields("directions too short", "space directions: (1e-320,1e-320,0) (0,1,0) (0,0,1)\nspace origin: (1,1,1)\n",
           {"too large or small"});
    fields("origin too far", "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1e17,0,0)\n", {"coincide"});
    fields("directions of a plane", "space directions: (1,0) (0,1) (1,1)\n", {"three numbers"});
    fields("too few directions", "space directions: (1,0,0) (0,1,0)\n", {"3 axes"});
    fields("some directions", "space directions: (1,0,0) none (0,0,1)\n", {"some axes"});
    fields("direction not closed", "space directions: (1,0,0) (0,1,0) (0,0,1\n", {"parentheses"});
    fields("origin not understood", "space origin: 1 2 3\n", {"'1 2 3'", "parentheses"});
    fields("line skip negative", "line skip: -1\n", {"line skip"});
    fields("line skip too many", "line skip: 7\n", {"only 1 of the 7 lines"});
    fields("byte skip -2", "byte skip: -2\n", {"byte skip"});
    fields("byte skip too many", "byte skip: 1000\n", {"only 0 bytes"});

    row("cut short", nrrdHeader("") + samples.left(59), {"60 bytes", "only 59 bytes"});
    row("too long", nrrdHeader("") + samples + "\n", {"60 bytes", "61", "1 too many"});
    row("cut short, from the end", nrrdHeader("byte skip: -1\n") + samples.left(59), {"only 59 bytes"});
    const QByteArray gzip = nrrdHeader("encoding: gzip\n");
    const QByteArray packed = gzipped(samples);
    row("gzip, none", gzip, {"only 0 bytes of compressed data"});
    row("gzip, not packed", gzip + samples, {"damaged"});
    row("gzip, cut short", gzip + packed.chopped(12), {"damaged", "cut short"});
    row("gzip, cut in the checksum", gzip + packed.chopped(3), {"damaged"});
    row("gzip, wrong checksum", gzip + packed.chopped(8) + QByteArray(4, 'x') + packed.right(4), {"damaged"});
    row("gzip, too few", gzip + gzipped(samples.left(59)), {"only 59 bytes", "60"});
    row("gzip, too many", gzip + gzipped(samples + "1"), {"more than 60 bytes"});
    row("gzip, junk after it", gzip + packed + "junk", {"damaged"});
    row("gzip, byte skip -1", nrrdHeader("encoding: gzip\nbyte skip: -1\n") + packed, {"byte skip"});
    const QByteArray text = nrrdHeader("sizes: 2 2 2\nencoding: ascii\n");
    row("text, cut short", text + "1 2 3 4 5 6 7       ", {"only 7 numbers", "8"});
    row("text, too many", text + "1 2 3 4 5 6 7 8 9", {"more than the 8 numbers"});
    row("text, no number", text + "1 2 3 four 5 6 7 8", {"number 4", "'four'"});
    row("text, no whole number", text + "1 2 3.5 4 5 6 7 8", {"number 3", "'3.5'"});
    row("text, out of range", text + "1 2 256 4 5 6 7 8", {"number 3", "'256'"});
    row("text, none", text, {"only 0 bytes of text"});
}

void NrrdRefusalsTest::ofFiles()
{
    QFETCH(QByteArray, file);
    QFETCH(QList<QByteArray>, words);
    checkRefused(folder_.write("wrong.nrrd", file), words);
}

void NrrdRefusalsTest::samplesThatAreNotFiniteAreHoles_data()
{
    QTest::addColumn<bool>("isDouble");
    QTest::addColumn<double>("value");
    for (const bool isDouble : {false, true}) {
        const QByteArray type = isDouble ? "double " : "float ";
        QTest::newRow(type + "NaN") << isDouble << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow(type + "infinity") << isDouble << std::numeric_limits<double>::infinity();
        QTest::newRow(type + "minus infinity") << isDouble << -std::numeric_limits<double>::infinity();
    }
}

/// C10, S20: they are holes.
void NrrdRefusalsTest::samplesThatAreNotFiniteAreHoles()
{
    QFETCH(bool, isDouble);
    QFETCH(double, value);
    QByteArray samples = testSamples(isDouble ? SampleType::Float64 : SampleType::Float32);
    constexpr qsizetype point = 2 + 3 * (1 + 4 * 2); // (2, 1, 2)
    const auto single = static_cast<float>(value);
    if (isDouble)
        samples.replace(point * 8, 8, reinterpret_cast<const char*>(&value), 8);
    else
        samples.replace(point * 4, 4, reinterpret_cast<const char*>(&single), 4);
    const QByteArray type = isDouble ? "double" : "float";
    const auto dataset = complete(asLoaded<LatticeReader>().read(
        folder_.write("nan.nrrd", nrrdHeader("type: " + type + "\nendian: little\n") + samples), {}, {}));
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QCOMPARE(dataset->domain, DomainClass::Irregular);
    QCOMPARE(dataset->pointCount(), std::uint64_t(58)); // also without (2, 0, 2), whose cells all have that corner
    QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(0));
    const auto text = asLoaded<LatticeReader>().read(
        folder_.write("text.nrrd", nrrdHeader("sizes: 2 2 2\ntype: float\nencoding: text\n") + "1 2 nan 4 5 6 7 8"), {},
        {});
    QVERIFY(text.ok());
    const auto nothingLeft = withHoles(*text);
    QVERIFY(!nothingLeft.ok());
    QCOMPARE(nothingLeft.error().kind, ErrorKind::BadInput);
    QVERIFY2(nothingLeft.error().text().find("nothing is left") != std::string::npos,
             nothingLeft.error().text().c_str());
}

void NrrdRefusalsTest::ofWhatIsNoFile()
{
    checkRefused(folder_.path() / "missing.nrrd", {"No such file"});
    fs::create_directory(folder_.path() / "folder.nrrd");
    checkRefused(folder_.path() / "folder.nrrd", {"folder"});
    QCOMPARE(::mkfifo((folder_.path() / "pipe.nrrd").c_str(), 0600), 0);
    checkRefused(folder_.path() / "pipe.nrrd", {"not a regular file"}); // and does not wait for a writer
}

void NrrdRefusalsTest::ofFilesThatMayNotBeRead()
{
    const fs::path path = folder_.write("secret.nrrd", nrrdHeader("") + testSamples(SampleType::UInt8));
    fs::permissions(path, fs::perms::none);
    const bool isRoot = ::geteuid() == 0; // who may read everything: try as nobody
    constexpr uid_t nobody = 65534;
    if (isRoot && ::seteuid(nobody) != 0)
        QSKIP("skipped: this user may read every file");
    checkRefused(path, {"Permission denied"});
    if (isRoot)
        QCOMPARE(::seteuid(0), 0);
}

void NrrdRefusalsTest::ofDataFilesThatAreNotThere()
{
    checkRefused(folder_.write("alone.nhdr", nrrdHeader("data file: nowhere.raw\n")), {"nowhere.raw", "No such file"});
    checkRefused(folder_.write("folder.nhdr", nrrdHeader("data file: .\n")), {"it is a folder"});
    folder_.write("nothing.raw", "");
    checkRefused(folder_.write("empty.nhdr", nrrdHeader("data file: nothing.raw\n")), {"nothing.raw", "empty"});
    folder_.write("short.raw", "1234");
    const Result<Dataset> dataset =
        asLoaded<LatticeReader>().read(folder_.write("short.nhdr", nrrdHeader("data file: short.raw\n")), {}, {});
    QVERIFY(!dataset.ok());
    QVERIFY2(dataset.error().text().find("short.raw") != std::string::npos, dataset.error().text().c_str());
}

/// A header that asks for much more than stands in the file is refused at once, whatever the encoding.
void NrrdRefusalsTest::withoutTakingMemory()
{
    for (const QByteArray encoding : {"raw", "gzip", "ascii"})
        checkRefused(folder_.write("greedy.nrrd",
                                   nrrdHeader("sizes: 1000000 100000 100\nencoding: " + encoding + "\n") + "1 2 3"),
                     {"10000000000000 bytes", "cut short"});
}

QTEST_GUILESS_MAIN(NrrdRefusalsTest)
#include "nrrd_refusals_test.moc"
