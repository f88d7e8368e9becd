// SPDX-License-Identifier: GPL-3.0-or-later
// What the error of a mesh alone makes of a background is not painted by a transfer function to begin with (D9).
#include <tan/build.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

using namespace tetra;

namespace {

constexpr std::uint32_t side = 28; ///< of the lattice, in points
constexpr int pictureSide = 120;
constexpr int aroundAPart = 12; ///< pixels: some three voxels
constexpr double percent = 2;

/// Noise about 10, in which a bent tube of 200 lies: values of 8 bits, as of a scanned vessel.
std::vector<float> sparseScan(const Lattice& lattice)
{
    std::mt19937 random(11);
    std::vector<float> values(lattice.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point) {
        const auto [i, j, k] = lattice.coordinates(point);
        const Eigen::Vector3d place = lattice.position(i, j, k);
        const Eigen::Vector2d axis(9 + 3 * std::sin(place.z() / 5), 10 + 2 * std::cos(place.z() / 4));
        const double distance = (place.head<2>() - axis).norm();
        const double inside = 1 / (1 + std::exp(4 * (distance - 2)));
        values[point] = static_cast<float>(std::round(9 + static_cast<double>(random() % 3) + 190 * inside));
    }
    return values;
}

Picture drawn(const std::shared_ptr<const TetrahedralMesh>& mesh, const Eigen::AlignedBox3d& bounds,
              const TransferFunction& function)
{
    const auto volume = VolumeCache(mesh).update(function, false);
    if (!volume)
        qFatal("%s", volume.error().text().c_str());
    Scene scene;
    scene.bounds = bounds;
    scene.drawables.push_back({.id = "volume", .shape = *volume});
    const auto picture = makeCpuBackend()->render(scene, fitted({.azimuth = 35, .elevation = 25}, bounds),
                                                  {.width = pictureSide, .height = pictureSide, .samplesPerAxis = 1});
    if (!picture)
        qFatal("%s", picture.error().text().c_str());
    return *picture;
}

bool isWhite(const std::array<std::uint8_t, 4>& pixel)
{
    return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
}

/// Pixels that see nothing of the tube, nor have any near them that do.
std::vector<bool> backgroundOf(const Picture& picture)
{
    std::vector<bool> background(picture.pixels.size(), true);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (isWhite(picture.pixels[static_cast<std::size_t>(y * picture.width + x)]))
                continue;
            for (int v = std::max(0, y - aroundAPart); v <= std::min(picture.height - 1, y + aroundAPart); ++v)
                for (int u = std::max(0, x - aroundAPart); u <= std::min(picture.width - 1, x + aroundAPart); ++u)
                    background[static_cast<std::size_t>(v * picture.width + u)] = false;
        }
    return background;
}

/// In steps of 1/255.
int largestDifference(const Picture& one, const Picture& other, const std::vector<bool>& where)
{
    int most = 0;
    for (std::size_t pixel = 0; pixel < where.size(); ++pixel)
        for (std::size_t channel = 0; where[pixel] && channel < 3; ++channel)
            most = std::max(most, std::abs(one.pixels[pixel][channel] - other.pixels[pixel][channel]));
    return most;
}

} // namespace

class BackgroundPictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theErrorPaintsNothingIntoTheBackground();

private:
    std::shared_ptr<const TetrahedralMesh> meshOf(double error) const;

    QTemporaryDir folder_;
    std::shared_ptr<const Model> model_;
};

void BackgroundPictureTest::initTestCase()
{
    Lattice lattice;
    lattice.size = {side, side, side};
    const auto dataset = latticeDataset(lattice, ScalarField::of(sparseScan(lattice)), "scan");
    QVERIFY(dataset.ok());
    const std::filesystem::path file = folder_.filePath("scan.tan").toStdString();
    QVERIFY(buildModel(*dataset, file, suitableMethod(*dataset)).ok());
    const auto model = Model::open(file);
    QVERIFY(model.ok());
    model_ = *model;
}

std::shared_ptr<const TetrahedralMesh> BackgroundPictureTest::meshOf(double error) const
{
    const auto mesh = MeshExtractor(model_).extract({.error = error});
    return mesh ? tetra::meshOf(*mesh) : nullptr;
}

void BackgroundPictureTest::theErrorPaintsNothingIntoTheBackground()
{
    const auto coarse = meshOf(percent), exact = meshOf(0);
    QVERIFY(coarse && exact && coarse->tetrahedra.size() < exact->tetrahedra.size());
    const ModelDescription& data = model_->description();
    const ValueHistogram volumes = volumeHistogram(*coarse, data.range.minimum, data.range.maximum, 256);
    const auto background = backgroundValues(volumes);
    QVERIFY(background && background->least <= 10 && background->largest >= 10);

    const double unitDistance = data.bounds.diagonal().norm() / 40;
    const TransferFunction function =
        fittedTransferFunction(volumes, unitDistance, percent / 100 * data.range.extent());
    const std::vector<ColourPoint> black = {{0, {0, 0, 0}, {}}};
    const Picture plain = drawn(exact, data.bounds, {black, {{40, 0}, {41, 0.9F}}, unitDistance, {}});
    const std::vector<bool> empty = backgroundOf(plain);
    QVERIFY(std::ranges::count(empty, true) > pictureSide * pictureSide / 8);
    const Picture approximate = drawn(coarse, data.bounds, function);
    const int painted = largestDifference(approximate, drawn(exact, data.bounds, function), empty);
    QVERIFY2(painted <= 1, qPrintable(QString::number(painted)));
    QVERIFY(!std::ranges::all_of(approximate.pixels, isWhite));

    // A function that rises above the background itself would have painted it.
    const TransferFunction naive{black, {{background->largest, 0}, {background->largest + 10, 0.5F}}, unitDistance, {}};
    QVERIFY(largestDifference(drawn(coarse, data.bounds, naive), drawn(exact, data.bounds, naive), empty) > 1);
}

QTEST_GUILESS_MAIN(BackgroundPictureTest)
#include "background_picture_test.moc"
