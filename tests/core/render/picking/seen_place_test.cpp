// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/picking/picking.h"
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"

#include <tan/render.h>

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <optional>

using namespace tetra;
using namespace tetra::testing;

/// What is seen along a line of sight: compared with sums of many small steps.
class SeenPlaceTest : public QObject {
    Q_OBJECT
private slots:
    void volumesAgreeWithSmallSteps();
    void aFallingValueIsFound();
    void clipPlanesCutVolumeAndSurface();
    void theSurfaceThatTakesMostIsSeen();
    void aDenseCloudHidesASurface();
    void nothingIsSeenOfWhatIsTransparent();
    void betweenTwoCellsTheLightIsTakenOnce();
    void theFocusIsLookedAtInItsPart();
    void cancelledIsNothing();
};

namespace {

constexpr double extent = 10;

Volume volumeOf(TetrahedralMesh tetrahedra, const TransferFunction& function)
{
    auto mesh = makeVolumeMesh(std::make_shared<const TetrahedralMesh>(std::move(tetrahedra)));
    Volume volume;
    volume.transfer = std::make_shared<const VolumeTransfer>(*makeVolumeTransfer(*mesh->mesh, function));
    volume.mesh = std::make_shared<const VolumeMesh>(*std::move(mesh));
    return volume;
}

/// A value that goes in a straight line through the whole cube.
double slanted(const Eigen::Vector3d& place)
{
    return 0.05 * place.x() + 0.1 * place.y() - 0.02 * place.z() + 0.1;
}

TransferFunction peaks()
{
    return transferFunctionFromPoints(
        {{0.2, {1, 0, 0}, 0}, {0.5, {0, 1, 0}, 0.6F}, {0.52, {0, 0, 1}, 0.1F}, {0.9, {1, 1, 1}, 0.9F}}, 1);
}

Surface wall(double y, float opacity)
{
    auto mesh = std::make_shared<TriangleMesh>();
    const auto at = static_cast<float>(y);
    mesh->positions = {{-50, at, -50}, {50, at, -50}, {50, at, 50}, {-50, at, 50}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return {mesh, {}, opacity};
}

PickingRay alongY(double x, double z)
{
    return {{x, -20, z}, {0, 1, 0}};
}

} // namespace

void SeenPlaceTest::volumesAgreeWithSmallSteps()
{
    const TransferFunction function = peaks();
    SceneParts scene;
    scene.volume = volumeOf(latticeMesh(4, extent, Split::Five, slanted), function);
    QRandomGenerator random(11);
    const auto coordinate = [&] { return random.bounded(extent); };
    int seenOnes = 0;
    for (int round = 0; round < 200; ++round) {
        const Eigen::Vector3d from(coordinate(), -5 - coordinate(), coordinate());
        const Eigen::Vector3d to(coordinate(), extent + coordinate(), coordinate());
        const PickingRay line{from, (to - from).normalized()};
        const PickingInterval inside =
            partWithin(line, Box{Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(extent)});
        double depth = 0, most = 0, place = 0;
        constexpr int steps = 100'000;
        const double step = (inside.to - inside.from) / steps;
        for (int i = 0; i < steps && step > 0; ++i) {
            const double t = inside.from + (i + 0.5) * step;
            const double extinction = evaluate(function, slanted(line.at(t))).extinction;
            if (const double taken = extinction * std::exp(-depth - extinction * step / 2); taken > most) {
                most = taken;
                place = t;
            }
            depth += extinction * step;
        }
        const auto seen = seenPlace(scene, line);
        if (-std::expm1(-depth) < 1.0 / 255) {
            QVERIFY(!seen || seen->share < 1.01 / 255);
            continue;
        }
        ++seenOnes;
        QVERIFY(seen && seen->drawable.starts_with("volume"));
        QVERIFY(std::abs(seen->share + std::expm1(-depth)) < 1e-4);
        const double t = (seen->place - line.origin).dot(line.direction);
        QVERIFY(std::abs(*seen->value - slanted(seen->place)) < 1e-5);
        // Two places may take as much to a millionth: then either will do.
        if (std::abs(t - place) > 2 * step + 1e-4) {
            double there = 0;
            for (double s = inside.from; s < t; s += step)
                there += evaluate(function, slanted(line.at(s + step / 2))).extinction * step;
            QVERIFY(evaluate(function, slanted(seen->place)).extinction * std::exp(-there) > most * (1 - 1e-3));
        }
    }
    QVERIFY(seenOnes > 100);
}

void SeenPlaceTest::aFallingValueIsFound()
{
    // The value falls along the line, and only a thin range of it is seen.
    const auto falling = [](const Eigen::Vector3d& place) { return 1 - 0.1 * place.y(); };
    const TransferFunction thin = transferFunctionFromPoints({{0.39, {}, 0}, {0.4, {}, 0.9F}, {0.41, {}, 0}}, 1);
    SceneParts scene;
    scene.volume = volumeOf(latticeMesh(3, extent, Split::Six, falling), thin);
    const auto seen = seenPlace(scene, alongY(3.3, 4.4));
    QVERIFY(seen.has_value());
    QVERIFY(std::abs(*seen->value - 0.4) < 0.005);
    QVERIFY(std::abs(seen->place.y() - 6) < 0.05);
}

void SeenPlaceTest::clipPlanesCutVolumeAndSurface()
{
    SceneParts scene;
    scene.surfaces = {wall(2, 1), wall(7, 1)};
    scene.clipPlanes = {{{0, 1, 0}, 5}};
    auto seen = seenPlace(scene, alongY(1, 1));
    QVERIFY(seen && seen->drawable == "surface-1");
    QVERIFY(std::abs(seen->place.y() - 7) < 1e-9);
    scene.surfaces.clear();
    const TransferFunction opaque = transferFunctionFromPoints({{0, {}, 0.999F}}, 1);
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, slanted), opaque);
    seen = seenPlace(scene, alongY(1, 1));
    QVERIFY(seen && std::abs(seen->place.y() - 5) < 1e-9);
    QVERIFY(std::abs(*seen->value - slanted(seen->place)) < 1e-6);
    scene.clipPlanes.push_back({{0, -1, 0}, -4}); // nothing is left
    QVERIFY(!seenPlace(scene, alongY(1, 1)));
}

void SeenPlaceTest::theSurfaceThatTakesMostIsSeen()
{
    SceneParts scene;
    scene.surfaces = {wall(8, 1), wall(2, 0.2F), wall(4, 0.5F)};
    auto seen = seenPlace(scene, alongY(1, 1)); // takes 0.2, 0.8 * 0.5 = 0.4, and 0.8 * 0.5 of what is left
    QVERIFY(seen && seen->drawable == "surface-2");
    QVERIFY(std::abs(seen->share - 0.4) < 1e-6);
    scene.surfaces[1].opacity = 0.7F;
    seen = seenPlace(scene, alongY(1, 1));
    QVERIFY(seen && seen->drawable == "surface-1");
    // The diagonal of the wall is an edge of two triangles: it takes the light once.
    scene.surfaces = {wall(2, 0.4F), wall(3, 1)};
    seen = seenPlace(scene, alongY(0, 0));
    QVERIFY(seen && seen->drawable == "surface-1");
    QCOMPARE(surfaceCrossings(Scene(scene), alongY(0, 0), {}).size(), std::size_t(2));
}

void SeenPlaceTest::aDenseCloudHidesASurface()
{
    SceneParts scene;
    scene.surfaces = {wall(5, 1)};
    const auto constant = [](const Eigen::Vector3d&) { return 0.5; };
    scene.volume = volumeOf(latticeMesh(3, extent, Split::Five, constant), {{}, {{0.5, 0.5F}}});
    auto seen = seenPlace(scene, alongY(3.1, 2.2)); // 1 - 0.5^5 before the wall
    QVERIFY(seen && seen->drawable.starts_with("volume"));
    QVERIFY(std::abs(seen->place.y()) < 1e-5); // the front takes most
    QVERIFY(std::abs(seen->share - (1 - std::pow(0.5, 5))) < 1e-5);
    scene.volume = volumeOf(latticeMesh(3, extent, Split::Five, constant), {{}, {{0.5, 0.05F}}});
    seen = seenPlace(scene, alongY(3.1, 2.2));
    QVERIFY(seen && seen->drawable == "surface-0");
    QVERIFY(std::abs(seen->share - std::pow(0.95, 5)) < 1e-5);
}

void SeenPlaceTest::nothingIsSeenOfWhatIsTransparent()
{
    SceneParts scene;
    QVERIFY(!seenPlace(scene, alongY(1, 1)));
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, slanted), {{}, {{0.5, 0.0001F}}});
    QVERIFY(!seenPlace(scene, alongY(1, 1)));
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, slanted), peaks());
    QVERIFY(!seenPlace(scene, alongY(-1, 1)));
    QVERIFY(seenPlace(scene, alongY(1, 1)));
    PickingRay behind = alongY(1, 1);
    behind.nearest = 40; // the eye is beyond all of it
    QVERIFY(!seenPlace(scene, behind));
}

void SeenPlaceTest::betweenTwoCellsTheLightIsTakenOnce()
{
    const auto constant = [](const Eigen::Vector3d&) { return 0.5; };
    SceneParts scene;
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, constant), {{}, {{0.5, 0.01F}}});
    // Within faces between cubes, along their edges, and through corners.
    for (const auto& [x, z] : {std::pair(5.0, 3.0), std::pair(5.0, 5.0), std::pair(2.0, 5.0)}) {
        const auto seen = seenPlace(scene, alongY(x, z));
        QVERIFY(seen.has_value());
        QVERIFY(std::abs(seen->share - (1 - std::pow(0.99, 10))) < 1e-5);
    }
}

void SeenPlaceTest::theFocusIsLookedAtInItsPart()
{
    const auto coarse = [](const Eigen::Vector3d&) { return 0.2; };
    const auto fine = [](const Eigen::Vector3d&) { return 0.8; };
    const TransferFunction function = transferFunctionFromPoints({{0.2, {}, 0.01F}, {0.8, {}, 0.9F}}, 1);
    SceneParts scene;
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, coarse), function);
    scene.focus = FinePart{volumeOf(latticeMesh(2, extent, Split::Five, fine), function), Sphere{{5, 5, 5}, 2}, 1};
    auto seen = seenPlace(scene, alongY(5.1, 4.9));
    QVERIFY(seen.has_value());
    QVERIFY(std::abs(*seen->value - 0.8) < 1e-6);
    QVERIFY(std::abs(seen->place.y() - 2.5) < 0.02); // half of the border
    seen = seenPlace(scene, alongY(1, 1));           // beside it
    QVERIFY(seen.has_value());
    QVERIFY(std::abs(*seen->value - 0.2) < 1e-6);
    scene.focus->region = Box{{4, 3, 4}, {6, 7, 6}};
    seen = seenPlace(scene, alongY(5.1, 4.9));
    QVERIFY(seen && std::abs(seen->place.y() - 2.5) < 1e-6);
    scene.focus->more = {{Sphere{{5, 1.5, 5}, 0.5}, 0}}; // C5: one before it
    seen = seenPlace(scene, alongY(5, 5));
    QVERIFY(seen && std::abs(seen->place.y() - 1) < 1e-6);
}

void SeenPlaceTest::cancelledIsNothing()
{
    SceneParts scene;
    scene.volume = volumeOf(latticeMesh(2, extent, Split::Five, slanted), peaks());
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!seenPlace(scene, alongY(1, 1), Progress(stop.get_token(), {})));
}

QTEST_GUILESS_MAIN(SeenPlaceTest)
#include "seen_place_test.moc"
