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
        QCOMPARE(two->border, 0.25);
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
