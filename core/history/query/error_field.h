// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/scalar_field.h"
#include "core/geometry/region.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace tetra {

/// The distance of a place from a region; 0 within.
double distanceTo(const Region& region, const Eigen::Vector3d& place);

/// `inner` within the region, `outer` from `falloff` away, and linear in the distance between the two. A falloff of 0
/// is a sharp border.
struct SpaceRamp {
    Region region;
    double inner = 0;
    double outer = 0;
    double falloff = 0;
    bool operator==(const SpaceRamp&) const = default;
};

/// Linear between knots (value, error) of increasing value, constant before the first and after the last. Two knots of
/// one value are a step, at which the smaller error holds.
struct ValueRamp {
    std::vector<std::array<double, 2>> knots;
    bool operator==(const ValueRamp&) const = default;
};

/// How large the error of a mesh may be at a place where the data have a value (R25, B2): an expression in numbers,
/// ramps in space and ramps over values. In % of the value range, or of the diagonal if it is a warping that is
/// bounded. An immutable value, cheap to copy; safe to read from any number of threads.
class ErrorField {
public:
    // What is given is put in order: corners of a box that are the wrong way round, a normal that is none of length 1
    // (with its offset), knots out of order. Numbers that are none count as 0, knots without a value are left out.

    /// The same everywhere.
    ErrorField(double percent = 0); // NOLINT(google-explicit-constructor): a number is a field
    ErrorField(SpaceRamp ramp);     // NOLINT(google-explicit-constructor)
    ErrorField(ValueRamp ramp);     // NOLINT(google-explicit-constructor)

    /// `inner` at the isovalues, `outer` from `falloff` (in units of the values, positive) away.
    static ErrorField nearValues(std::span<const double> isovalues, double inner, double outer, double falloff);
    /// `inner` where the opacity, given by knots (value, opacity in [0, 1]), is 1, `outer` where it is 0, linear
    /// between.
    static ErrorField byOpacity(std::span<const std::array<double, 2>> opacity, double inner, double outer);

    friend ErrorField operator+(const ErrorField& first, const ErrorField& second);
    friend ErrorField operator*(const ErrorField& first, const ErrorField& second);
    friend ErrorField smallerOf(const ErrorField& first, const ErrorField& second);
    friend ErrorField largerOf(const ErrorField& first, const ErrorField& second);

    /// Whether it is the same everywhere by its form; then bounds() gives the number, twice. What is made of numbers
    /// alone is one.
    bool isConstant() const noexcept;
    /// Whether it does not depend on the value, or not on the place.
    bool dependsOnValue() const noexcept;
    bool dependsOnPlace() const noexcept;
    /// The ramp, if the field is one in space and nothing else.
    const SpaceRamp* asSpaceRamp() const noexcept;

    /// Negative numbers count as 0, here and in what follows.
    double at(const Eigen::Vector3d& place, double value) const;
    /// Bounds on the field over all places and values (for a constant, the constant twice).
    ValueRange bounds() const;
    /// A number that the field is nowhere below, in the convex hull of the corners moved by at most `margin`, for
    /// values in `values`. Tight for a single ramp in space of falloff 0 whose inner error is the smaller one: `outer`
    /// unless hull and region meet. O(1) for each ramp; the bounding box is looked at first.
    double leastIn(const std::array<Eigen::Vector3d, 4>& corners, double margin, const ValueRange& values) const;

    /// Equal by form.
    bool operator==(const ErrorField& other) const;

    struct Node; ///< of the expression; for its text form
    const Node& root() const noexcept { return *root_; }

private:
    explicit ErrorField(std::shared_ptr<const Node> root) : root_(std::move(root)) {}
    std::shared_ptr<const Node> root_;
};

enum class FieldOperation { Sum, Product, Smaller, Larger };
struct ErrorField::Node {
    struct Pair {
        FieldOperation operation;
        ErrorField first;
        ErrorField second;
        bool operator==(const Pair&) const = default;
    };
    std::variant<double, SpaceRamp, ValueRamp, Pair> content;
};

using Corners = std::array<Eigen::Vector3d, 4>;

/// Whether a tetrahedron, of any orientation, and a closed box have a common point: separating axes. Two bodies that
/// are apart by less than `tolerance`, relative to the coordinates, meet; with a tolerance of 0 the answer is exact as
/// far as doubles are, so for coordinates that are small integers. What is not a number meets everything.
bool tetrahedronMeetsBox(const Corners& corners, const Box& box, double tolerance);

/// The square of the distance of a place from a tetrahedron, 0 within, to rounding. NaN for what is not a number.
double squaredDistance(const Corners& corners, const Eigen::Vector3d& place);

/// The convex hull of four corners moved by at most `margin`, with a box around it that holds every point of it as
/// doubles round it.
struct Hull {
    Hull(const Corners& corners, double margin);

    const Corners& corners; ///< not owned
    double margin;          ///< not negative
    Eigen::Vector3d least;
    Eigen::Vector3d largest;
    /// Nothing else holds if a number among the corners or the margin is none, or infinite.
    bool finite;
};

/// Bounds on distanceTo(region, place) for all places of a finite hull, from its box: never more, or never less, than
/// what that function returns.
double nearestDistance(const Region& region, const Hull& hull);
double farthestDistance(const Region& region, const Hull& hull);

/// Whether hull and region have a common point, exactly but for rounding and for the margin, in favour of yes: if not,
/// distanceTo() is positive at every place of the hull.
bool meets(const Region& region, const Hull& hull);

/// Of numbers that are not negative, infinity among them. Never decreasing in either of them, also in doubles: so least
/// numbers make a least number.
inline double applied(FieldOperation operation, double first, double second)
{
    switch (operation) {
    case FieldOperation::Sum: return first + second;
    case FieldOperation::Product: return first > 0 && second > 0 ? first * second : 0; // infinity times 0 is 0
    case FieldOperation::Smaller: return std::min(first, second);
    case FieldOperation::Larger: return std::max(first, second);
    }
    return 0;
}

} // namespace tetra
