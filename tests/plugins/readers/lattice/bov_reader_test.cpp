// SPDX-License-Identifier: GPL-3.0-or-later
// Bricks of values: points and cells, every type, plain and packed, and headers that do not fit.
#include "tests/lacks.h"
#include "tests/plugins/readers/lattice/format_files.h"

#include <QtTest>

using namespace tetra;

namespace {

/// A header with the usual lines for 4 x 5 x 6 points; those in `lines` stand for these.
QByteArray bov(const QByteArray& lines)
{
    QByteArray header = lines;
    for (const char* const line :
         {"TIME: 0.5", "DATA_FILE: volume.values", "DATA_SIZE: 4 5 6", "DATA_FORMAT: FLOAT", "VARIABLE: density",
          "DATA_ENDIAN: LITTLE", "CENTERING: nodal", "BRICK_ORIGIN: 1. -2. 3.", "BRICK_SIZE: 1.5 1. 10."}) {
        const QByteArray key = QByteArray(line).left(QByteArray(line).indexOf(':') + 1);
        if (!header.contains(key))
            header += QByteArray(line) + "\n";
    }
    return header;
}

/// What the usual header describes.
WorldVolume usualWorld()
{
    return {{4, 5, 6}, Eigen::Vector3d(0.5, 0.25, 2).asDiagonal(), {1, -2, 3}, 1};
}

template <class Number> QByteArray countingBytes(std::endian order)
{
    QByteArray bytes;
    for (int n = 0; n < 120; ++n)
        bytes += numberBytes(static_cast<Number>(n), order);
    return bytes;
}

} // namespace

class BovReaderTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAndCells()
    {
        const WorldVolume world = usualWorld();
        const auto points = read(bov(""), world.firstFastest(littleFloat));
        QVERIFY2(points, text_);
        QVERIFY(distanceFromWorld(*points, 1) < 1e-5);
        QVERIFY((points->position(0) == world.origin));
        QCOMPARE(points->source.valueName, std::string("density"));
        QCOMPARE(takenWords(points->source.taken), QByteArray("places: the points\n"));
        QVERIFY(points->mappedFile != nullptr && points->remarks.empty() && points->source.leftOut.empty());
        WorldVolume cells = world;
        cells.steps = Eigen::Vector3d(1.5 / 4, 1. / 5, 10. / 6).asDiagonal();
        cells.origin += cells.steps * Eigen::Vector3d(0.5, 0.5, 0.5);
        const auto zones = read(bov("CENTERING: zonal\n"), cells.firstFastest(littleFloat));
        QVERIFY2(zones, text_);
        QVERIFY(distanceFromWorld(*zones, 1) < 1e-5);
        QCOMPARE(takenWords(zones->source.taken), QByteArray("places: the middles of the cells\n"));
        const auto unsaid = read(bov("CENTERING:\n"), world.firstFastest(littleFloat));
        QVERIFY2(unsaid, text_);
        QVERIFY(distanceFromWorld(*unsaid, 1) < 1e-5);
        QCOMPARE(takenWords(unsaid->source.taken), QByteArray("places: the points (a guess)\n"));
    }

    void everyType_data()
    {
        QTest::addColumn<QByteArray>("format");
        QTest::addColumn<QByteArray>("numbers");
        QTest::addColumn<SampleType>("becomes");
        const auto row = [](const char* name, auto number, SampleType becomes) {
            using Number = decltype(number);
            for (const bool isBig : {false, true})
                QTest::newRow(QByteArray(name) + (isBig ? " big" : " little"))
                    << QByteArray("DATA_FORMAT: ") + name + "\nDATA_ENDIAN: " + (isBig ? "BIG\n" : "little\n")
                    << countingBytes<Number>(isBig ? std::endian::big : std::endian::little) << becomes;
        };
        row("BYTE", std::uint8_t(), SampleType::UInt8);
        row("BYTES", std::uint8_t(), SampleType::UInt8);
        row("CHAR", std::uint8_t(), SampleType::UInt8);
        row("SHORT", std::int16_t(), SampleType::Int16);
        row("INT", std::int32_t(), SampleType::Int32);
        row("LONG", std::int64_t(), SampleType::Int32);
        row("FLOAT", float(), SampleType::Float32);
        row("FLOATS", float(), SampleType::Float32);
        row("REAL", float(), SampleType::Float32);
        row("double", double(), SampleType::Float64);
    }
    void everyType()
    {
        QFETCH(QByteArray, format);
        QFETCH(QByteArray, numbers);
        const auto dataset = read(bov(format), numbers);
        QVERIFY2(dataset, text_);
        QTEST(dataset->values.type(), "becomes");
        for (std::uint64_t n = 0; n < 120; ++n)
            QCOMPARE(dataset->values.at(n), double(n));
    }

    void packedFilesAndPlaces()
    {
        const WorldVolume world = usualWorld();
        const QByteArray numbers = world.firstFastest(littleFloat);
        QVERIFY(!folder_.write("volume.values.gz", gzipped("12345" + numbers)).empty());
        const auto packed = read(bov("DATA_FILE: volume.values.gz\nBYTE_OFFSET: 5\n"), "");
        QVERIFY2(packed, text_);
        QVERIFY(distanceFromWorld(*packed, 1) < 1e-5);
        const auto skipped = read(bov("BYTE_OFFSET: 3\n"), "abc" + numbers + "the end");
        QVERIFY2(skipped, text_);
        QVERIFY(distanceFromWorld(*skipped, 1) < 1e-5);
        QVERIFY(sentences(skipped->source.leftOut).contains("7 bytes after"));
        QVERIFY(!folder_.write("brick0000.values", numbers).empty());
        for (const char* const brick : {"", "DATA_BRICKLETS: 4 5 6\n"}) {
            const auto pattern = read(bov(QByteArray("DATA_FILE: brick%04d.values\n") + brick), "");
            QVERIFY2(pattern, text_);
            QVERIFY(distanceFromWorld(*pattern, 1) < 1e-5);
        }
    }

    void componentsAndScales()
    {
        QByteArray vectors;
        for (int n = 0; n < 120; ++n)
            for (const double part : {3. * n, 4. * n, 12. * n})
                vectors += littleFloat(part);
        const auto magnitude = read(bov("DATA_COMPONENTS: 3\n"), vectors);
        QVERIFY2(magnitude, text_);
        const auto second = read(bov("DATA_COMPONENTS: 3\n"), vectors, {{"component", std::string("1")}});
        QVERIFY2(second, text_);
        for (std::uint64_t n = 0; n < 120; ++n) {
            QCOMPARE(magnitude->values.at(n), 13. * double(n));
            QCOMPARE(second->values.at(n), 4. * double(n));
        }
        QVERIFY(takenWords(magnitude->source.taken).contains("component: magnitude of 3 (a guess)"));
        QCOMPARE(second->source.valueName, std::string("density (component 1)"));
        const auto complex =
            read(bov("DATA_COMPONENTS: COMPLEX\n"), vectors.first(960), {{"component", std::string("0")}});
        QVERIFY2(complex, text_);
        QCOMPARE(complex->values.at(0), 0.);
        const auto scaled = read(bov("DATA_FORMAT: BYTE\nVARIABLE_MIN: -10\nVARIABLE_MAX: 500\n"),
                                 countingBytes<std::uint8_t>(std::endian::little));
        QVERIFY2(scaled, text_);
        for (std::uint64_t n = 0; n < 120; ++n)
            QVERIFY(std::abs(scaled->values.at(n) - (-10 + 2. * double(n))) < 1e-4);
        QVERIFY(sentences(scaled->remarks).contains("from -10 to 500"));
        const auto floats =
            read(bov("VARIABLE_MIN: -10\nVARIABLE_MAX: 500\n"), countingBytes<float>(std::endian::little));
        QVERIFY2(floats, text_);
        QCOMPARE(floats->values.at(119), 119.); // the range of these is only told
    }

    void whatIsNotSaidIsTold()
    {
        const QByteArray numbers = countingBytes<float>(std::endian::native);
        const auto bare = read(bov("BRICK_SIZE:\nBRICK_ORIGIN:\nDATA_ENDIAN:\nCOORD_SYS: polar\n# note\n\n"), numbers);
        QVERIFY2(bare, text_);
        const QByteArray remarks = sentences(bare->remarks);
        QVERIFY2(remarks.contains("byte order") && remarks.contains("1 x 1 x 1 is assumed"), remarks);
        QCOMPARE(sentences(bare->source.leftOut), QByteArray("Its line 'COORD_SYS: polar' is not used.\n"));
        const auto placed = read(bov("BRICK_SIZE:\nBRICK_ORIGIN:\nCENTERING: zonal\n"), numbers,
                                 {{"spacing", std::string("2x3x4")}, {"origin", std::string("1,1,1")}});
        QVERIFY2(placed, text_);
        QVERIFY((placed->lattice.spacing == Eigen::Vector3d(2, 3, 4)));
        QVERIFY((placed->lattice.origin == Eigen::Vector3d(1, 1, 1)));
        const auto middle = read(bov("BRICK_SIZE:\nCENTERING: zonal\n"), numbers, {{"spacing", std::string("2x3x4")}});
        QVERIFY2(middle, text_);
        QVERIFY((middle->lattice.origin == Eigen::Vector3d(2, -0.5, 5)));
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::addColumn<QList<QByteArray>>("words");
        const auto row = [](const char* name, const QByteArray& lines, const QList<QByteArray>& words) {
            QTest::newRow(name) << bov(lines) << words;
        };
        row("no line", "what is this\n", {"line 1", "'what is this'"});
        row("no file", "DATA_FILE:\n", {"'DATA_FILE:'"});
        row("no size", "DATA_SIZE:\n", {"'DATA_SIZE:'"});
        row("no format", "DATA_FORMAT:\n", {"'DATA_FORMAT:'"});
        row("a size of two", "DATA_SIZE: 4 5\n", {"DATA_SIZE", "'4 5'"});
        row("a negative size", "DATA_SIZE: 4 -5 6\n", {"DATA_SIZE"});
        row("a slice", "DATA_SIZE: 4 5 1\n", {"at least 2"});
        row("an endless size", "DATA_SIZE: 1000000000000000000 5 6\n", {"1000000000000000000"});
        row("more than there is", "DATA_SIZE: 4 5 7\n", {"volume.values", "volume.bov", "4 x 5 x 7", "cut short"});
        row("endless components", "DATA_COMPONENTS: 1000000000000\n", {"DATA_COMPONENTS"});
        row("no components", "DATA_COMPONENTS: 0\n", {"DATA_COMPONENTS"});
        row("more components than there are", "DATA_COMPONENTS: 1000000\n", {"only 480 bytes"});
        row("an unknown format", "DATA_FORMAT: STRING\n", {"'STRING'"});
        row("an unknown order", "DATA_ENDIAN: MIDDLE\n", {"'MIDDLE'"});
        row("an unknown centering", "CENTERING: between\n", {"'between'"});
        row("an offset that is none", "BYTE_OFFSET: far\n", {"'far'"});
        row("an offset beyond the end", "BYTE_OFFSET: 4611686018427387904\n", {"only 0 bytes"});
        row("an offset beyond all", "BYTE_OFFSET: 9223372036854775807\n", {"BYTE_OFFSET"});
        row("an origin that is none", "BRICK_ORIGIN: nan 0 0\n", {"finite"});
        row("a size of nothing", "BRICK_SIZE: 0 1 1\n", {"positive"});
        row("a negative brick", "BRICK_SIZE: -1 1 1\n", {"positive"});
        row("a range that is none", "VARIABLE_MIN: low\n", {"'low'"});
        row("several files", "DATA_FILE: brick%04d.values\nDATA_BRICKLETS: 2 5 6\n", {"several files", "VTK"});
        row("ghosts", "HAS_BOUNDARY: true\n", {"HAS_BOUNDARY"});
        row("a file that is not there", "DATA_FILE: missing.values\n", {"missing.values", "volume.bov"});
        row("packed that is not", "DATA_FILE: plain.gz\n", {"plain.gz"});
        row("bytes", QByteArray("a: \0b\n", 6), {"line 1"});
    }
    void refuses()
    {
        QFETCH(QByteArray, header);
        QFETCH(QList<QByteArray>, words);
        QVERIFY(!folder_.write("volume.values", countingBytes<float>(std::endian::little)).empty());
        QVERIFY(!folder_.write("plain.gz", countingBytes<float>(std::endian::little)).empty());
        QCOMPARE(refusalFault(folder_.write("volume.bov", header), words), QByteArray());
    }

    void refusesWhatTheHeaderTells()
    {
        QVERIFY(!folder_.write("volume.values", countingBytes<float>(std::endian::little)).empty());
        const auto path = folder_.write("volume.bov", bov(""));
        QCOMPARE(refusalFault(path, {"states its spacing itself"}, {{"spacing", std::string("1x1x1")}}), QByteArray());
        QCOMPARE(refusalFault(path, {"'--type'"}, {{"type", std::string("float")}}), QByteArray());
        QVERIFY(readFormat(path, text_, {{"unit", std::string("m")}, {"array", std::string("density")}}));
    }

    void knowsItsOtherFile()
    {
        const auto path = folder_.write("volume.bov", bov(""));
        const auto names = asLoaded<LatticeReader>().companions(path, {});
        QCOMPARE(names.size(), std::size_t(1));
        QVERIFY(names.front() == folder_.path() / "volume.values");
    }

    void theSharedCase()
    {
        const auto path = sharedCases() / "other" / "vol.bov";
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = readFormat(path, text_);
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{9, 11, 13}));
        QVERIFY(distanceFromWorld(*dataset, 3) < 1e-5);
    }

private:
    std::optional<Dataset> read(const QByteArray& header, const QByteArray& numbers, const ParameterValues& values = {})
    {
        if (!numbers.isEmpty() && folder_.write("volume.values", numbers).empty())
            return {};
        return readFormat(folder_.write("volume.bov", header), text_, values);
    }

    TestFolder folder_;
    QByteArray text_;
};

QTEST_GUILESS_MAIN(BovReaderTest)
#include "bov_reader_test.moc"
