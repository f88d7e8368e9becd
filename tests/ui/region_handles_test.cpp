// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/scene_parts.h"
#include "ui/viewport/region_handles.h"
#include "ui/viewport/scene_pick.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace tetra;

/// The geometry of the tools in the picture: where handles are seen, what a drag does, what a pixel shows (R25).
class RegionHandlesTest : public QObject {
    Q_OBJECT
private slots:
    void pixelsAreThoseOfThePicture();
    void aMovementIsSeenAsItsPixels();
    void theCentreStaysUnderThePointer();
    void aFaceStaysUnderThePointer();
    void theOppositeFaceStaysUnlessRestrained();
    void theRadiusFollowsThePointer();
    void nothingBecomesSmallerThanTheLeast();
    void anAxisRestrainsTheCentre();
    void theNearestHandleWithinReachIsGrabbed();
    void facesThatMoveAlongTheViewHaveNoHandle();
    void outlinesLieOnTheRegion();
    void aPixelShowsTheNearestSurface();
};

namespace {

constexpr QSizeF pictureSize(640, 480);

/// Views of a domain of about 100 from outside, random but the same in every run.
class Views {
public:
    double number(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
    Eigen::Vector3d place(double extent)
    {
        return {number(-extent, extent), number(-extent, extent), number(-extent, extent)};
    }
    Camera camera()
    {
        Camera camera;
        camera.target = place(10);
        camera.distance = number(200, 400);
        camera.azimuth = number(-180, 180);
        camera.elevation = number(-85, 85);
        camera.perspective = number(0, 1) < 0.5;
        return camera;
    }
    Box box()
    {
        const Eigen::Vector3d centre = place(30);
        const Eigen::Vector3d half(number(5, 20), number(5, 20), number(5, 20));
        return {centre - half, centre + half};
    }

private:
    std::mt19937 random_{7};
};

double distance(QPointF one, QPointF other)
{
    return std::hypot(one.x() - other.x(), one.y() - other.y());
}

RegionDrag dragOf(const MovableRegion& region, const ViewProjection& projection, std::size_t handle)
{
    const RegionHandle held = handlesOf(region, projection)[handle];
    return {region, held, projection, *projection.pixelOf(held.place)};
}

} // namespace

void RegionHandlesTest::pixelsAreThoseOfThePicture()
{
    Views views;
    for (int i = 0; i < 200; ++i) {
        const Camera camera = views.camera();
        const Eigen::Vector3d place = views.place(50);
        const Eigen::Vector4d clip = projectionMatrix(camera, pictureSize.width() / pictureSize.height(), {}) *
                                     viewMatrix(camera) * place.homogeneous();
        const QPointF wanted((clip.x() / clip.w() + 1) / 2 * pictureSize.width(),
                             (1 - clip.y() / clip.w()) / 2 * pictureSize.height());
        QVERIFY(distance(*ViewProjection(camera, pictureSize).pixelOf(place), wanted) < 1e-6);
    }
}

void RegionHandlesTest::aMovementIsSeenAsItsPixels()
{
    Views views;
    for (int i = 0; i < 200; ++i) {
        const ViewProjection projection(views.camera(), pictureSize);
        const Eigen::Vector3d place = views.place(50);
        const QPointF pixels(views.number(-90, 90), views.number(-90, 90));
        const QPointF seen =
            *projection.pixelOf(place + projection.movement(place, pixels)) - *projection.pixelOf(place);
        QVERIFY(distance(seen, pixels) < 1e-6);
        const Eigen::Vector3d direction = views.place(1).normalized();
        const QPointF step = *projection.pixelOf(place + 1e-4 * direction) - *projection.pixelOf(place);
        QVERIFY(distance(step * 1e4, projection.pixelsPerUnit(place, direction)) < 1e-3);
    }
}

void RegionHandlesTest::theCentreStaysUnderThePointer()
{
    Views views;
    for (int i = 0; i < 100; ++i) {
        const ViewProjection projection(views.camera(), pictureSize);
        const Sphere sphere{views.place(30), 10};
        const QPointF pixels(views.number(-90, 90), views.number(-90, 90));
        const RegionDrag drag = dragOf(sphere, projection, 0);
        const auto moved = std::get<Sphere>(drag.at(drag.from + pixels, {}));
        QVERIFY(distance(*projection.pixelOf(moved.centre), drag.from + pixels) < 1e-6);
        QCOMPARE(moved.radius, sphere.radius);
    }
}

void RegionHandlesTest::aFaceStaysUnderThePointer()
{
    Views views;
    for (int i = 0; i < 100; ++i) {
        Camera camera = views.camera();
        camera.perspective = false; // in perspective it stays nearly so
        const ViewProjection projection(camera, pictureSize);
        const Box box = views.box();
        const auto handles = handlesOf(box, projection);
        for (std::size_t handle = 1; handle < handles.size(); ++handle) {
            const RegionDrag drag = dragOf(box, projection, handle);
            const QPointF seen = projection.pixelsPerUnit(drag.handle.place, Eigen::Vector3d::Unit(drag.handle.axis));
            const QPointF pointer = drag.from + seen * (3 * drag.handle.side);
            const auto moved = std::get<Box>(drag.at(pointer, {}));
            const double grown = (moved.largest - moved.least - box.largest + box.least)[drag.handle.axis];
            QVERIFY(std::abs(grown - 3) < 1e-9);
        }
    }
}

void RegionHandlesTest::theOppositeFaceStaysUnlessRestrained()
{
    Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    camera.distance = 100;
    const ViewProjection projection(camera, pictureSize);
    const Box box{{-10, -10, -10}, {10, 10, 10}};
    const auto handles = handlesOf(box, projection);
    const auto right = std::ranges::find_if(
        handles, [](const RegionHandle& handle) { return handle.axis == 0 && handle.place.x() == 10; });
    QVERIFY(right != handles.end());
    const RegionDrag drag{box, *right, projection, *projection.pixelOf(right->place)};
    const auto one = std::get<Box>(drag.at(drag.from + QPointF(30, 4), {}));
    QCOMPARE(one.least, box.least);
    QVERIFY(one.largest.x() > 10);
    QCOMPARE(one.largest.y(), 10.0);
    const auto both = std::get<Box>(drag.at(drag.from + QPointF(30, 4), {.restrained = true, .axis = {}, .least = 0}));
    QCOMPARE(both.least.x(), -both.largest.x());
}

void RegionHandlesTest::theRadiusFollowsThePointer()
{
    Views views;
    for (int i = 0; i < 100; ++i) {
        const ViewProjection projection(views.camera(), pictureSize);
        const Sphere sphere{views.place(30), views.number(5, 20)};
        for (std::size_t handle = 1; handle < 5; ++handle) {
            const RegionDrag drag = dragOf(sphere, projection, handle);
            const QPointF centre = *projection.pixelOf(sphere.centre);
            const auto twice = std::get<Sphere>(drag.at(centre + 2 * (drag.from - centre), {}));
            QVERIFY(std::abs(twice.radius - 2 * sphere.radius) < 1e-6 * sphere.radius);
            QCOMPARE(twice.centre, sphere.centre);
        }
    }
}

void RegionHandlesTest::nothingBecomesSmallerThanTheLeast()
{
    Views views;
    const DragRule rule{.restrained = false, .axis = {}, .least = 2};
    for (int i = 0; i < 100; ++i) {
        const ViewProjection projection(views.camera(), pictureSize);
        const QPointF pointer(views.number(0, 640), views.number(0, 480));
        const Sphere sphere{views.place(30), 10};
        QVERIFY(std::get<Sphere>(dragOf(sphere, projection, 1).at(pointer, rule)).radius >= 2);
        const Box box = views.box();
        for (const bool restrained : {false, true}) {
            const auto moved =
                std::get<Box>(dragOf(box, projection, 1).at(pointer, {restrained, std::nullopt, rule.least}));
            QVERIFY((moved.largest - moved.least).minCoeff() >= 2 - 1e-9);
        }
    }
}

void RegionHandlesTest::anAxisRestrainsTheCentre()
{
    Views views;
    for (int i = 0; i < 100; ++i) {
        const ViewProjection projection(views.camera(), pictureSize);
        const Sphere sphere{views.place(30), 10};
        const RegionDrag drag = dragOf(sphere, projection, 0);
        const QPointF pixels(views.number(-90, 90), views.number(-90, 90));
        for (int axis = 0; axis < 3; ++axis) {
            const auto moved = std::get<Sphere>(drag.at(drag.from + pixels, {false, axis, 0}));
            Eigen::Vector3d shift = moved.centre - sphere.centre;
            shift[axis] = 0;
            QCOMPARE(shift.norm(), 0.0);
        }
        const Eigen::Vector3d shift =
            std::get<Sphere>(drag.at(drag.from + pixels, {.restrained = true, .axis = {}, .least = 0})).centre -
            sphere.centre;
        QCOMPARE(static_cast<int>((shift.array() != 0).count()), 1);
    }
}

void RegionHandlesTest::theNearestHandleWithinReachIsGrabbed()
{
    const ViewProjection projection({.target = {0, 0, 0}, .distance = 100}, pictureSize);
    const auto handles = handlesOf(Sphere{{0, 0, 0}, 20}, projection);
    QCOMPARE(handles.size(), std::size_t{5});
    for (const RegionHandle& handle : handles) {
        const auto found = handleAt(handles, projection, *projection.pixelOf(handle.place) + QPointF(5, -4), 10);
        QVERIFY(found && found->isSameAs(handle));
    }
    QVERIFY(!handleAt(handles, projection, *projection.pixelOf({0, 0, 0}) + QPointF(11, 0), 10));
}

void RegionHandlesTest::facesThatMoveAlongTheViewHaveNoHandle()
{
    Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    camera.distance = 100;
    const auto handles = handlesOf(Box{{-10, -10, -10}, {10, 10, 10}}, ViewProjection(camera, pictureSize));
    QCOMPARE(handles.size(), std::size_t{5});
    for (std::size_t i = 1; i < handles.size(); ++i)
        QVERIFY(handles[i].axis != 1);
}

void RegionHandlesTest::outlinesLieOnTheRegion()
{
    const Sphere sphere{{1, 2, 3}, 4};
    const LineSet circles = outlineOf(sphere, {}, 1);
    QVERIFY(circles.points.size() >= 3 * 32);
    for (const Eigen::Vector3d& point : circles.points)
        QVERIFY(std::abs((point.cast<double>() - sphere.centre).norm() - sphere.radius) < 1e-5);
    QCOMPARE(outlineOf(Box{{0, 0, 0}, {1, 2, 3}}, {}, 1).segments.size(), std::size_t{12});
}

void RegionHandlesTest::aPixelShowsTheNearestSurface()
{
    testing::SceneParts scene;
    for (const float y : {20.0F, -10.0F, 5.0F}) { // the viewer looks along y
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->positions = {{-50, y, -50}, {50, y, -50}, {0, y, 70}};
        mesh->triangles = {{0, 1, 2}};
        scene.surfaces.push_back({mesh, {}, 1});
    }
    Camera camera;
    camera.azimuth = 0;
    camera.elevation = 0;
    camera.distance = 200;
    for (const bool perspective : {true, false}) {
        camera.perspective = perspective;
        const ViewProjection projection(camera, pictureSize);
        const Eigen::Vector3d wanted(3, -10, -7);
        const auto at = [&projection](const Scene& seen, QPointF pixel) {
            return seenPlace(*surfacesOf(seen), projection.pickingRay(pixel));
        };
        const auto found = at(scene, *projection.pixelOf(wanted));
        QVERIFY(found && (found->place - wanted).norm() < 1e-6);
        QVERIFY(!at(scene, {2, 2}));
        // What a clip plane cuts away is not seen.
        testing::SceneParts cut = scene;
        cut.clipPlanes = {{{0, 1, 0}, -5}};
        const Eigen::Vector3d behind(3, 5, -7);
        const auto next = at(cut, *projection.pixelOf(behind));
        QVERIFY(next && (next->place - behind).norm() < 1e-6);
    }
}

QTEST_GUILESS_MAIN(RegionHandlesTest)
#include "region_handles_test.moc"
