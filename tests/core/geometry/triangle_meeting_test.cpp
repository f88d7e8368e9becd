// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangles.h"

#include <Eigen/Geometry>
#include <QTest>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

using namespace tetra;

namespace {

/// A fraction in lowest terms with a positive denominator.
class Rational {
public:
    Rational(std::int64_t numerator = 0, std::int64_t denominator = 1)
    {
        const std::int64_t common = std::max<std::int64_t>(std::gcd(numerator, denominator), 1);
        const std::int64_t sign = denominator < 0 ? -1 : 1;
        over_ = sign * numerator / common;
        under_ = sign * denominator / common;
    }
    friend Rational operator*(Rational a, Rational b) { return {a.over_ * b.over_, a.under_ * b.under_}; }
    friend Rational operator/(Rational a, Rational b) { return {a.over_ * b.under_, a.under_ * b.over_}; }
    friend Rational operator+(Rational a, Rational b)
    {
        return {a.over_ * b.under_ + b.over_ * a.under_, a.under_ * b.under_};
    }
    friend Rational operator-(Rational a, Rational b)
    {
        return {a.over_ * b.under_ - b.over_ * a.under_, a.under_ * b.under_};
    }
    friend bool operator==(Rational a, Rational b) = default;
    bool isZero() const { return over_ == 0; }
    bool isNegative() const { return over_ < 0; }

private:
    std::int64_t over_ = 0, under_ = 1;
};

using Row = std::array<Rational, 7>;

/// The only solution of the equations in the given unknowns, the others zero; none if there is not one.
std::optional<std::array<Rational, 6>> basicSolution(std::array<Row, 5> rows, unsigned unknowns)
{
    std::array<std::size_t, 6> pivotOf{};
    std::size_t rank = 0;
    for (std::size_t column = 0; column < 6; ++column) {
        if (!(unknowns >> column & 1U))
            continue;
        std::size_t pivot = rank;
        while (pivot < 5 && rows[pivot][column].isZero())
            ++pivot;
        if (pivot == 5)
            return std::nullopt;
        std::swap(rows[rank], rows[pivot]);
        const Row scaled = rows[rank];
        for (std::size_t row = 0; row < 5; ++row) {
            const Rational factor = rows[row][column] / scaled[column];
            for (std::size_t k = 0; row != rank && k < 7; ++k)
                rows[row][k] = rows[row][k] - factor * scaled[k];
        }
        pivotOf[column] = rank++;
    }
    for (std::size_t row = rank; row < 5; ++row) {
        if (!rows[row][6].isZero())
            return std::nullopt;
    }
    std::array<Rational, 6> solution{};
    for (std::size_t column = 0; column < 6; ++column) {
        if (unknowns >> column & 1U)
            solution[column] = rows[pivotOf[column]][6] / rows[pivotOf[column]][column];
    }
    return solution;
}

/// The equations that weights of the corners of both obey where the triangles have a point in common.
std::array<Row, 5> equations(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& one,
                             const SurfaceTriangle& other)
{
    std::array<Row, 5> rows{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows[k][i] = Rational(std::int64_t(positions[one[i]][Eigen::Index(k)]));
            rows[k][3 + i] = Rational(-std::int64_t(positions[other[i]][Eigen::Index(k)]));
        }
        rows[3][i] = Rational(1);
        rows[4][3 + i] = Rational(1);
    }
    rows[3][6] = rows[4][6] = Rational(1);
    return rows;
}

/// surfaceTrianglesMeet() by the definition: the corners of the set of all pairs of weights that give the same point
/// are its basic solutions, and one of them must give a point that what is shared does not have. In fractions.
bool meetInFractions(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& one,
                     const SurfaceTriangle& other)
{
    const auto isShared = [&](std::uint32_t corner) { return std::ranges::find(other, corner) != other.end(); };
    if (std::ranges::all_of(one, isShared))
        return true;
    const std::array<Row, 5> rows = equations(positions, one, other);
    for (unsigned unknowns = 1; unknowns < 63; ++unknowns) {
        const auto solution = basicSolution(rows, unknowns);
        if (!solution || std::ranges::any_of(*solution, [](Rational weight) { return weight.isNegative(); }))
            continue;
        // Weights are unique in a triangle with an area: the point is in what is shared if no other corner has any.
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(*solution)[i].isZero() && !isShared(one[i]))
                return true;
        }
    }
    return false;
}

std::vector<Eigen::Vector3d> randomPoints(std::mt19937& random, std::size_t count, unsigned side)
{
    std::vector<Eigen::Vector3d> points(count);
    const bool flat = random() % 3 == 0;
    for (Eigen::Vector3d& point : points)
        point = {double(random() % side), double(random() % side), flat ? 1.0 : double(random() % side)};
    return points;
}

} // namespace

class TriangleMeetingTest : public QObject {
    Q_OBJECT
private slots:
    /// S12: with nothing, a corner and an edge shared, mostly degenerate.
    void agreesWithFractions_data()
    {
        QTest::addColumn<int>("shared");
        QTest::addColumn<int>("side");
        for (const int shared : {0, 1, 2}) {
            for (const int side : {2, 3, 5})
                QTest::addRow("%d of %d", shared, side) << shared << side;
        }
    }
    void agreesWithFractions()
    {
        QFETCH(int, shared);
        QFETCH(int, side);
        std::mt19937 random(unsigned(10 * shared + side));
        std::array<int, 2> seen{};
        for (int trial = 0; trial < 1200; ++trial) {
            const auto points = randomPoints(random, 6, unsigned(side));
            SurfaceTriangle one{0, 1, 2};
            SurfaceTriangle other{3, 4, 5};
            for (std::size_t i = 0; i < std::size_t(shared); ++i)
                other[i] = one[i];
            std::ranges::shuffle(one, random);
            std::ranges::shuffle(other, random);
            if (withoutArea(points, one) || withoutArea(points, other))
                continue;
            const bool expected = meetInFractions(points, one, other);
            QCOMPARE(surfaceTrianglesMeet(points, one, other), expected);
            QCOMPARE(surfaceTrianglesMeet(points, other, one), expected);
            ++seen[expected];
        }
        QVERIFY(seen[1] > 50);
        QVERIFY(seen[0] > 50 || side == 2);
    }

    void areaIsExact()
    {
        const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}};
        QVERIFY(withoutArea(points, {0, 1, 2}));
        QVERIFY(withoutArea(points, {0, 1, 1}));
        std::mt19937 random(5);
        for (int trial = 0; trial < 2000; ++trial) {
            const auto corners = randomPoints(random, 3, 3);
            const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).squaredNorm();
            QCOMPARE(withoutArea(corners, {0, 1, 2}), area == 0);
        }
    }

    void sameCornersMeet()
    {
        const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        QVERIFY(surfaceTrianglesMeet(points, {0, 1, 2}, {2, 1, 0}));
    }
};

QTEST_APPLESS_MAIN(TriangleMeetingTest)
#include "triangle_meeting_test.moc"
