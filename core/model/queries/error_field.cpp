// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/error_field.h"

#include "core/model/queries/field_operations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetra {

namespace {

using Node = ErrorField::Node;

/// Negative numbers count as 0, and so does what is no number: nothing is more accurate.
double orZero(double number)
{
    return number > 0 ? number : 0;
}

/// The same half-space with a normal of length 1, which it keeps bit for bit if it has that already.
HalfSpace normalized(HalfSpace half)
{
    const double length = half.normal.norm();
    if (length > 0 && std::isfinite(length) && std::abs(length - 1) > 1e-12) {
        half.normal /= length;
        half.offset /= length;
    }
    return half;
}

Sphere normalized(const Sphere& sphere)
{
    return {sphere.centre, orZero(sphere.radius)};
}

Box normalized(Box box)
{
    for (int axis = 0; axis < 3; ++axis)
        if (box.least[axis] > box.largest[axis])
            std::swap(box.least[axis], box.largest[axis]);
    return box;
}

SpaceRamp normalized(SpaceRamp ramp)
{
    ramp.region = std::visit([](const auto& body) { return Region(normalized(body)); }, ramp.region);
    ramp.inner = orZero(ramp.inner);
    ramp.outer = orZero(ramp.outer);
    ramp.falloff = orZero(ramp.falloff);
    return ramp;
}

ValueRamp normalized(ValueRamp ramp)
{
    std::erase_if(ramp.knots, [](const auto& knot) { return std::isnan(knot[0]); });
    std::ranges::stable_sort(ramp.knots, {}, [](const auto& knot) { return knot[0]; });
    for (auto& [value, error] : ramp.knots)
        error = orZero(error);
    return ramp;
}

/// Two numbers make a number, so that what is constant can be told at a glance.
Node combined(FieldOperation operation, const ErrorField& first, const ErrorField& second)
{
    const double* const one = std::get_if<double>(&first.root().content);
    const double* const other = std::get_if<double>(&second.root().content);
    if (one != nullptr && other != nullptr)
        return {applied(operation, *one, *other)};
    return {Node::Pair{operation, first, second}};
}

/// Whether one of the leaves is of the type.
template <class Leaf> bool isNode(const Node& node)
{
    if (const auto* const pair = std::get_if<Node::Pair>(&node.content))
        return isNode<Leaf>(pair->first.root()) || isNode<Leaf>(pair->second.root());
    return std::holds_alternative<Leaf>(node.content);
}

} // namespace

ErrorField::ErrorField(double percent) : root_(std::make_shared<const Node>(Node{orZero(percent)})) {}
ErrorField::ErrorField(SpaceRamp ramp) : root_(std::make_shared<const Node>(Node{normalized(std::move(ramp))})) {}
ErrorField::ErrorField(ValueRamp ramp) : root_(std::make_shared<const Node>(Node{normalized(std::move(ramp))})) {}

ErrorField ErrorField::nearValues(std::span<const double> isovalues, double inner, double outer, double falloff)
{
    std::vector<double> sorted(isovalues.begin(), isovalues.end());
    std::erase_if(sorted, [](double value) { return !std::isfinite(value); });
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.empty())
        return outer;
    const double reach = orZero(falloff);
    ValueRamp ramp{{{sorted.front() - reach, outer}}};
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        ramp.knots.push_back({sorted[i], inner});
        const double gap = i + 1 < sorted.size() ? sorted[i + 1] - sorted[i] : std::numeric_limits<double>::infinity();
        if (gap < 2 * reach) {
            const double half = gap / 2;
            ramp.knots.push_back({sorted[i] + half, inner + (outer - inner) * (half / reach)});
            continue;
        }
        ramp.knots.push_back({sorted[i] + reach, outer});
        if (i + 1 < sorted.size())
            ramp.knots.push_back({sorted[i + 1] - reach, outer});
    }
    return ramp;
}

ErrorField ErrorField::byOpacity(std::span<const std::array<double, 2>> opacity, double inner, double outer)
{
    if (opacity.empty())
        return outer;
    ValueRamp ramp;
    for (const auto& [value, amount] : opacity) {
        const double part = amount <= 0 ? 0 : amount < 1 ? amount : 1; // what is no number is seen
        ramp.knots.push_back({value, part <= 0 ? outer : part >= 1 ? inner : inner * part + outer * (1 - part)});
    }
    return ramp;
}

ErrorField operator+(const ErrorField& first, const ErrorField& second)
{
    return ErrorField(std::make_shared<const Node>(combined(FieldOperation::Sum, first, second)));
}

ErrorField operator*(const ErrorField& first, const ErrorField& second)
{
    return ErrorField(std::make_shared<const Node>(combined(FieldOperation::Product, first, second)));
}

ErrorField smallerOf(const ErrorField& first, const ErrorField& second)
{
    return ErrorField(std::make_shared<const Node>(combined(FieldOperation::Smaller, first, second)));
}

ErrorField largerOf(const ErrorField& first, const ErrorField& second)
{
    return ErrorField(std::make_shared<const Node>(combined(FieldOperation::Larger, first, second)));
}

bool ErrorField::isConstant() const noexcept
{
    return std::holds_alternative<double>(root_->content);
}

bool ErrorField::dependsOnValue() const noexcept
{
    return isNode<ValueRamp>(*root_);
}

bool ErrorField::dependsOnPlace() const noexcept
{
    return isNode<SpaceRamp>(*root_);
}

const SpaceRamp* ErrorField::asSpaceRamp() const noexcept
{
    return std::get_if<SpaceRamp>(&root_->content);
}

bool ErrorField::operator==(const ErrorField& other) const
{
    return root_ == other.root_ || root_->content == other.root_->content;
}

} // namespace tetra
