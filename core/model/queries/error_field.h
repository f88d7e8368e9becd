// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/scalar_field.h"
#include "core/mesh/region.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

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

} // namespace tetra
