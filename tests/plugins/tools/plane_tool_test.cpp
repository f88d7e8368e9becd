// SPDX-License-Identifier: GPL-3.0-or-later
// The plane against closed forms: which side is shown, where it lies after a drag, how it turns and snaps.
#include "plugins/tools/plane/plane_tool.h"

#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"
#include "tests/plugins/tools/tool_fixture.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;
using namespace tetra::testing;

namespace {

using Vector = Eigen::Vector3d;

const PlaneTool tool{};
const Eigen::AlignedBox3d box(Vector(0, 0, 0), Vector(8, 4, 2));

Parameter slicesParameter()
{
    Parameter parameter;
    parameter.id = slicesId;
    parameter.defaultValue = std::string("z=1");
    return parameter;
}

ToolFixture inMode(std::vector<Parameter> parameters)
{
    ToolFixture fixture{tool, "plane"};
    fixture.model.bounds = box;
    fixture.parameters = std::move(parameters);
    return fixture;
}

std::string settingOf(const ToolFixture& fixture, const char* id)
{
    return parameterValue<std::string>({}, fixture.view.appearance.settings, id);
}

ClipPlane onlyClip(const ToolFixture& fixture)
{
    const auto planes = parseClipPlanes(settingOf(fixture, clipId));
    return planes && planes->size() == 1 ? planes->front() : ClipPlane{Vector::Zero(), 0};
}

/// One looks along the direction through the place.
ToolPointer rayThrough(const Vector& place, const Vector& direction)
{
    ToolPointer pointer;
    pointer.direction = direction.normalized();
    pointer.origin = place - 20 * pointer.direction;
    pointer.place = place;
    return pointer;
}

} // namespace

class PlaneToolTest : public QObject {
    Q_OBJECT

private slots:
    /// What lies between the eye and the place is cut away.
    void aClickCutsAwayWhatLiesBefore()
    {
        ToolFixture plane = inMode({clipParameter()});
        ToolPointer pointer = rayThrough({3, 1, 1}, {0.9, 0.3, -0.2});
        pointer.seen = SeenThere{pointer.place, "surface", {}};
        plane.click(pointer);
        const ClipPlane clip = onlyClip(plane);
        QCOMPARE(clip.normal, Vector(1, 0, 0));
        QCOMPARE(clip.offset, 3.0);
        QVERIFY(clip.normal.dot(pointer.origin) < clip.offset); // where the eye is, nothing is shown
        pointer = seenAt({5, 2, 1});
        plane.click(pointer); // the next one brings it to what is seen
        QCOMPARE(onlyClip(plane).offset, 5.0);
        pointer.seen.reset();
        pointer.place.x() = 7;
        plane.click(pointer); // beside everything: nothing
        QCOMPARE(onlyClip(plane).offset, 5.0);
        QCOMPARE(plane.names, (std::vector<std::string>{"Add Plane", "Move Plane"}));
    }

    void addingFacesTheCameraAndFlippingShowsTheOtherSide()
    {
        ToolFixture plane = inMode({clipParameter()});
        plane.view.camera = fitted({.azimuth = 0, .elevation = 0}, box); // one looks along +y
        plane.command("add");
        QCOMPARE(onlyClip(plane).normal, Vector(0, 1, 0));
        QCOMPARE(onlyClip(plane).offset, 2.0);
        plane.command("flip");
        QCOMPARE(onlyClip(plane).normal, Vector(0, -1, 0));
        QCOMPARE(onlyClip(plane).offset, -2.0);
        QCOMPARE(settingOf(plane, clipId).find("-0"), std::string::npos);
        plane.command("add");
        QCOMPARE(parseClipPlanes(settingOf(plane, clipId))->size(), std::size_t(2));
        plane.command("remove");
        QCOMPARE(onlyClip(plane).offset, -2.0);
        plane.command("remove");
        QCOMPARE(settingOf(plane, clipId), std::string());
        QVERIFY(!plane.isEnabled("flip") && plane.isEnabled("add"));
    }

    /// The centre follows the pointer: the place along the normal is the nearest one to the line of sight, in
    /// perspective (lines from an eye) and without.
    void theCentreIsDraggedAlongTheNormal_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::newRow("perspective") << true;
        QTest::newRow("parallel") << false;
    }
    void theCentreIsDraggedAlongTheNormal()
    {
        QFETCH(bool, perspective);
        const Vector normal = Vector(1, 2, 2).normalized(), from(4, 2, 1), eye(3, -30, 12);
        for (const double along : {-1.5, 0.0, 0.4, 2.0}) {
            const Vector wanted = from + along * normal;
            ToolPointer pointer;
            pointer.direction = perspective ? Vector((wanted - eye).normalized()) : Vector(0, 1, -0.4).normalized();
            pointer.origin = perspective ? eye : Vector(wanted - 25 * pointer.direction);
            QVERIFY(std::abs(alongNormal(from, normal, pointer) - along) < 1e-10);
            // A line that passes beside: no other place of the normal is nearer to it.
            pointer.origin += normal.cross(pointer.direction);
            const double found = alongNormal(from, normal, pointer);
            const auto distance = [&](double t) {
                const Vector to = from + t * normal - pointer.origin;
                return to.cross(pointer.direction).norm();
            };
            QVERIFY(distance(found) <= distance(found + 1e-3) && distance(found) <= distance(found - 1e-3));
        }
        ToolPointer alongIt;
        alongIt.direction = normal;
        QCOMPARE(alongNormal(from, normal, alongIt), 0.0);

        ToolFixture plane = inMode({clipParameter()});
        plane.view.appearance.settings[clipId] = std::string("2,0,0,6"); // of another length: x >= 3
        const auto handles = plane.drawing().handles;
        QCOMPARE(handles.size(), std::size_t(2));
        QVERIFY((handles[0].place - Vector(3, 2, 1)).norm() < 1e-12);
        plane.move({.handle = "centre", .from = handles[0].place, .pointer = rayThrough({4.5, 2, 1}, {0, 1, 0.5})});
        QVERIFY(std::abs(onlyClip(plane).offset - 4.5) < 1e-12);
        plane.move({.handle = "centre", .from = {4.5, 2, 1}, .to = {4.75, 3, 1}, .byKeys = true});
        QVERIFY(std::abs(onlyClip(plane).offset - 4.75) < 1e-12);
        plane.move({.handle = "centre", .from = {4.75, 2, 1}, .to = {40, 2, 1}, .byKeys = true});
        QCOMPARE(onlyClip(plane).offset, 8.0); // no farther than the data reach
    }

    /// About its centre, towards the place of the sphere that is seen; with Shift to an axis.
    void theTipTurnsThePlane()
    {
        ToolFixture plane = inMode({clipParameter()});
        plane.view.appearance.settings[clipId] = std::string("1,0,0,4");
        const Vector centre(4, 2, 1);
        const double radius = (plane.drawing().handles[1].place - centre).norm();
        const Vector normal = Vector(2, -1, 0.5).normalized();
        HandleMove move{.handle = "tip", .from = plane.drawing().handles[1].place};
        move.pointer = rayThrough(centre + radius * normal, {-0.6, 0.8, 0.1}); // the tip is before the centre
        plane.move(move);
        QVERIFY((onlyClip(plane).normal - normal).norm() < 1e-12);
        QVERIFY(std::abs(onlyClip(plane).offset - normal.dot(centre)) < 1e-12);
        move.from = plane.drawing().handles[1].place;
        move.pointer.shift = true;
        plane.move(move);
        QCOMPARE(onlyClip(plane).normal, Vector(1, 0, 0));
        QVERIFY(std::abs(onlyClip(plane).offset - 4) < 1e-12);
        QCOMPARE(plane.names.back(), std::string("Turn Plane"));
    }

    void placesOnASphere()
    {
        const Vector centre(1, 2, 3);
        std::mt19937 random(3);
        std::normal_distribution<double> anywhere;
        for (int round = 0; round < 100; ++round) {
            const Vector direction = Vector(anywhere(random), anywhere(random), anywhere(random)).normalized();
            const Vector place = centre + 2 * Vector(anywhere(random), anywhere(random), anywhere(random)).normalized();
            const bool isBefore = (place - centre).dot(direction) <= 0;
            QVERIFY((onSphere(centre, 2, rayThrough(place, direction), isBefore) - place).norm() < 1e-9);
            const Vector beside = centre + 5 * direction.unitOrthogonal();
            QVERIFY((onSphere(centre, 2, rayThrough(beside, direction), isBefore) -
                     (centre + 2 * direction.unitOrthogonal()))
                        .norm() < 1e-9);
        }
    }

    void nearestAxes()
    {
        QCOMPARE(nearestAxis({0.2, -0.9, 0.5}), Vector(0, -1, 0));
        QCOMPARE(nearestAxis({0, 0, 4}), Vector(0, 0, 1));
    }

    /// The outline lies in the plane and in the faces of the box; its area is known.
    void theOutlineIsTheCutOfTheBox()
    {
        const auto areaOf = [](const std::vector<Vector>& corners) {
            Vector twice = Vector::Zero();
            for (std::size_t i = 0; i < corners.size(); ++i)
                twice += corners[i].cross(corners[(i + 1) % corners.size()]);
            return twice.norm() / 2;
        };
        QVERIFY(std::abs(areaOf(cutOfBox({Vector::UnitX(), 3}, box)) - 4 * 2) < 1e-12);
        const Eigen::AlignedBox3d cube(Vector(0, 0, 0), Vector(1, 1, 1));
        const Vector diagonal = Vector(1, 1, 1).normalized();
        const auto hexagon = cutOfBox({diagonal, diagonal.dot(cube.center())}, cube);
        QCOMPARE(hexagon.size(), std::size_t(6));
        QVERIFY(std::abs(areaOf(hexagon) - 0.75 * std::sqrt(3)) < 1e-12);
        QCOMPARE(cutOfBox({diagonal, 0.2}, cube).size(), std::size_t(3));
        QVERIFY(cutOfBox({diagonal, 5}, cube).empty());
        for (const Vector& corner : cutOfBox({Vector(1, 2, 2).normalized(), 3}, box)) {
            QVERIFY(std::abs(Vector(1, 2, 2).normalized().dot(corner) - 3) < 1e-12);
            QVERIFY(box.squaredExteriorDistance(corner) < 1e-24);
        }
    }

    /// Where a mode has slices, those are held; what is written of others stays as it is.
    void slicesAreMovedLikeClipPlanes()
    {
        ToolFixture plane = inMode({clipParameter(), slicesParameter()});
        QVERIFY((plane.drawing().handles.front().place - Vector(4, 2, 1)).norm() < 1e-12); // the default one
        plane.view.appearance.settings[slicesId] = std::string(" x = 2 ;0,0,3,4.5");
        plane.move({.handle = "centre", .from = {4, 2, 1.5}, .to = {4, 2, 0.5}, .byKeys = true});
        QCOMPARE(settingOf(plane, slicesId), std::string("x = 2;z=0.5"));
        plane.set("number", std::string("1"));
        QVERIFY((plane.drawing().handles.front().place - Vector(2, 2, 1)).norm() < 1e-12);
        plane.set("normal", Vector(0, 3, 0));
        QCOMPARE(settingOf(plane, slicesId), std::string("y=2;z=0.5"));
        plane.set("offset", 3.5);
        QCOMPARE(settingOf(plane, slicesId), std::string("y=3.5;z=0.5"));
        plane.set("normal", Vector(0, 0, 0));
        QCOMPARE(settingOf(plane, slicesId), std::string("y=3.5;z=0.5"));
        plane.set("kind", std::string("Clip plane"));
        QVERIFY(plane.drawing().handles.empty()); // there is none
        plane.command("add");
        QCOMPARE(parseClipPlanes(settingOf(plane, clipId))->size(), std::size_t(1));
        QCOMPARE(settingOf(plane, slicesId), std::string("y=3.5;z=0.5"));
        plane.view.appearance.settings[clipId] = std::string("1,2,2,6");
        plane.command("align");
        QVERIFY(onlyClip(plane).normal == Vector::UnitY() || onlyClip(plane).normal == Vector::UnitZ());
    }

    /// The clip plane of another mode is no reason to move clip planes in one of slices.
    void slicesComeFirstUnlessClipPlanesAreChosen()
    {
        ToolFixture plane = inMode({clipParameter()});
        plane.command("add");
        QVERIFY(plane.drawing().handles.size() == 2);
        plane.parameters = {clipParameter(), slicesParameter()};
        plane.set("offset", 1.5);
        QVERIFY(!settingOf(plane, slicesId).empty());
        const std::string slices = settingOf(plane, slicesId);
        plane.set("kind", std::string("Clip plane"));
        plane.set("number", std::string("1"));
        plane.command("flip");
        plane.set("offset", -1.0);
        QCOMPARE(settingOf(plane, slicesId), slices);
    }

    /// Of any length that a number can have.
    void planesOfAnyLengthAreHeld()
    {
        for (const double length : {1e-200, 1.0, 1e200}) {
            ToolFixture plane = inMode({clipParameter()});
            plane.view.appearance.settings[clipId] =
                clipPlanesText(std::array{ClipPlane{{0, 0, length}, 1.5 * length}});
            plane.command("flip");
            QVERIFY((onlyClip(plane).normal - Vector(0, 0, -1)).norm() < 1e-12);
            QVERIFY(std::abs(onlyClip(plane).offset + 1.5) < 1e-12);
        }
    }

    void whereThereAreNoPlanesItSaysSo()
    {
        ToolFixture plane = inMode({});
        plane.click(seenAt({1, 1, 1}));
        plane.command("add");
        QVERIFY(plane.names.empty());
        QVERIFY(!plane.readings().empty());
        QVERIFY(!plane.isEnabled("add"));
        QVERIFY(plane.drawing().lines.empty());
    }

    /// A picture that is saved has no handles and no outline of a tool that is not chosen.
    void itIsSeenOnlyWhileItIsChosen()
    {
        ToolFixture plane = inMode({clipParameter()});
        plane.command("add");
        const std::string kept = plane.value();
        const ToolSurroundings others{
            .view = plane.view, .model = plane.model, .value = kept, .parameters = plane.parameters};
        QVERIFY(!plane.drawing().lines.empty());
        QVERIFY(tool.drawing(others).lines.empty());
    }
};

QTEST_GUILESS_MAIN(PlaneToolTest)
#include "plane_tool_test.moc"
