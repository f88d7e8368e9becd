// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of a NRRD file lie in the world where its header says (D1), whatever its axes do, and in whatever files
// they are.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QtTest>

#include <fstream>
#include <iterator>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::uint32_t, 3> testSize{4, 3, 5};

QByteArray vectorText(const Eigen::Vector3d& vector)
{
    return QByteArray::fromStdString("(" + formatNumber(vector[0]) + "," + formatNumber(vector[1]) + "," +
                                     formatNumber(vector[2]) + ")");
}

QByteArray worldFile(const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin, const QByteArray& more = "")
{
    return nrrdHeader("sizes: 4 3 5\ntype: float\nendian: little\n" + more +
                      "space directions: " + vectorText(steps.col(0)) + " " + vectorText(steps.col(1)) + " " +
                      vectorText(steps.col(2)) + "\nspace origin: " + vectorText(origin) + "\n") +
           samplesOfWorld(testSize, steps, origin, 10);
}

std::string bytesOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class NrrdPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void sharedCasesLieWhereTheySay_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("space");
        QTest::newRow("Slicer's MRHead") << "nrrd/mrhead_like.nrrd" << QByteArray("LPS");
        QTest::newRow("backwards along x and y") << "nrrd/flip_xy.nrrd" << QByteArray("LPS");
    }
    void sharedCasesLieWhereTheySay()
    {
        QFETCH(QString, file);
        const fs::path path = sharedCases() / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QTEST(QByteArray::fromStdString(dataset->space), "space");
        QVERIFY(!dataset->lattice.isAlongAxes());
    }

    /// What a header says of the samples, and which of two places is taken, is told by read() and probe() (D3).
    void whatIsTakenIsTold()
    {
        const auto check = [&](const QByteArray& more, const QStringList& taken, const QStringList& leftOut) {
            QTemporaryDir folder;
            const fs::path path = folder.filePath("a.nrrd").toStdString();
            const QByteArray file = worldFile(Eigen::Matrix3d::Identity(), {1, 2, 3}, more);
            std::ofstream(path, std::ios::binary).write(file.data(), file.size());
            const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            const auto contents = asLoaded<LatticeReader>().probe(path, {}, {});
            QVERIFY(contents && contents->taken == dataset->source.taken);
            QVERIFY(contents->leftOut == dataset->source.leftOut);
            QStringList takenTexts, leftOutTexts;
            for (const Taken& part : dataset->source.taken)
                takenTexts << QString::fromStdString(takenText(part).text());
            for (const Message& sentence : dataset->source.leftOut)
                leftOutTexts << QString::fromStdString(sentence.text());
            QCOMPARE(takenTexts, taken);
            QCOMPARE(leftOutTexts, leftOut);
            QVERIFY(distanceFromWorld(*dataset, 10) < 1e-6);
        };
        const QString frame = "frame: space directions";
        check("space: LPS\n", {frame}, {});
        check("space: LPS\nsample units: \"HU\"\n", {frame, "unit of the values: HU"}, {});
        check("space: LPS\nsample units: kg/m^3\n", {frame, "unit of the values: kg/m^3"}, {});
        check("space: LPS\nsample units: \"\"\nmeasurement frame: (1,0,0) (0,1,0) (0,0,1)\n", {frame}, {});
        check("space: LPS\nold min: -1\nold max: 2.5\n", {frame},
              {"Its samples stand for numbers from -1 to 2.5 ('old min', 'old max'), from which they were quantized; "
               "they are used as stored."});
    }

    /// Steps along the axes are exact, also in their zeros, and the samples stay in the file's order.
    void everyOrderOfAxes()
    {
        const Eigen::Vector3d lengths(0.1, 4, 1.0 / 3), origin(10, -20.5, 1e3);
        const auto frames = signedPermutations();
        QCOMPARE(frames.size(), std::size_t(48));
        for (const Eigen::Matrix3d& directions : frames) {
            const Eigen::Matrix3d steps = directions * lengths.asDiagonal();
            const auto dataset = read(worldFile(steps, origin));
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->lattice.size == testSize);
            QVERIFY(dataset->lattice.spacing == lengths);
            QVERIFY(dataset->lattice.origin == origin);
            QVERIFY(dataset->lattice.directions == directions);
            QVERIFY(!((dataset->lattice.directions.array() == 0) &&
                      dataset->lattice.directions.array().unaryExpr(
                          [](double x) { return std::signbit(x) ? 1.0 : 0.0; }) != 0)
                         .any());
            QCOMPARE(dataset->lattice.isAlongAxes(), directions == frames.front());
            QCOMPARE(dataset->lattice.isLeftHanded(), directions.determinant() < 0);
            QVERIFY(distanceFromWorld(*dataset, 10) < 1e-3);
        }
    }

    void turnedAndSheared()
    {
        std::srand(7); // of Eigen's Random()
        int sheared = 0;
        for (int i = 0; i < 100; ++i) {
            const Eigen::Matrix3d steps = Eigen::Matrix3d::Random() * std::pow(10, i % 7 - 3);
            if (std::abs(steps.colwise().normalized().determinant()) < 0.01)
                continue;
            ++sheared;
            const Eigen::Vector3d origin = Eigen::Vector3d::Random() * 100;
            const auto dataset = read(worldFile(steps, origin));
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->domain == DomainClass::RegularLattice);
            for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
                const auto [a, b, c] = dataset->lattice.coordinates(point);
                const Eigen::Vector3d place = origin + steps * Eigen::Vector3d(a, b, c);
                QVERIFY((dataset->position(point) - place).norm() <= 1e-14 * (100 + place.norm()));
            }
        }
        QVERIFY(sheared > 80);
    }

    /// What programs that multiply matrices leave where a zero should be.
    void roundingsAreNoDirections()
    {
        const Eigen::Matrix3d steps = Eigen::Vector3d(0.5, 0.5, 2).asDiagonal() *
                                      (Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(1e-17));
        const auto dataset = read(worldFile(steps, {0, 0, 0}));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->lattice.isAlongAxes());
        QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(0.5, 0.5, 2));
        const Eigen::Matrix3d small = Eigen::Matrix3d::Identity() + Eigen::Matrix3d::Constant(1e-9);
        QVERIFY(!read(worldFile(small, {0, 0, 0}))->lattice.isAlongAxes());
    }

    void fallingAxesRunBackwards_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<double>("x"); // of the points 0 and 1 along x
        QTest::addColumn<double>("next");
        QTest::newRow("spacings") << QByteArray("spacings: -2 1 1\n") << 0.0 << -2.0;
        QTest::newRow("minimum") << QByteArray("spacings: -2 1 1\naxis mins: 7 0 0\n") << 7.0 << 5.0;
        QTest::newRow("minimum above maximum") << QByteArray("axis mins: 6 0 0\naxis maxs: 2 6 8\n") << 6.0 << 4.0;
        QTest::newRow("of cells") << QByteArray("axis mins: 6 0 0\naxis maxs: 0 8 10\ncenters: cell cell cell\n") << 5.0
                                  << 3.0;
    }
    void fallingAxesRunBackwards()
    {
        QFETCH(QByteArray, fields);
        const auto dataset = read(nrrdHeader(fields) + testSamples(SampleType::UInt8));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QTEST(dataset->position(0)[0], "x");
        QTEST(dataset->position(1)[0], "next");
        QVERIFY(dataset->lattice.isLeftHanded());
        QVERIFY(holdsTestSamples(dataset->values));
    }

    void knowsTheSpace_data()
    {
        QTest::addColumn<QByteArray>("space");
        QTest::addColumn<QByteArray>("letters");
        const auto row = [](const char* space, const char* letters) {
            QTest::newRow(space) << QByteArray(space) << QByteArray(letters);
        };
        row("right-anterior-superior", "RAS");
        row("RAS", "RAS");
        row("left-anterior-superior", "LAS");
        row("LAS", "LAS");
        row("left-posterior-superior", "LPS");
        row("Left-Posterior-Superior", "LPS");
        row("LPS", "LPS");
        row("scanner-xyz", "");
        row("3D-right-handed", "");
        row("3D-left-handed", "");
    }
    void knowsTheSpace()
    {
        QFETCH(QByteArray, space);
        const auto dataset = read(worldFile(Eigen::Matrix3d::Identity(), {1, 2, 3},
                                            "space: " + space + "\nspace units: \"mm\" \"mm\" \"mm\"\n"));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QTEST(QByteArray::fromStdString(dataset->space), "letters");
        const auto aside = read(nrrdHeader("space: " + space + "\nspacings: 1 1 1\n") + testSamples(SampleType::UInt8));
        QVERIFY(aside.ok());
        QVERIFY(aside->space.empty()); // nothing says how its axes lie there
    }

    void theUserSaysWhatTheHeaderDoesNot()
    {
        const QByteArray samples = testSamples(SampleType::UInt8);
        const ParameterValues spacing{{"spacing", std::string("0.5x0.25x2")}},
            origin{{"origin", std::string("1,2,-3")}};
        ParameterValues both = spacing;
        both.insert(origin.begin(), origin.end());
        const auto bare = readWith(nrrdHeader("") + samples, both);
        QVERIFY2(bare.ok(), bare.ok() ? "" : bare.error().text().c_str());
        QVERIFY(bare->lattice.spacing == Eigen::Vector3d(0.5, 0.25, 2));
        QVERIFY(bare->lattice.origin == Eigen::Vector3d(1, 2, -3));
        QVERIFY(bare->remarks.empty());
        const auto assumed = read(nrrdHeader("") + samples);
        QVERIFY(assumed.ok() && assumed->remarks.size() == 1);
        QVERIFY(assumed->remarks[0].text().find("1 x 1 x 1 is assumed") != std::string::npos);
        const auto placed = readWith(nrrdHeader("spacings: 1 2 3\n") + samples, origin);
        QVERIFY2(placed.ok(), placed.ok() ? "" : placed.error().text().c_str());
        QVERIFY(placed->lattice.spacing == Eigen::Vector3d(1, 2, 3));
        QVERIFY(placed->lattice.origin == Eigen::Vector3d(1, 2, -3));
        QVERIFY(placed->remarks.empty());
        QVERIFY(readWith(nrrdHeader("spacings: nan nan nan\naxis mins: nan nan nan\n") + samples, both).ok());
        const auto refused = [&](const QByteArray& fields, const ParameterValues& values, const char* words) {
            const auto dataset = readWith(nrrdHeader(fields) + samples, values);
            return !dataset && dataset.error().kind == ErrorKind::WrongUsage &&
                   dataset.error().text().find(words) != std::string::npos;
        };
        QVERIFY(refused("spacings: 1 2 3\n", spacing, "'--spacing' out"));
        QVERIFY(refused("axis mins: 0 0 0\naxis maxs: 2 3 4\n", spacing, "'--spacing' out"));
        QVERIFY(refused("axis mins: 0 0 0\n", origin, "'--origin' out"));
        const QByteArray directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
        QVERIFY(refused(directions, spacing, "'--spacing' out"));
        QVERIFY(readWith(nrrdHeader(directions) + samples, origin).ok());
        QVERIFY(refused(directions + "space origin: (0,0,0)\n", origin, "'--origin' out"));
        const ParameterValues unit{{"unit", std::string("um")}};
        const auto measured = readWith(nrrdHeader(directions) + samples, unit);
        QVERIFY(measured.ok() && measured->lengthUnit == "um");
        QVERIFY(refused("units: \"mm\" \"mm\" \"mm\"\n", unit, "'--unit' out"));
        QVERIFY(refused("", {{"spacing", std::string("1x2")}}, "Give three numbers"));
        QVERIFY(!readWith(nrrdHeader("") + samples, {{"spacing", std::string("1x0x1")}}).ok());
    }

    /// Half a cell before the first point is half of the spacing that the user says.
    void theFirstCellBeginsWhereTheHeaderSays()
    {
        const QByteArray file =
            nrrdHeader("centers: cell cell cell\naxis mins: 0 10 -4\n") + testSamples(SampleType::UInt8);
        const auto assumed = read(file);
        QVERIFY2(assumed.ok(), assumed.ok() ? "" : assumed.error().text().c_str());
        QVERIFY(assumed->lattice.origin == Eigen::Vector3d(0.5, 10.5, -3.5));
        const auto placed = readWith(file, {{"spacing", std::string("0.5x2x4")}});
        QVERIFY2(placed.ok(), placed.ok() ? "" : placed.error().text().c_str());
        QVERIFY(placed->lattice.spacing == Eigen::Vector3d(0.5, 2, 4));
        QVERIFY(placed->lattice.origin == Eigen::Vector3d(0.25, 11, -2));
    }

    /// What no picture of it shows.
    void whatIsUnusualIsTold()
    {
        const QByteArray directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
        const QByteArray samples = testSamples(SampleType::UInt8);
        const auto remarksOf = [&](const QByteArray& fields) {
            const auto dataset = read(nrrdHeader(fields) + samples);
            QByteArray told;
            for (const Message& remark : dataset ? dataset->remarks : std::vector<Message>())
                told += QByteArray::fromStdString(remark.text());
            return dataset ? told : QByteArray::fromStdString(dataset.error().text());
        };
        QCOMPARE(remarksOf("space: RAS\n" + directions), QByteArray());
        for (const char* const space : {"left-anterior-superior", "LAS", "3D-left-handed"}) {
            const QByteArray told = remarksOf(QByteArray("space: ") + space + "\n" + directions);
            QVERIFY2(told.contains("left-handed") && told.contains(space), told);
        }
        const QByteArray mixed = remarksOf(directions + "space units: \"mm\" \"mm\" \"cm\"\n");
        QVERIFY2(mixed.contains("cm") && mixed.contains("as they are"), mixed);
    }

    void tinyHugeAndFarPlacesAreRefused()
    {
        for (const char* const steps : {"1e-170 1e-170 1e-170", "1e170 1e170 1e170"}) {
            const auto dataset =
                read(nrrdHeader(QByteArray("spacings: ") + steps + "\n") + testSamples(SampleType::UInt8));
            QVERIFY(!dataset.ok());
            QVERIFY2(dataset.error().text().find("too large or small") != std::string::npos,
                     dataset.error().text().c_str());
        }
    }

    /// Before a name is made of them.
    void patternsOfTooManyFilesAreRefused()
    {
        for (const char* const pattern :
             {"sizes: 3 4 1073741823\ndata file: s%d 1 1073741823 1\n",
              "sizes: 3 4 900000000\ndata file: s%999d 1 900000000 1\n", "data file: s%d 0 -9223372036854775808 -1\n",
              "data file: s%d -9223372036854775808 0 -1\n"}) {
            QByteArray header = nrrdHeader(pattern);
            const auto dataset = read(header);
            QVERIFY(!dataset.ok());
            QVERIFY2(dataset.error().text().find("data file") != std::string::npos, dataset.error().text().c_str());
        }
    }

    void knowsTheUnit_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<QByteArray>("unit");
        const QByteArray directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
        QTest::newRow("of the space") << directions + "space units: \"mm\" \"mm\" \"mm\"\n" << QByteArray("mm");
        QTest::newRow("of a space with time")
            << QByteArray("space: RAST\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,1,0)\n"
                          "space units: \"mm\" \"mm\" \"mm\" \"ms\"\n")
            << QByteArray("mm");
        QTest::newRow("of the axes") << QByteArray("units: \"um\" \"um\" \"um\"\n") << QByteArray("um");
        QTest::newRow("of the axes with points")
            << QByteArray("dimension: 4\nsizes: 1 3 4 5\nunits: \"\" \"um\" \"um\" \"um\"\n") << QByteArray("um");
        QTest::newRow("several") << directions + "space units: \"mm\" \"mm\" \"cm\"\n" << QByteArray();
        QTest::newRow("too few") << directions + "space units: \"mm\" \"mm\"\n" << QByteArray();
        QTest::newRow("not closed") << directions + "space units: \"mm\" \"mm\" \"mm\n" << QByteArray("mm");
        QTest::newRow("none") << directions << QByteArray();
    }
    void knowsTheUnit()
    {
        QFETCH(QByteArray, fields);
        const auto dataset = read(nrrdHeader(fields) + testSamples(SampleType::UInt8));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QTEST(QByteArray::fromStdString(dataset->lengthUnit), "unit");
    }

    /// Vectors have four numbers there.
    void spacesWithTime()
    {
        const QByteArray samples = testSamples(SampleType::UInt8);
        for (const char* space : {"right-anterior-superior-time", "RAST"}) {
            const auto dataset = read(
                nrrdHeader(QByteArray("dimension: 4\nsizes: 3 4 5 1\nspace: ") + space +
                           "\nspace directions: (0,2,0,0) (-1,0,0,0) (0,0,3,0) (0,0,0,1)\nspace origin: (1,2,3,4)\n") +
                samples);
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->space, std::string("RAS"));
            QVERIFY(dataset->position(0) == Eigen::Vector3d(1, 2, 3));
            QVERIFY(dataset->position(1) == Eigen::Vector3d(1, 4, 3));
        }
        const auto film =
            read(nrrdHeader("space: scanner-xyz-time\nspace directions: (1,0,0,0) (0,1,0,0) (0,0,0,1)\n") + samples);
        QVERIFY(!film.ok());
        QVERIFY2(film.error().text().find("is time") != std::string::npos, film.error().text().c_str());
    }

    /// NaN is how 'none' was written before.
    void unknownDirectionsAreNone()
    {
        const auto dataset = read(nrrdHeader("dimension: 4\nsizes: 1 3 4 5\nkinds: vector domain domain domain\n"
                                             "space directions: (nan,nan,nan) (0,1,0) (1,0,0) (0,0,-1)\n") +
                                  testSamples(SampleType::UInt8));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->position(1) == Eigen::Vector3d(0, 1, 0));
    }

    void samplesInSeveralFiles_data()
    {
        QTest::addColumn<QByteArray>("fields");
        QTest::addColumn<int>("files"); // of equally many samples each
        QTest::addColumn<QByteArray>("encoding");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("step");
        const auto row = [](const char* name, const char* fields, int files, const char* encoding, int first = 0,
                            int step = 1) {
            QTest::newRow(name) << QByteArray(fields) << files << QByteArray(encoding) << first << step;
        };
        row("list", "data file: LIST\n", 5, "raw");
        row("list, gzip", "data file: LIST\n", 5, "gzip");
        row("list, text", "data file: LIST\n", 5, "text");
        row("list of rows", "data file: LIST 1\n", 20, "raw");
        row("list of one volume", "data file: LIST 3\n", 1, "raw");
        row("list of halves", "sizes: 3 5 4\ndata file: LIST 3\n", 2, "raw");
        row("list in four dimensions", "dimension: 4\nsizes: 1 3 4 5\ndata file: LIST\n", 5, "raw");
        row("pattern", "data file: part%02d.bin 0 4 1\n", 5, "raw");
        row("pattern, gzip", "data file: part%02d.bin 7 15 2\n", 5, "gzip", 7, 2);
        row("pattern downwards", "data file: part%02d.bin 40 20 -5\n", 5, "raw", 40, -5);
        row("pattern with dimensions", "data file: part%02d.bin 0 4 1 2\n", 5, "raw");
        row("skips in each", "byte skip: 3\nline skip: 1\ndata file: LIST\n", 5, "raw");
    }
    void samplesInSeveralFiles()
    {
        QFETCH(QByteArray, fields);
        QFETCH(int, files);
        QFETCH(QByteArray, encoding);
        QFETCH(int, first);
        QFETCH(int, step);
        const TestFolder folder;
        const QByteArray samples = testSamples(SampleType::UInt8);
        QByteArray names;
        for (int file = 0; file < files; ++file) {
            const QByteArray name = "part" + QByteArray::number(first + file * step).rightJustified(2, '0') + ".bin";
            QByteArray content = samples.mid(file * samples.size() / files, samples.size() / files);
            if (encoding == "gzip")
                content = gzipped(content);
            if (encoding == "text") {
                QByteArray text;
                for (const char sample : content)
                    text += QByteArray::number(int(sample)) + "\n";
                content = text;
            }
            if (fields.contains("skip"))
                content = "a line\nabc" + content;
            QVERIFY(!folder.write(name, content).empty());
            names += name + "\n";
        }
        QByteArray header = nrrdHeader("encoding: " + encoding + "\n" + fields);
        header.chop(1);
        if (fields.contains("LIST")) { // the names are the end of the header
            const auto begin = header.indexOf("data file:"), end = header.indexOf('\n', begin) + 1;
            const QByteArray line = header.mid(begin, end - begin);
            header = header.remove(begin, end - begin) + line + names;
        }
        const fs::path path = folder.write("volume.nhdr", header);
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(holdsTestSamples(dataset->values));
        const auto contents = asLoaded<LatticeReader>().probe(path, {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->points, std::uint64_t(60));
        if (files == 1)
            return;
        const fs::path last =
            folder.path() /
            ("part" + QByteArray::number(first + (files - 1) * step).rightJustified(2, '0') + ".bin").toStdString();
        fs::resize_file(last, fs::file_size(last) / 2);
        const auto cut = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY(!cut.ok());
        QVERIFY2(cut.error().text().find(last.filename()) != std::string::npos, cut.error().text().c_str());
        fs::remove(last);
        const auto missing = asLoaded<LatticeReader>().probe(path, {}, {});
        QVERIFY(!missing.ok());
        QVERIFY2(missing.error().text().find(last.filename()) != std::string::npos, missing.error().text().c_str());
    }

    void sharedCasesOfSeveralFiles()
    {
        const fs::path folder = sharedCases() / "nrrd";
        if (!fs::exists(folder / "list.nhdr"))
            QSKIP_WITHOUT("../shared/cases");
        std::string samples;
        for (int slice = 0; slice < 13; ++slice)
            samples += bytesOf(folder / QString::asprintf("sl%02d.raw", slice).toStdString());
        for (const char* name : {"list.nhdr", "pattern.nhdr"}) {
            const auto dataset = asLoaded<LatticeReader>().read(folder / name, {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY((dataset->lattice.size == std::array<std::uint32_t, 3>{9, 11, 13}));
            QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(1, 2, 3));
            const auto bytes = dataset->values.bytes();
            QVERIFY(samples == std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        }
    }

private:
    Result<Dataset> read(const QByteArray& file) { return readWith(file, {}); }
    Result<Dataset> readWith(const QByteArray& file, const ParameterValues& values)
    {
        return asLoaded<LatticeReader>().read(folder_.write("volume.nrrd", file), values, {});
    }

    TestFolder folder_;
};

QTEST_GUILESS_MAIN(NrrdPlacesTest)
#include "nrrd_places_test.moc"
