// SPDX-License-Identifier: GPL-3.0-or-later
// What an error field is (R25, B2), and that its least number in a tetrahedron is one.
#include "core/history/query/error_field.h"

#include "tests/core/history/query/nearest_points.h"
#include "tests/core/history/query/random_fields.h"

#include <tan/query.h>

#include <QTest>

#include <cmath>
#include <limits>

using namespace tetra;
using Eigen::Vector3d;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();
const ValueRange anyValues{-1e9, 1e9};

/// A point of the hull: inside, on a face, on an edge or a corner.
Vector3d randomPointOf(const Corners& corners, std::mt19937& random)
{
    std::array<double, 4> parts{};
    double sum = 0;
    const unsigned left = random() % 15 + 1;
    for (int corner = 0; corner < 4; ++corner) {
        if ((left >> corner & 1u) != 0)
            parts[corner] = std::uniform_real_distribution<double>(0.001, 1)(random);
        sum += parts[corner];
    }
    Vector3d point(0, 0, 0);
    for (int corner = 0; corner < 4; ++corner)
        point += parts[corner] / sum * corners[corner];
    return point;
}

Corners randomCorners(std::mt19937& random)
{
    const bool onLattice = random() % 2 == 0;
    const double size = random() % 2 == 0 ? 2 : 10;
    std::uniform_real_distribution<double> offset(-size, size);
    const Vector3d centre(std::uniform_real_distribution<double>(-12, 12)(random),
                          std::uniform_real_distribution<double>(-12, 12)(random),
                          std::uniform_real_distribution<double>(-12, 12)(random));
    Corners corners;
    for (Vector3d& corner : corners) {
        corner = centre + Vector3d(offset(random), offset(random), offset(random));
        if (onLattice)
            corner = corner.array().round();
    }
    return corners;
}

Vector3d randomDirection(std::mt19937& random)
{
    std::normal_distribution<double> number;
    return Vector3d(number(random), number(random), number(random)).normalized();
}

SpaceRamp sharp(const Region& region)
{
    return {region, 1, 5, 0};
}

} // namespace

class ErrorFieldTest : public QObject {
    Q_OBJECT

private slots:
    /// Between infinity and a number there is infinity, never no number.
    void whatFallsFromInfinityIsANumber()
    {
        const std::array<Eigen::Vector3d, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}}};
        for (const auto& [inner, outer] : {std::pair(infinity, 2.0), {2.0, infinity}, {infinity, infinity}}) {
            const ErrorField field = SpaceRamp{HalfSpace{{0, 0, 1}, 0}, inner, outer, 1};
            QCOMPARE(field.at({0, 0, 0.5}, 0), infinity);
            QCOMPARE(field.at({0, 0, 2}, 0), outer);
            QCOMPARE(field.leastIn(corners, 0, {0, 0}), std::min(inner, field.at({0, 0, 0.5}, 0)));
        }
    }

    void numbersCanBeCombined()
    {
        const ErrorField two = 2.0;
        const ErrorField three = 3.0;
        QCOMPARE((two + three).at({0, 0, 0}, 0), 5.0);
        QCOMPARE((two * three).at({0, 0, 0}, 0), 6.0);
        QCOMPARE(smallerOf(two, three).at({0, 0, 0}, 0), 2.0);
        QCOMPARE(largerOf(two, three).at({0, 0, 0}, 0), 3.0);
        QVERIFY((two + three).isConstant());
        QCOMPARE((two * three).bounds().minimum, 6.0);
        QCOMPARE((two * three).bounds().maximum, 6.0);
        QCOMPARE((ErrorField(0.0) * ErrorField(infinity)).at({0, 0, 0}, 0), 0.0);
        QCOMPARE(ErrorField(-3.0).at({0, 0, 0}, 0), 0.0);
        QCOMPARE(ErrorField(none).at({0, 0, 0}, 0), 0.0);
        QCOMPARE(ErrorField().at({1, 2, 3}, 4), 0.0);
    }

    void distances()
    {
        const Box box{{0, 0, 0}, {1, 2, 3}};
        QCOMPARE(distanceTo(box, {1, 2, 3}), 0.0);
        QCOMPARE(distanceTo(box, {0.5, 0, 1}), 0.0);
        QCOMPARE(distanceTo(box, {4, 6, 1}), 5.0);
        QCOMPARE(distanceTo(box, {-2, 1, 3}), 2.0);
        const Sphere sphere{{1, 1, 1}, 5};
        QCOMPARE(distanceTo(sphere, {4, 5, 1}), 0.0);
        QCOMPARE(distanceTo(sphere, {7, 9, 1}), 5.0);
        QCOMPARE(distanceTo(Sphere{{0, 0, 0}, 0}, {0, 3, 4}), 5.0);
        const HalfSpace half{{0, 0.6, 0.8}, 2};
        QCOMPARE(distanceTo(half, {9, 0, 0}), 0.0);
        QCOMPARE(distanceTo(half, {9, 0, 5}), 2.0);
    }

    void rampsAreLinearInTheDistance()
    {
        const ErrorField soft = SpaceRamp{Sphere{{0, 0, 0}, 1}, 2, 10, 4};
        QCOMPARE(soft.at({0.5, 0, 0}, 0), 2.0);
        QCOMPARE(soft.at({3, 0, 0}, 0), 6.0);
        QCOMPARE(soft.at({0, 0, 5}, 0), 10.0);
        QCOMPARE(soft.at({0, 0, 50}, 0), 10.0);
        const ErrorField border = sharp(Box{{0, 0, 0}, {1, 1, 1}});
        QCOMPARE(border.at({1, 1, 1}, 0), 1.0);
        QCOMPARE(border.at({1, 1, std::nextafter(1, 2)}, 0), 5.0);
        const ErrorField unbounded = SpaceRamp{Sphere{{0, 0, 0}, 1}, 2, infinity, 4};
        QCOMPARE(unbounded.at({0, 0, 1}, 0), 2.0);
        QCOMPARE(unbounded.at({0, 0, 1.5}, 0), infinity);
    }

    void whatIsAskedWronglyIsPutRight()
    {
        QVERIFY(ErrorField(SpaceRamp{Box{{1, 5, 1}, {4, 2, 3}}, 1, 2, 0}) ==
                ErrorField(SpaceRamp{Box{{1, 2, 1}, {4, 5, 3}}, 1, 2, 0}));
        QVERIFY(ErrorField(SpaceRamp{Sphere{{0, 0, 0}, -1}, -1, 2, none}) ==
                ErrorField(SpaceRamp{Sphere{{0, 0, 0}, 0}, 0, 2, 0}));
        QVERIFY(ErrorField(SpaceRamp{HalfSpace{{0, 4, 0}, 8}, 1, 2, 0}) ==
                ErrorField(SpaceRamp{HalfSpace{{0, 1, 0}, 2}, 1, 2, 0}));
        QVERIFY(ErrorField(ValueRamp{{{{4, 1}}, {{2, -1}}, {{none, 7}}}}) ==
                ErrorField(ValueRamp{{{{2, 0}}, {{4, 1}}}}));
        QCOMPARE(ErrorField(ValueRamp{}).at({0, 0, 0}, 3), 0.0);
    }

    void valueRampsStepAndAreConstantOutside()
    {
        const ErrorField field = ValueRamp{{{{0, 4}}, {{10, 8}}, {{10, 2}}, {{20, 6}}}};
        QCOMPARE(field.at({0, 0, 0}, -5), 4.0);
        QCOMPARE(field.at({0, 0, 0}, 5), 6.0);
        QCOMPARE(field.at({0, 0, 0}, 10), 2.0);
        QCOMPARE(field.at({0, 0, 0}, 15), 4.0);
        QCOMPARE(field.at({0, 0, 0}, 99), 6.0);
        QCOMPARE(field.at({0, 0, 0}, none), 2.0);
        QCOMPARE(field.bounds().minimum, 2.0);
        QCOMPARE(field.bounds().maximum, 8.0);
        const Corners corners{Vector3d(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        QCOMPARE(field.leastIn(corners, 0, {5, 8}), 6.0);
        QCOMPARE(field.leastIn(corners, 0, {5, 10}), 2.0);
        QCOMPARE(field.leastIn(corners, 0, {none, 10}), 2.0);
    }

    /// The distance from the nearest of the isovalues.
    void nearValuesIsThat()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> value(0, 100);
        for (int trial = 0; trial < 200; ++trial) {
            std::vector<double> isovalues(1 + random() % 6);
            for (double& isovalue : isovalues)
                isovalue = value(random);
            const double falloff = value(random) / 2;
            const double outer = trial % 2 == 0 ? 8 : 0.5; // more or less than 2 at the isovalues
            const ErrorField field = ErrorField::nearValues(isovalues, 2, outer, falloff);
            for (int i = 0; i < 50; ++i) {
                const double at = i < 6 ? isovalues[i % isovalues.size()] : value(random);
                double distance = infinity;
                for (const double isovalue : isovalues)
                    distance = std::min(distance, std::abs(at - isovalue));
                const double expected = 2 + (outer - 2) * std::min(1.0, distance / falloff);
                QVERIFY(std::abs(field.at({0, 0, 0}, at) - expected) < 1e-9);
            }
        }
        QVERIFY(ErrorField::nearValues({}, 2, 8, 1) == ErrorField(8.0));
        const std::array<double, 2> two = {5, 7};
        const ErrorField steps = ErrorField::nearValues(two, 2, 8, 0);
        QCOMPARE(steps.at({0, 0, 0}, 5), 2.0);
        QCOMPARE(steps.at({0, 0, 0}, 5.001), 8.0);
        QCOMPARE(steps.at({0, 0, 0}, 7), 2.0);
    }

    void byOpacityIsLinearInIt()
    {
        const std::vector<std::array<double, 2>> opacity = {{0, 0}, {10, 0.5}, {10, 1}, {20, 0.25}, {30, 7}};
        const ErrorField field = ErrorField::byOpacity(opacity, 1, 9);
        QCOMPARE(field.at({0, 0, 0}, -1), 9.0);
        QCOMPARE(field.at({0, 0, 0}, 5), 7.0);
        QCOMPARE(field.at({0, 0, 0}, 10), 1.0);
        QCOMPARE(field.at({0, 0, 0}, 20), 7.0);
        QCOMPARE(field.at({0, 0, 0}, 40), 1.0);
        QVERIFY(ErrorField::byOpacity({}, 1, 9) == ErrorField(9.0));
    }

    void formDecidesEqualityAndDependence()
    {
        const ErrorField place = sharp(Sphere{{1, 2, 3}, 4});
        const ErrorField value = ValueRamp{{{{0, 1}}, {{1, 2}}}};
        QVERIFY(place == ErrorField(sharp(Sphere{{1, 2, 3}, 4})));
        QVERIFY(!(place == ErrorField(sharp(Sphere{{1, 2, 3}, 5}))));
        QVERIFY(!(place == ErrorField(sharp(Box{{1, 2, 3}, {4, 4, 4}}))));
        QVERIFY(place + value == ErrorField(sharp(Sphere{{1, 2, 3}, 4})) + value);
        QVERIFY(!(place + value == value + place));
        QVERIFY(!(place + value == place * value));
        QVERIFY(place.asSpaceRamp() != nullptr && (place + value).asSpaceRamp() == nullptr);
        QVERIFY(place.dependsOnPlace() && !place.dependsOnValue() && !place.isConstant());
        QVERIFY(!value.dependsOnPlace() && value.dependsOnValue());
        QVERIFY((place * value).dependsOnPlace() && (place * value).dependsOnValue());
        QVERIFY(!ErrorField(3.0).dependsOnPlace() && !ErrorField(3.0).dependsOnValue());
    }

    void queriesAreEqualIfAllIs()
    {
        MeshQuery query;
        query.error = sharp(Sphere{{1, 2, 3}, 4});
        query.values = {{1, 2}};
        query.window = Window{{{0, 0, 0}, {1, 1, 1}}, WindowBorder::Clipped};
        QVERIFY(query == MeshQuery(query));
        const auto differs = [&](auto change) {
            MeshQuery other = query;
            change(other);
            return !(query == other);
        };
        QVERIFY(differs([](MeshQuery& q) { q.error = 1.0; }));
        QVERIFY(differs([](MeshQuery& q) { q.warping = 1.0; }));
        QVERIFY(differs([](MeshQuery& q) { q.budget = 7; }));
        QVERIFY(differs([](MeshQuery& q) { q.values[0].maximum = 3; }));
        QVERIFY(differs([](MeshQuery& q) { q.values.clear(); }));
        QVERIFY(differs([](MeshQuery& q) { q.window->border = WindowBorder::Contained; }));
        QVERIFY(differs([](MeshQuery& q) { q.window.reset(); }));
        QVERIFY(differs([](MeshQuery& q) { q.method = VariableMethod::Insertion; }));
    }

    /// Nowhere in the hull, nor around it, is the field less, bit for bit.
    void leastInIsAtMostTheField()
    {
        std::mt19937 random(1);
        for (int trial = 0; trial < 4000; ++trial) {
            const ErrorField field = randomField(random, 1 + trial % 4);
            const Corners corners = randomCorners(random);
            const double margin = trial % 3 == 0 ? std::uniform_real_distribution<double>(0, 3)(random) : 0;
            std::uniform_real_distribution<double> value(-12, 12);
            ValueRange values{value(random), value(random)};
            if (values.minimum > values.maximum)
                std::swap(values.minimum, values.maximum);
            const double least = field.leastIn(corners, margin, values);
            const ValueRange bounds = field.bounds();
            QVERIFY(least >= bounds.minimum && least <= bounds.maximum);
            for (int i = 0; i < 200; ++i) {
                Vector3d place = randomPointOf(corners, random);
                if (margin > 0)
                    place += margin * (1 - 1e-12) * randomDirection(random);
                std::uniform_real_distribution<double> within(values.minimum, values.maximum);
                const double at = field.at(place, i == 0 ? values.minimum : i == 1 ? values.maximum : within(random));
                QVERIFY2(least <= at, qPrintable(QString::number(least - at)));
                QVERIFY(at >= bounds.minimum && at <= bounds.maximum);
            }
        }
    }

    /// The sharp ramp says `outer` exactly if no point of the tetrahedron is in the region. Alternating projections
    /// find a common point, or a plane between the two.
    void aSharpRampIsTight()
    {
        std::mt19937 random(2);
        int meeting = 0;
        int apart = 0;
        int undecided = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            const Corners corners = randomCorners(random);
            const Region region = randomRegion(random);
            const bool found = ErrorField(sharp(region)).leastIn(corners, 0, anyValues) == 1;
            const auto expected = whetherTheyMeet(region, corners);
            if (!expected) {
                ++undecided;
                continue;
            }
            QVERIFY2(found == *expected, qPrintable(QString::number(trial)));
            ++(found ? meeting : apart);
        }
        QVERIFY(meeting > 500 && apart > 500 && undecided < 30);
    }

    void touchingIsMeeting()
    {
        const Corners corners{Vector3d(0, 0, 0), {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
        const auto least = [&](const Region& region) {
            return ErrorField(sharp(region)).leastIn(corners, 0, anyValues);
        };
        QCOMPARE(least(Box{{1, 1, 1}, {5, 5, 5}}), 1.0);     // the corner in the slanted face
        QCOMPARE(least(Box{{1, 1, 1.001}, {5, 5, 5}}), 5.0); // their bounding boxes meet
        QCOMPARE(least(Box{{-4, -4, -4}, {0, 0, 0}}), 1.0);  // two corners
        QCOMPARE(least(Box{{1, -4, -4}, {2, 0, 0}}), 1.0);   // edge along edge
        QCOMPARE(least(Box{{2, 1, -1}, {4, 4, 4}}), 1.0);    // edge across edge
        QCOMPARE(least(Box{{2.001, 1, -1}, {4, 4, 4}}), 5.0);
        QCOMPARE(least(Box{{0.5, 0.5, 0.5}, {0.6, 0.6, 0.6}}), 1.0); // within
        QCOMPARE(least(Box{{-9, -9, -9}, {9, 9, 9}}), 1.0);          // around
        QCOMPARE(least(Sphere{{0, 0, -2}, 2}), 1.0);
        QCOMPARE(least(Sphere{{1, 1, -2}, 2}), 1.0);
        QCOMPARE(least(Sphere{{1, 1, -2}, 1.999}), 5.0);
        QCOMPARE(least(Sphere{{3, 3, 0}, 2.1}), 5.0); // 2.12 from the edge
        QCOMPARE(least(Sphere{{3, 3, 0}, 2.2}), 1.0);
        QCOMPARE(least(Sphere{{0.2, 0.2, 0.2}, 0}), 1.0);
        QCOMPARE(least(HalfSpace{{0, 0, 1}, 0}), 1.0);
        QCOMPARE(least(HalfSpace{{0, 0, 1}, -0.001}), 5.0);
        QCOMPARE(ErrorField(sharp(HalfSpace{{0, 0, 1}, -0.5})).leastIn(corners, 0.5, anyValues), 1.0);
        QCOMPARE(ErrorField(sharp(Sphere{{0, 0, -2}, 1})).leastIn(corners, 1, anyValues), 1.0);
        QCOMPARE(ErrorField(sharp(Sphere{{0, 0, -2}, 1})).leastIn(corners, 0.99, anyValues), 5.0);
    }

    void whatIsNoNumberIsBoundedFromBelow()
    {
        const Corners whole{Vector3d(9, 9, 9), {10, 9, 9}, {9, 10, 9}, {9, 9, 10}};
        const ErrorField field = sharp(Box{{0, 0, 0}, {1, 1, 1}});
        QCOMPARE(field.leastIn(whole, 0, anyValues), 5.0);
        for (int corner = 0; corner < 4; ++corner)
            for (const double wrong : {none, infinity, -infinity}) {
                Corners corners = whole;
                corners[corner][corner % 3] = wrong;
                QCOMPARE(field.leastIn(corners, 0, anyValues), 1.0);
            }
        QCOMPARE(field.leastIn(whole, none, anyValues), 1.0);
        QCOMPARE(field.leastIn(whole, infinity, anyValues), 1.0);
        QCOMPARE(field.at({none, none, none}, none), 1.0);
    }
};

QTEST_GUILESS_MAIN(ErrorFieldTest)
#include "error_field_test.moc"
