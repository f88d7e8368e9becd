// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangles.h"

#include <QTest>

using namespace tetra;

using Eigen::Vector3d;

class SegmentCrossingTest : public QObject {
    Q_OBJECT
private slots:
    void crossings()
    {
        const Vector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
        QCOMPARE(crossingOf({1, 1, -1}, {1, 1, 1}, a, b, c), Crossing::Leaving);
        QCOMPARE(crossingOf({1, 1, 1}, {1, 1, -1}, a, b, c), Crossing::Entering);
        QCOMPARE(crossingOf({3, 3, 1}, {3, 3, -1}, a, b, c), Crossing::None);
        QCOMPARE(crossingOf({1, 1, 3}, {1, 1, 1}, a, b, c), Crossing::None);
        QCOMPARE(crossingOf({2, 2, -1}, {2, 2, 1}, a, b, c), Crossing::Unclear);
        QCOMPARE(crossingOf({6, 0, 0}, {6, 0, 3}, a, b, c), Crossing::None);
        QCOMPARE(crossingOf({1, 1, 3}, {1, 1, 0}, a, b, c), Crossing::Unclear);
    }
};

QTEST_APPLESS_MAIN(SegmentCrossingTest)
#include "segment_crossing_test.moc"
