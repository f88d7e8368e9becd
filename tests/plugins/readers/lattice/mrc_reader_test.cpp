// SPDX-License-Identifier: GPL-3.0-or-later
// MRC and CCP4 maps: every mode, both byte orders, every order of axes, cells with angles, and what places the first
// sample (D1, D3). Files are written byte by byte; each sample is a known function of its place, or its number.
#include "plugins/host/dataset_opening.h"
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/header_files.h"
#include "tests/plugins/readers/lattice/told.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::uint32_t, 3> testSize{3, 4, 5};

QByteArray worldOf(const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin)
{
    return samplesOfWorld(testSize, steps, origin, 10);
}

} // namespace

class MrcReaderTest : public QObject {
    Q_OBJECT

private slots:
    void sharedCaseOfColumnsAlongZ()
    {
        const fs::path path = sharedCases() / "mrc" / "zyx.mrc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY2(distanceFromWorld(*dataset, 10) < 1e-4, QByteArray::number(distanceFromWorld(*dataset, 10)));
    }

    /// Its samples are those of a box; its cell has an angle of 120 degrees between x and y.
    void sharedCaseWithAnAngle()
    {
        const fs::path path = sharedCases() / "mrc" / "skew.mrc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        const Eigen::Vector3d leaning(-1.5, std::sqrt(6.75), 0); // 3 long
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const auto [i, j, k] = dataset->lattice.coordinates(point);
            QVERIFY(std::abs(dataset->values.at(point) -
                             worldFunction(Eigen::Vector3d(4.0 * i, 3.0 * j, 2.0 * k), 10)) < 1e-4);
            QVERIFY((dataset->position(point) - Eigen::Vector3d(4.0 * i, 0, 2.0 * k) - leaning * static_cast<double>(j))
                        .norm() < 1e-9);
        }
    }

    void sharedCaseOfShorts()
    {
        const fs::path path = sharedCases() / "mrc" / "uint16.mrc";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.type() == SampleType::UInt16);
        QCOMPARE(dataset->values.range().minimum, 0.);
        double largest = 0;
        const double shift = worldFunction(dataset->position(0), 10) - dataset->values.at(0) / 100;
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
            largest = std::max(largest, std::abs(worldFunction(dataset->position(point), 10) - shift -
                                                 dataset->values.at(point) / 100));
        QVERIFY2(largest < 0.03, QByteArray::number(largest));
    }

    /// The lengths of the cell and its grid are those of x, y and z; sizes and starts those of columns, rows, sections.
    void everyOrderOfAxes()
    {
        std::array<int, 3> axes{1, 2, 3};
        do
            for (const std::endian order : {std::endian::little, std::endian::big}) {
                MrcFields fields{.order = order, .start = {2, -3, 4}, .axes = {axes[0], axes[1], axes[2]}};
                fields.grid = {10, 20, 40};
                fields.cell = {5, 40, 10};
                const Eigen::Vector3d lengths(0.5, 2, 0.25);
                Eigen::Matrix3d steps = Eigen::Matrix3d::Zero();
                for (int i = 0; i < 3; ++i)
                    steps(axes[static_cast<std::size_t>(i)] - 1, i) = lengths[axes[static_cast<std::size_t>(i)] - 1];
                const Eigen::Vector3d origin = steps * Eigen::Vector3d(2, -3, 4);
                QByteArray samples = worldOf(steps, origin);
                if (order == std::endian::big)
                    samples = turnedRound(samples, 4);
                const auto dataset = read(mrcHeader(fields) + samples);
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->lattice.size == testSize);
                QVERIFY(dataset->lattice.origin == origin);
                QVERIFY(distanceFromWorld(*dataset, 10) < 1e-5);
                QCOMPARE(dataset->lattice.isAlongAxes(), (axes == std::array{1, 2, 3}));
                QCOMPARE(dataset->lengthUnit, std::string("angstrom"));
                QCOMPARE(takenOf(dataset->source.taken, TakenPart::Frame),
                         std::string("frame: NXSTART, NYSTART, NZSTART"));
                QVERIFY(dataset->remarks.empty() && dataset->source.leftOut.empty());
            }
        while (std::ranges::next_permutation(axes).found);
    }

    /// a along x, b in the plane of x and y: by its angles the cell has this volume and these products of its edges.
    void cellsWithAngles()
    {
        for (const std::array<float, 3>& angles :
             {std::array{90.F, 94.3F, 90.F}, {90.F, 90.F, 120.F}, {80.F, 75.F, 110.F}}) {
            MrcFields fields{.angles = angles};
            fields.cell = {6, 4, 10};
            const auto dataset = read(mrcHeader(fields) + testSamples(SampleType::Float32));
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            const auto edge = [&](int i) -> Eigen::Vector3d {
                return dataset->lattice.directions.col(i) * dataset->lattice.spacing[i];
            };
            const auto angle = [&](int i, int j) {
                return std::acos(edge(i).normalized().dot(edge(j).normalized())) * 180 / std::numbers::pi;
            };
            QVERIFY(edge(0).isApprox(Eigen::Vector3d(2, 0, 0), 1e-12));
            QVERIFY(edge(1)[2] == 0 && edge(1)[1] > 0 && edge(2)[2] > 0);
            QVERIFY(std::abs(edge(1).norm() - 1) < 1e-12 && std::abs(edge(2).norm() - 2) < 1e-12);
            QVERIFY(std::abs(angle(1, 2) - static_cast<double>(angles[0])) < 1e-9);
            QVERIFY(std::abs(angle(0, 2) - static_cast<double>(angles[1])) < 1e-9);
            QVERIFY(std::abs(angle(0, 1) - static_cast<double>(angles[2])) < 1e-9);
        }
    }

    void whatPlacesTheFirstSampleIsTold()
    {
        MrcFields fields{.origin = {1.5, -2, 3}};
        const Eigen::Vector3d origin(1.5, -2, 3);
        const auto byOrigin = read(mrcHeader(fields) + worldOf(Eigen::Matrix3d::Identity(), origin));
        QVERIFY(byOrigin.ok() && distanceFromWorld(*byOrigin, 10) < 1e-5);
        QCOMPARE(takenOf(byOrigin->source.taken, TakenPart::Frame), std::string("frame: ORIGIN"));
        fields.start = {7, 0, 0};
        const auto both = read(mrcHeader(fields) + worldOf(Eigen::Matrix3d::Identity(), origin));
        QVERIFY(both.ok() && distanceFromWorld(*both, 10) < 1e-5);
        QCOMPARE(takenOf(both->source.taken, TakenPart::Frame), std::string("frame: ORIGIN (a guess)"));
        QVERIFY(says(both->source.leftOut, "(7, 0, 0) the first sample would lie at 7, 0, 0; its ORIGIN was used"));
        fields.origin = {7, 0, 0}; // they agree
        QVERIFY(read(mrcHeader(fields) + testSamples(SampleType::Float32))->source.leftOut.empty());
        fields.start = {};
        fields.imodFlags = 1;
        QVERIFY(says(read(mrcHeader(fields) + testSamples(SampleType::Float32))->source.leftOut, "the negative of it"));
        fields.imodFlags = 5;
        QVERIFY(read(mrcHeader(fields) + testSamples(SampleType::Float32))->source.leftOut.empty());
        const auto contents = probe(mrcHeader(fields) + testSamples(SampleType::Float32));
        QVERIFY(contents.ok() && takenOf(contents->taken, TakenPart::Frame) == "frame: ORIGIN");
        fields.origin = {std::numeric_limits<float>::quiet_NaN(), 0, 0};
        QVERIFY(
            says(read(mrcHeader(fields) + testSamples(SampleType::Float32))->source.leftOut, "not a finite number"));
    }

    void everyModeInBothOrders()
    {
        constexpr std::array<std::pair<int, SampleType>, 4> modes = {
            {{0, SampleType::Int8}, {1, SampleType::Int16}, {2, SampleType::Float32}, {6, SampleType::UInt16}}};
        for (const auto& [mode, type] : modes)
            for (const std::endian order : {std::endian::little, std::endian::big}) {
                const auto dataset = read(mrcHeader({.order = order, .mode = mode, .extension = QByteArray(160, 'x')}) +
                                          testSamples(type, order));
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->values.type() == type);
                QVERIFY(holdsTestSamples(dataset->values));
                QCOMPARE(dataset->mappedFile != nullptr, order == std::endian::native || sampleSize(type) == 1);
            }
        // Halves: 1, 1.5, -2, the largest, the smallest and none.
        QByteArray halves;
        for (const std::uint16_t bits : {0x3c00, 0x3e00, 0xc000, 0x7bff, 0x0001, 0x0000})
            halves += numberBytes(bits);
        halves += QByteArray(2 * (testPoints - 6), '\0');
        const auto dataset = read(mrcHeader({.mode = 12}) + halves);
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->values.type() == SampleType::Float32);
        const std::array<double, 6> values{1, 1.5, -2, 65504, std::ldexp(1.0, -24), 0};
        for (std::size_t n = 0; n < values.size(); ++n)
            QCOMPARE(dataset->values.at(n), values[n]);
        halves.replace(2, 2, numberBytes(std::uint16_t(0x7c00))); // infinite
        QCOMPARE(read(mrcHeader({.mode = 12}) + halves)->values.notFiniteCount(), std::uint64_t(1));
    }

    void bytesAreSignedUnlessTheHeaderSaysOtherwise()
    {
        const QByteArray samples = QByteArray(1, '\xff') + QByteArray(testPoints - 1, '\1');
        const auto first = [&](const MrcFields& fields) { return read(mrcHeader(fields) + samples); };
        QCOMPARE(first({.mode = 0})->values.at(0), -1.);
        QVERIFY(first({.mode = 0})->remarks.empty());
        QCOMPARE(first({.mode = 0, .imodFlags = 1})->values.at(0), -1.);
        const auto ofImod = first({.mode = 0, .imodFlags = 0});
        QCOMPARE(ofImod->values.at(0), 255.);
        QVERIFY(says(ofImod->remarks, "IMOD's flag"));
        const auto old = first({.mode = 0, .least = 1, .most = 255});
        QCOMPARE(old->values.at(0), 255.);
        QVERIFY(says(old->remarks, "the largest value is 255"));
    }

    void complexAndColoursHaveComponents()
    {
        const QByteArray samples = counted<std::int16_t>(2 * testPoints, 0);
        const auto real = readWith(mrcHeader({.mode = 3}) + samples, {{"component", std::string("1")}});
        QVERIFY2(real.ok(), real.ok() ? "" : real.error().text().c_str());
        QCOMPARE(real->values.at(3), 7.);
        QVERIFY(says(real->remarks, "complex numbers (mode 3)"));
        QVERIFY(read(mrcHeader({.mode = 4}) + counted<float>(2 * testPoints, 0)).ok());
        const auto blue = readWith(mrcHeader({.mode = 16}) + counted<std::uint8_t>(3 * testPoints, 0),
                                   {{"component", std::string("2")}});
        QCOMPARE(blue->values.at(3), 11.);
    }

    void stacksOfVolumes()
    {
        MrcFields fields{.size = {3, 4, 10}, .spaceGroup = 401};
        const QByteArray file = mrcHeader(fields) + counted<float>(2 * testPoints, 0);
        const auto second = readWith(file, {{"time", std::int64_t(2)}});
        QVERIFY2(second.ok(), second.ok() ? "" : second.error().text().c_str());
        QVERIFY(second->lattice.size == testSize);
        QCOMPARE(second->values.at(0), 60.);
        QVERIFY(says(second->source.leftOut, "It holds 2 volumes"));
        fields.spaceGroup = 0;
        fields.grid = {3, 4, 1};
        const auto pictures = read(mrcHeader(fields) + counted<float>(2 * testPoints, 0));
        QVERIFY(pictures.ok() && says(pictures->source.leftOut, "a stack of 10 pictures"));
    }

    void headersThatAreNotWhatTheyShouldBe()
    {
        const QByteArray samples = testSamples(SampleType::Float32);
        // The order of bytes by the numbers, where the stamp of the machine says nothing, or another one.
        for (const QByteArray& machine : {QByteArray(2, '\0'), QByteArray("\x11\x11")}) {
            const auto dataset = read(mrcHeader({.machine = machine}) + samples);
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(holdsTestSamples(dataset->values));
            QVERIFY(says(dataset->remarks, "little endian"));
        }
        const auto noAxes = read(mrcHeader({.axes = {0, 0, 0}, .stamp = QByteArray(4, '\0')}) + samples);
        QVERIFY(noAxes.ok() && noAxes->lattice.isAlongAxes());
        QVERIFY(says(read(mrcHeader({.axes = {1, 1, 3}}) + samples)->source.leftOut, "which is impossible"));
        QVERIFY(says(read(mrcHeader({.angles = {10, 10, 170}}) + samples)->source.leftOut, "which no cell has"));
        const auto noAngles = read(mrcHeader({.angles = {0, 0, 0}}) + samples);
        QVERIFY(noAngles.ok() && noAngles->lattice.isAlongAxes() && noAngles->source.leftOut.empty());
        // Without a cell nothing is told of distances.
        const QByteArray bare = mrcHeader({.start = {0, 0, 2}, .cell = {0, 0, 0}}) + samples;
        const auto assumed = read(bare);
        QVERIFY(assumed.ok() && says(assumed->remarks, "1 x 1 x 1 is assumed") && assumed->lengthUnit.empty());
        const auto placed = readWith(bare, {{"spacing", std::string("2,2,3")}});
        QVERIFY(placed.ok() && placed->lattice.origin == Eigen::Vector3d(0, 0, 6));
        QVERIFY(readWith(mrcHeader({}) + samples, {{"spacing", std::string("2,2,3")}}).error().kind ==
                ErrorKind::WrongUsage);
    }

    void refusalsAreTrue()
    {
        const QByteArray samples = testSamples(SampleType::Float32);
        for (const auto& [fields, words] : {std::pair{MrcFields{.mode = 101}, "four bits"},
                                            {MrcFields{.mode = 7}, "mode 7"},
                                            {MrcFields{.size = {3, 0, 5}}, "3 x 0 x 5 points"},
                                            {MrcFields{.size = {3, 4, 1}}, "at least 2 along each axis"},
                                            {MrcFields{.size = {3, 4, 6}}, "288 bytes, but there are only 240 bytes"},
                                            {MrcFields{.size = {1 << 30, 1 << 30, 1 << 30}}, "points"}}) {
            const auto dataset = read(mrcHeader(fields) + samples);
            QVERIFY(!dataset.ok());
            QVERIFY2(dataset.error().text().find(words) != std::string::npos, dataset.error().text().c_str());
            QVERIFY(probe(mrcHeader(fields) + samples).error().text() == dataset.error().text());
        }
        QByteArray negative = mrcHeader({}) + samples;
        negative.replace(92, 4, numberBytes(std::int32_t(-8)));
        QVERIFY(says({read(negative).error().message}, "an extension of -8 bytes"));
    }

    void cutFilesAreRefused()
    {
        const QByteArray file =
            mrcHeader({.mode = 1, .extension = QByteArray(80, ' ')}) + testSamples(SampleType::Int16);
        for (qsizetype size = 0; size<file.size(); size += size> 1000 ? 1 : 7)
            QVERIFY2(!read(file.first(size)).ok(), QByteArray::number(size));
        QVERIFY(says(read(file + "xyz")->source.leftOut, "3 bytes after its samples"));
    }

    void packedMapsOpen()
    {
        const auto path = folder_.write("map.ccp4.gz", gzipped(mrcHeader({}) + testSamples(SampleType::Float32)));
        const auto dataset = openDataset(host_, path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(holdsTestSamples(dataset->values));
    }

private:
    Result<Dataset> read(const QByteArray& file) { return readWith(file, {}); }
    Result<Dataset> readWith(const QByteArray& file, const ParameterValues& values)
    {
        return asLoaded<LatticeReader>().read(folder_.write("volume.map", file), values, {});
    }
    Result<FileContents> probe(const QByteArray& file)
    {
        return asLoaded<LatticeReader>().probe(folder_.write("volume.map", file), {}, {});
    }

    TestFolder folder_;
    PluginHost host_{{.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}}};
};

QTEST_GUILESS_MAIN(MrcReaderTest)
#include "mrc_reader_test.moc"
