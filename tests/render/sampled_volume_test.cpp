// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of a lattice in place of its mesh. A field that is linear is the same in both, so that the pictures are,
// too, with all that can be in them; tests/app/data_light.py judges other fields.
#include "core/render/picking/picking.h"
#include "core/render/samples/sampled_field.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"

#include <tan/data.h>
#include <tan/render.h>

#include <QRandomGenerator>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t cells = 9;
constexpr double extent = 3;

double slanted(const Vector3d& place)
{
    return 0.1 * place.x() + 0.15 * place.y() - 0.05 * place.z() + 0.2;
}

TransferFunction peaks()
{
    return transferFunctionFromPoints({{0.2, {1, 0, 0}, 0.05F},
                                       {0.4, {0, 1, 0}, 0.6F},
                                       {0.42, {0, 0.2F, 1}, 0.1F},
                                       {0.6, {1, 1, 0.3F}, 0.0F},
                                       {0.7, {1, 1, 1}, 0.8F}},
                                      0.5);
}

/// The lattice of latticeMesh().
template <class Field> std::shared_ptr<const Dataset> samplesOf(std::uint32_t side, const Field& field)
{
    Lattice lattice;
    lattice.size = {side + 1, side + 1, side + 1};
    lattice.spacing = Vector3d::Constant(extent / side);
    std::vector<float> values;
    for (std::uint32_t k = 0; k <= side; ++k)
        for (std::uint32_t j = 0; j <= side; ++j)
            for (std::uint32_t i = 0; i <= side; ++i)
                values.push_back(static_cast<float>(field(lattice.position(i, j, k))));
    return std::make_shared<const Dataset>(*latticeDataset(lattice, ScalarField::of(std::move(values)), "samples"));
}

/// The scene with samples in the place of its volume.
Scene withSamples(const Scene& scene, const std::shared_ptr<const Dataset>& dataset, const TransferFunction& function)
{
    Scene sampled = scene;
    for (Drawable& drawable : sampled.drawables)
        if (const auto* volume = std::get_if<Volume>(&drawable.shape)) {
            SampledVolume samples = *SampledVolumeCache(dataset).update(function, volume->shaded);
            samples.fullGradient = volume->fullGradient;
            drawable.shape = std::move(samples);
        }
    return sampled;
}

int largestDifference(const Picture& one, const Picture& other)
{
    int largest = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        largest = std::max(largest, difference(one.pixels[i], other.pixels[i]));
    return largest;
}

SceneParts slantedScene(bool shaded)
{
    SceneParts scene = volumeScene(latticeMesh(cells, extent, Split::Six, slanted), peaks());
    scene.volume->shaded = shaded;
    scene.surfaces.push_back({sphere({1.4f, 1.2f, 1.7f}, 0.9f, 24), {0.9f, 0.3f, 0.1f}, 0.4f});
    scene.surfaces.push_back({quad({0.3f, 0.9f, 0.2f}, {2, 0.7f, 0}, {0, 0.4f, 2}), {0.1f, 0.3f, 0.9f}});
    scene.lines.push_back(boxOutline(scene.bounds, {0, 0, 0}, 1.7f));
    return scene;
}

/// Bumps in empty space.
double bumps(const Vector3d& place)
{
    const auto bump = [&](const Vector3d& middle) { return std::exp(-12 * (place - middle).squaredNorm()); };
    return bump({0.6, 0.7, 0.5}) + bump({2.3, 2.1, 2.4}) + 0.7 * bump({1.4, 0.4, 2.6});
}

} // namespace

class SampledVolumeTest : public GlTest {
    Q_OBJECT
private slots:
    void linearFieldsLookLikeTheirMeshes();
    void partsAndThreadsChangeNothing();
    void whatIsPassedByIsEmpty();
    void distancesAreThoseToTheNearestBlock();
    void anyCameraWillDo();
    void pickingSeesWhatTheMeshShows();
    void aDifferenceIsThatOfTwoPictures();
    void whatDoesNotBelongTogetherIsRefused();
    void otherDataAreRefused();
    void openGlLeavesItToTheProcessor();
};

void SampledVolumeTest::linearFieldsLookLikeTheirMeshes()
{
    const auto dataset = samplesOf(cells, slanted);
    int differing = 0;
    for (const bool perspective : {true, false})
        for (const bool shaded : {false, true})
            for (const bool cut : {false, true}) {
                SceneParts parts = slantedScene(shaded);
                parts.volume->fullGradient = cut ? 0.3 : 0; // the slope is .19
                if (cut)
                    parts.clipPlanes = {{{1, 0.2, 0.1}, 1.1}, {{-0.3, 1, 0}, 0.2}};
                const Scene mesh = parts;
                const Scene samples = withSamples(mesh, dataset, peaks());
                const Camera camera = cameraAround(parts.bounds, perspective);
                const PictureOptions options{
                    .width = 90, .height = 80, .transparentBackground = cut, .samplesPerAxis = 1, .depth = true};
                const auto backend = makeCpuBackend();
                const Picture expected = rendered(*backend, mesh, camera, options);
                const Picture seen = rendered(*backend, samples, camera, options);
                QVERIFY2(largestDifference(expected, seen) <= 1,
                         qPrintable(QString("%1 %2 %3: %4")
                                        .arg(perspective)
                                        .arg(shaded)
                                        .arg(cut)
                                        .arg(largestDifference(expected, seen))));
                for (std::size_t i = 0; i < expected.depth.size(); ++i)
                    differing += std::isfinite(expected.depth[i]) != std::isfinite(seen.depth[i]) ||
                                         (std::isfinite(seen.depth[i]) &&
                                          std::abs(expected.depth[i] - seen.depth[i]) > 0.2 * extent / cells)
                                     ? 1
                                     : 0;
                QVERIFY(std::ranges::count_if(seen.depth, [](float depth) { return std::isfinite(depth); }) > 500);
            }
    QVERIFY2(differing < 20, qPrintable(QString::number(differing))); // of 57,600: where half is reached at an edge
}

void SampledVolumeTest::partsAndThreadsChangeNothing()
{
    SceneParts parts = volumeScene(latticeMesh(12, extent, Split::Six, bumps), peaks());
    const Scene scene = withSamples(parts, samplesOf(12, bumps), peaks());
    const Camera camera = cameraAround(parts.bounds, true);
    PictureOptions options{.width = 120, .height = 84, .samplesPerAxis = 2};
    const auto backend = makeCpuBackend();
    const Picture whole = rendered(*backend, scene, camera, options);
    options.threads = 1;
    QCOMPARE(rendered(*backend, scene, camera, options).pixels, whole.pixels);
    options.part = PixelRectangle{31, 17, 50, 40};
    const Picture part = rendered(*backend, scene, camera, options);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            QCOMPARE(pixelAt(part, x, y), pixelAt(whole, x + 31, y + 17));
}

void SampledVolumeTest::whatIsPassedByIsEmpty()
{
    const TransferFunction function = transferFunctionFromPoints({{0.3, {1, 1, 1}, 0}, {0.4, {1, 0.5F, 0}, 0.5F}}, 0.3);
    SceneParts parts = volumeScene(latticeMesh(40, extent, Split::Six, bumps), function);
    for (const bool perspective : {true, false}) {
        Scene scene = withSamples(parts, samplesOf(40, bumps), function);
        const Camera camera = cameraAround(parts.bounds, perspective);
        const auto backend = makeCpuBackend();
        const PictureOptions options{.width = 100, .height = 90, .samplesPerAxis = 1};
        const Picture leaping = rendered(*backend, scene, camera, options);
        auto& samples = std::get<SampledVolume>(scene.drawables.front().shape);
        auto stepping = std::make_shared<SampledTransfer>(*samples.transfer);
        QVERIFY(std::ranges::count(stepping->distances, 0) < std::ssize(stepping->distances) / 2);
        std::ranges::fill(stepping->distances, std::uint8_t(0));
        samples.transfer = stepping;
        QVERIFY(largestDifference(leaping, rendered(*backend, scene, camera, options)) <= 1);
        QVERIFY(std::ranges::any_of(leaping.pixels, [](const auto& pixel) { return pixel[2] < 128; }));
    }
}

void SampledVolumeTest::distancesAreThoseToTheNearestBlock()
{
    QRandomGenerator random(5);
    for (int round = 0; round < 20; ++round) {
        const auto dataset = samplesOf(33, [&](const Vector3d&) { return random.bounded(4000) == 0 ? 1.0 : 0.0; });
        const auto field = makeSampledField(*dataset, {});
        QVERIFY(field.ok());
        const auto transfer = makeSampledTransfer(
            *field, transferSegments(transferFunctionFromPoints({{0, {1, 1, 1}, 0}, {1, {1, 1, 1}, 0.5F}})));
        QVERIFY(transfer.ok());
        const auto [columns, rows, layers] = field->blocks;
        const auto place = [&, columns = columns, rows = rows](std::size_t block) {
            return Eigen::Vector3i(int(block % columns), int(block / columns % rows), int(block / columns / rows));
        };
        for (std::size_t block = 0; block < transfer->distances.size(); ++block) {
            int nearest = 255;
            for (std::size_t other = 0; other < transfer->distances.size(); ++other)
                if (field->extents[other][1] > 0)
                    nearest = std::min(nearest, (place(block) - place(other)).cwiseAbs().maxCoeff());
            QCOMPARE(int(transfer->distances[block]), nearest);
        }
        QCOMPARE(transfer->distances.size(), std::size_t(columns) * rows * layers);
    }
}

/// From far away, where single precision does not know one step from the next, and from inside.
void SampledVolumeTest::anyCameraWillDo()
{
    SceneParts parts = volumeScene(latticeMesh(cells, extent, Split::Six, slanted), peaks());
    const Scene mesh = parts;
    const Scene samples = withSamples(mesh, samplesOf(cells, slanted), peaks());
    const auto backend = makeCpuBackend();
    const PictureOptions options{.width = 40, .height = 30, .samplesPerAxis = 1};
    for (const double away : {1e9, 1e4, 1e-2, 1e-6})
        for (const double fieldOfView : {1e-7, 30.0, 170.0}) {
            Camera camera = zoomed(cameraAround(parts.bounds, true), away);
            camera.fieldOfView = fieldOfView;
            const Picture expected = rendered(*backend, mesh, camera, options);
            const Picture seen = rendered(*backend, samples, camera, options);
            if (away < 1) // farther away, single precision decides where a ray is
                QVERIFY2(
                    largestDifference(expected, seen) <= 2,
                    qPrintable(QString("%1 %2: %3").arg(away).arg(fieldOfView).arg(largestDifference(expected, seen))));
        }
}

void SampledVolumeTest::pickingSeesWhatTheMeshShows()
{
    const Scene mesh = slantedScene(false);
    const Scene samples = withSamples(mesh, samplesOf(cells, slanted), peaks());
    QRandomGenerator random(3);
    int seen = 0;
    for (int ray = 0; ray < 300; ++ray) {
        const auto share = [&] { return random.generateDouble(); };
        const Vector3d eye = Vector3d(share() - 0.5, share() - 0.5, share() - 0.5).normalized() * 9;
        const Vector3d target = extent * Vector3d(share(), share(), share());
        const PickingRay line{eye, (target - eye).normalized(), 0};
        const auto expected = seenPlace(mesh, line), found = seenPlace(samples, line);
        QCOMPARE(found.has_value(), expected.has_value());
        if (!found)
            continue;
        QCOMPARE(found->drawable, expected->drawable);
        QVERIFY((found->place - expected->place).norm() < 2e-3);
        QVERIFY(std::abs(found->share - expected->share) < 1e-3);
        if (found->value)
            QVERIFY(std::abs(*found->value - *expected->value) < 1e-3);
        ++seen;
    }
    QVERIFY(seen > 200);
}

void SampledVolumeTest::aDifferenceIsThatOfTwoPictures()
{
    const SceneParts parts = volumeScene(latticeMesh(4, extent, Split::Five, bumps), peaks());
    Scene scene = parts;
    const auto reference = std::make_shared<const Scene>(withSamples(scene, samplesOf(20, bumps), peaks()));
    const Camera camera = cameraAround(parts.bounds, true);
    const PictureOptions options{.width = 60, .height = 50};
    const auto backend = makeCpuBackend();
    const Picture mesh = rendered(*backend, scene, camera, options);
    const Picture data = rendered(*backend, *reference, camera, options);
    scene.reference = reference;
    const Picture seen = rendered(*backend, scene, camera, options);
    const RenderStatistics statistics = backend->statistics();
    int largest = 0;
    double sum = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        int ofPixel = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int apart = std::abs(mesh.pixels[i][channel] - data.pixels[i][channel]);
            QCOMPARE(int(seen.pixels[i][channel]), std::min(255, 8 * apart));
            ofPixel = std::max(ofPixel, apart);
        }
        largest = std::max(largest, ofPixel);
        sum += ofPixel;
    }
    QVERIFY(largest > 10);
    QCOMPARE(statistics.largestDifference, largest);
    QVERIFY(std::abs(statistics.meanDifference - sum / double(seen.pixels.size())) < 1e-9);
}

void SampledVolumeTest::whatDoesNotBelongTogetherIsRefused()
{
    const SceneParts parts = volumeScene(latticeMesh(4, extent, Split::Five, slanted), peaks());
    const Scene scene = withSamples(parts, samplesOf(4, slanted), peaks());
    const Scene larger = withSamples(parts, samplesOf(9, slanted), peaks());
    const auto samplesIn = [](const Scene& of) { return std::get<SampledVolume>(of.drawables.front().shape); };
    const auto isRefused = [&](const Drawable& drawable, bool instead) {
        Scene wrong = scene;
        if (instead)
            wrong.drawables = {drawable};
        else
            wrong.drawables.push_back(drawable);
        const auto picture = makeCpuBackend()->render(wrong, {}, {.width = 8, .height = 8});
        return !picture.ok() && picture.error().kind == ErrorKind::WrongUsage;
    };
    QVERIFY(!isRefused(scene.drawables.front(), true));
    QVERIFY(isRefused({.id = "other", .shape = samplesIn(larger)}, false)); // a second volume
    SampledVolume mixed = samplesIn(scene);
    mixed.transfer = samplesIn(larger).transfer;
    QVERIFY(isRefused({.id = "volume", .shape = mixed}, true));
    mixed = samplesIn(scene);
    mixed.gradients = std::make_shared<const SampleGradients>();
    QVERIFY(isRefused({.id = "volume", .shape = mixed}, true));
    QVERIFY(isRefused({.id = "volume", .shape = SampledVolume{}}, true));
}

void SampledVolumeTest::otherDataAreRefused()
{
    auto holed = std::make_shared<Dataset>(*samplesOf(4, slanted));
    holed->cells = std::make_shared<const std::vector<GridCell>>(64, GridCell::Kept);
    QVERIFY(!SampledVolumeCache(holed).update(peaks(), false).ok());
    TransferFunction none = peaks();
    none.unitDistance = -1;
    QVERIFY(!SampledVolumeCache(samplesOf(4, slanted)).update(none, false).ok());
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled =
        SampledVolumeCache(samplesOf(4, slanted)).update(peaks(), true, Progress(stop.get_token(), {}));
    QVERIFY(!cancelled.ok());
    QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
}

void SampledVolumeTest::openGlLeavesItToTheProcessor()
{
    makeGlIfThere();
    if (!gl_)
        return; // nothing is there that could draw them wrongly
    const SceneParts parts = volumeScene(latticeMesh(4, extent, Split::Five, slanted), peaks());
    const auto picture = gl_->render(withSamples(parts, samplesOf(4, slanted), peaks()), {}, {.width = 8, .height = 8});
    QVERIFY(!picture.ok());
    QVERIFY(picture.error().text().find("Let the CPU draw this picture.") != std::string::npos);
}

QTEST_APPLESS_MAIN(SampledVolumeTest)
#include "sampled_volume_test.moc"
