// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/triangle_meeting.h"

#include "core/cells/boundary_check.h"
#include "core/cells/cell_orientation.h"

#include <Eigen/Geometry>
#include <QTest>

#include <random>

using namespace tetra;

namespace {

using Eigen::Vector3d;

/// A point of small integers.
Vector3d gridPoint(std::mt19937& random, int size)
{
    const auto number = [&] { return static_cast<double>(static_cast<int>(random() % std::uint32_t(size))); };
    return {number(), number(), number()};
}

/// Whether triangles of six points have one in common, by the theorem of the alternative: they do not exactly if a
/// plane separates them, and then one does that is spanned by an edge of one and a corner of the other, or is parallel
/// to an edge of each, or is one of their planes. Integers, so doubles are exact.
bool apart(const std::array<Vector3d, 3>& a, const std::array<Vector3d, 3>& b)
{
    std::vector<Vector3d> normals;
    const Vector3d normalA = (a[1] - a[0]).cross(a[2] - a[0]), normalB = (b[1] - b[0]).cross(b[2] - b[0]);
    normals.insert(normals.end(), {normalA, normalB});
    for (std::size_t i = 0; i < 3; ++i) {
        normals.push_back((a[(i + 1) % 3] - a[i]).cross(normalA));
        normals.push_back((b[(i + 1) % 3] - b[i]).cross(normalB));
        for (std::size_t j = 0; j < 3; ++j)
            normals.push_back((a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]));
    }
    for (const Vector3d& normal : normals) {
        double lowA = 1e300, highA = -1e300, lowB = 1e300, highB = -1e300;
        for (std::size_t i = 0; i < 3; ++i) {
            lowA = std::min(lowA, normal.dot(a[i]));
            highA = std::max(highA, normal.dot(a[i]));
            lowB = std::min(lowB, normal.dot(b[i]));
            highB = std::max(highB, normal.dot(b[i]));
        }
        if (highA < lowB || highB < lowA)
            return true;
    }
    return false;
}

} // namespace

class TriangleMeetingTest : public QObject {
    Q_OBJECT
private slots:
    /// Against separating axes, on so small a grid that most cases are special: in one plane, touching, on one line.
    void agreesWithSeparatingAxes()
    {
        std::mt19937 random(5);
        int meeting = 0, compared = 0;
        while (compared < 40000) {
            std::vector<Vector3d> positions;
            for (int i = 0; i < 6; ++i)
                positions.push_back(gridPoint(random, compared % 2 == 0 ? 3 : 5));
            const std::array<Vector3d, 3> a = {positions[0], positions[1], positions[2]},
                                          b = {positions[3], positions[4], positions[5]};
            if ((a[1] - a[0]).cross(a[2] - a[0]).isZero() || (b[1] - b[0]).cross(b[2] - b[0]).isZero())
                continue;
            ++compared;
            const bool meet = trianglesMeet(positions, {0, 1, 2}, {3, 4, 5});
            meeting += meet;
            QCOMPARE(meet, !apart(a, b));
        }
        QVERIFY(meeting > 8000 && meeting < 38000);
    }

    void sharedEdge()
    {
        const std::vector<Vector3d> positions = {{0, 0, 0}, {4, 0, 0}, {1, 2, 0}, {1, -2, 0}, {1, 3, 0}, {1, 2, 1}};
        QVERIFY(!trianglesMeet(positions, {0, 1, 2}, {1, 0, 3}));
        QVERIFY(!trianglesMeet(positions, {0, 1, 2}, {1, 0, 5}));
        QVERIFY(trianglesMeet(positions, {0, 1, 2}, {1, 0, 4}));
    }
    void sharedVertex()
    {
        const std::vector<Vector3d> positions = {{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 3},
                                                 {2, 2, 0}, {-4, 0, 0}, {8, 0, 0}, {1, 1, 1}, {1, 1, -1}};
        QVERIFY(trianglesMeet(positions, {0, 1, 2}, {0, 3, 5}));  // an edge runs into it
        QVERIFY(!trianglesMeet(positions, {0, 1, 2}, {0, 4, 5})); // beside it in the plane
        QVERIFY(trianglesMeet(positions, {0, 1, 2}, {0, 8, 5}));  // along its edge
        QVERIFY(!trianglesMeet(positions, {0, 1, 2}, {0, 7, 5})); // the other way along its edge
        QVERIFY(trianglesMeet(positions, {0, 1, 2}, {0, 9, 10})); // the opposite edge pierces it
    }

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

QTEST_GUILESS_MAIN(TriangleMeetingTest)
#include "triangle_meeting_test.moc"
