// SPDX-License-Identifier: GPL-3.0-or-later
// Whether triangles meet, against separating axes in exact integers: what they share is cut off by a thin strip.
#include "core/verify/irregular_original.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

__extension__ using Wide = __int128;
using Vector = std::array<Wide, 3>;

constexpr int cut = 4096;

Vector minus(const Vector& a, const Vector& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Wide dot(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool isFlat(const std::vector<Vector>& t)
{
    const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    return dot(normal, normal) == 0;
}

bool separates(const Vector& axis, const std::vector<Vector>& a, const std::vector<Vector>& b)
{
    const auto range = [&axis](const std::vector<Vector>& corners) {
        Wide low = dot(axis, corners[0]), high = low;
        for (const Vector& corner : corners) {
            low = std::min(low, dot(axis, corner));
            high = std::max(high, dot(axis, corner));
        }
        return std::array{low, high};
    };
    const auto first = range(a), second = range(b);
    return first[1] < second[0] || second[1] < first[0];
}

/// Of convex flat polygons.
bool haveCommonPlace(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
    const auto edges = [](const std::vector<Vector>& corners) {
        std::vector<Vector> found;
        for (std::size_t i = 0; i < corners.size(); ++i)
            found.push_back(minus(corners[(i + 1) % corners.size()], corners[i]));
        return found;
    };
    std::vector<Vector> axes;
    for (const auto* polygon : {&a, &b}) {
        const auto own = edges(*polygon);
        const Vector normal = cross(own[0], own[1]);
        axes.push_back(normal);
        for (const Vector& edge : own)
            axes.push_back(cross(normal, edge));
    }
    for (const Vector& one : edges(a))
        for (const Vector& other : edges(b))
            axes.push_back(cross(one, other));
    return std::ranges::none_of(axes, [&](const Vector& axis) { return separates(axis, a, b); });
}

Vector scaled(const Vector& a)
{
    return {a[0] * cut, a[1] * cut, a[2] * cut};
}

/// From a, one part in `cut` towards b; scaled.
Vector towards(const Vector& a, const Vector& b)
{
    return {a[0] * cut + b[0] - a[0], a[1] * cut + b[1] - a[1], a[2] * cut + b[2] - a[2]};
}

/// The first triangle without a strip along what it shares, which comes first in both.
bool meetSlowly(const std::vector<Vector>& a, const std::vector<Vector>& b, int shared)
{
    const std::vector<Vector> other = {scaled(b[0]), scaled(b[1]), scaled(b[2])};
    if (shared == 0)
        return haveCommonPlace({scaled(a[0]), scaled(a[1]), scaled(a[2])}, other);
    if (shared == 1)
        return haveCommonPlace({towards(a[0], a[1]), scaled(a[1]), scaled(a[2]), towards(a[0], a[2])}, other);
    return haveCommonPlace({towards(a[0], a[2]), towards(a[1], a[2]), scaled(a[2])}, other);
}

} // namespace

class FaceMeetingTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithSeparatingAxes_data()
    {
        QTest::addColumn<int>("shared");
        QTest::addColumn<int>("exponent");
        for (const int shared : {0, 1, 2})
            for (const int exponent : {0, -90, 200})
                QTest::addRow("%d shared, 2^%d", shared, exponent) << shared << exponent;
    }
    void agreesWithSeparatingAxes()
    {
        QFETCH(int, shared);
        QFETCH(int, exponent);
        std::mt19937 random(static_cast<unsigned>(shared) + 7);
        int meeting = 0;
        int apart = 0;
        for (int attempt = 0; attempt < 20000; ++attempt) {
            const unsigned size = 2 + random() % 4; // small: many lie in one plane or touch
            std::vector<Vector> places(6);
            for (Vector& place : places)
                for (Wide& coordinate : place)
                    coordinate = random() % size;
            std::array<std::uint32_t, 3> first = {0, 1, 2}, second = {3, 4, 5};
            for (int i = 0; i < shared; ++i) {
                second[static_cast<std::size_t>(i)] = first[static_cast<std::size_t>(i)];
                places[3 + static_cast<std::size_t>(i)] = places[static_cast<std::size_t>(i)];
            }
            const std::vector<Vector> a = {places[0], places[1], places[2]}, b = {places[3], places[4], places[5]};
            if (isFlat(a) || isFlat(b))
                continue;
            std::vector<Eigen::Vector3d> positions;
            for (const Vector& place : places)
                positions.push_back({times(place[0], exponent), times(place[1], exponent), times(place[2], exponent)});
            const bool expected = meetSlowly(a, b, shared);
            std::rotate(first.begin(), first.begin() + attempt % 3, first.end());
            std::rotate(second.begin(), second.begin() + attempt / 3 % 3, second.end());
            QCOMPARE(facesMeet(positions, first, second), expected);
            QCOMPARE(facesMeet(positions, second, first), expected);
            ++(expected ? meeting : apart);
        }
        QVERIFY2(meeting > 300 && apart > 300, qPrintable(QString("%1 %2").arg(meeting).arg(apart)));
    }

    void segmentsThroughCornersAndEdges()
    {
        const Eigen::Vector3d a(0, 0, 0), b(3, 0, 0), c(0, 3, 0);
        QVERIFY(segmentMeetsTriangle({1, 1, -1}, {1, 1, 1}, a, b, c));
        QVERIFY(segmentMeetsTriangle({0, 0, -1}, {0, 0, 1}, a, b, c));
        QVERIFY(segmentMeetsTriangle({1.5, 1.5, -1}, {1.5, 1.5, 1}, a, b, c));
        QVERIFY(segmentMeetsTriangle({1, 1, 0}, {1, 1, 1}, a, b, c));
        QVERIFY(!segmentMeetsTriangle({1, 1, 1e-300}, {1, 1, 1}, a, b, c));
        QVERIFY(!segmentMeetsTriangle({2, 2, -1}, {2, 2, 1}, a, b, c));
        QVERIFY(segmentMeetsTriangle({-1, 1, 0}, {4, 1, 0}, a, b, c));
        QVERIFY(!segmentMeetsTriangle({-1, 4, 0}, {4, 1, 0}, a, b, c));
    }

private:
    static double times(Wide number, int exponent)
    {
        return std::ldexp(static_cast<double>(static_cast<std::int64_t>(number)), exponent);
    }
};

QTEST_GUILESS_MAIN(FaceMeetingTest)
#include "face_meeting_test.moc"
