// SPDX-License-Identifier: GPL-3.0-or-later
// A query with a focus taken apart (R24).
#include <tan/query.h>

#include <QTest>

using namespace tetra;
using Eigen::Vector3d;

class TwoResolutionsTest : public QObject {
    Q_OBJECT

private slots:
    void aBallAndItsBorder()
    {
        MeshQuery query;
        query.error = SpaceRamp{Sphere{{1, 2, 3}, 2}, 0.5, 4, 0.25};
        query.warping = SpaceRamp{Sphere{{1, 2, 3}, 2}, 0.1, 3, 0.25};
        query.values = {{1, 2}};
        const auto two = twoResolutions(query);
        QVERIFY(two.has_value());
        QVERIFY(two->outside.error == ErrorField(4) && two->inside.error == ErrorField(0.5));
        QVERIFY(two->outside.warping == ErrorField(3) && two->inside.warping == ErrorField(0.1));
        QVERIFY((two->regions == std::vector<FocusRegion>{{Sphere{{1, 2, 3}, 2}, 0.25}}));
        QVERIFY(!two->outside.window);
        QCOMPARE(two->inside.window->box.least, Vector3d(-1.25, -0.25, 0.75));
        QCOMPARE(two->inside.window->box.largest, Vector3d(3.25, 4.25, 5.25));
        QVERIFY(two->inside.window->border == WindowBorder::Intersecting);
        QCOMPARE(two->inside.values.size(), std::size_t(1));
    }

    void aBoxInAWindow()
    {
        MeshQuery query;
        query.error = SpaceRamp{Box{{0, 0, 0}, {4, 4, 4}}, 0.5, 4, 1};
        query.window = Window{{{1, -9, -9}, {3, 9, 9}}, WindowBorder::Clipped};
        const auto two = twoResolutions(query);
        QVERIFY(two->outside.window == query.window);
        QCOMPARE(two->inside.window->box.least, Vector3d(1, -1, -1));
        QCOMPARE(two->inside.window->box.largest, Vector3d(3, 5, 5));
        QVERIFY(two->inside.window->border == WindowBorder::Clipped);
    }

    /// C5: where none of several regions reaches, the mesh for them is no finer than that outside.
    void severalRegions()
    {
        const Sphere ball{{1, 2, 3}, 2};
        const Box box{{6, 6, 6}, {7, 8, 9}};
        MeshQuery query;
        query.error = smallerOf(ErrorField(SpaceRamp{ball, 0.5, 4, 0.25}), SpaceRamp{box, 1, 4, 0.5});
        const auto two = twoResolutions(query);
        QVERIFY(two.has_value());
        QVERIFY((two->regions == std::vector<FocusRegion>{{ball, 0.25}, {box, 0.5}}));
        QVERIFY(two->outside.error == ErrorField(4));
        const auto allowed = [&](double x, double y, double z) { return two->inside.error.at({x, y, z}, 0); };
        QCOMPARE(allowed(1, 2, 3), 0.5);
        QCOMPARE(allowed(1, 4.2, 3), 0.5); // in the border
        QCOMPARE(allowed(6.5, 7, 9.4), 1.0);
        QCOMPARE(allowed(5, 5, 5), 4.0);
        QCOMPARE(two->inside.window->box.least, Vector3d(-1.25, -0.25, 0.75));
        QCOMPARE(two->inside.window->box.largest, Vector3d(7.5, 8.5, 9.5));
        query.error = smallerOf(ErrorField(SpaceRamp{ball, 0.5, 4, 0.25}), SpaceRamp{box, 1, 3, 0.5});
        QVERIFY(!twoResolutions(query));
    }

    void whatIsNoFocus()
    {
        MeshQuery query;
        QVERIFY(!twoResolutions(query));
        query.error = SpaceRamp{HalfSpace{}, 0.5, 4, 1};
        QVERIFY(!twoResolutions(query));
        const SpaceRamp ramp{Sphere{{1, 2, 3}, 2}, 0.5, 4, 0.25};
        query.error = smallerOf(ErrorField(ramp), ErrorField(2));
        QVERIFY(!twoResolutions(query));
        query.error = ramp;
        QVERIFY(twoResolutions(query));
        query.budget = 1000;
        QVERIFY(!twoResolutions(query));
    }
};

QTEST_GUILESS_MAIN(TwoResolutionsTest)
#include "two_resolutions_test.moc"
