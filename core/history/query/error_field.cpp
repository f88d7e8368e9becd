// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/error_field.h"

#include "core/base/sort_unique.h"

#include <tan/query.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

// What an error field is at a place, and what it is at least in many. The least numbers hold for what at() returns, not
// only for what it should return: each step of at() is also in doubles a never decreasing, or never increasing,
// function of the distance or of the position between two knots.

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
    sortUnique(sorted);
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

namespace {

using Eigen::Vector3d;

/// Each face, and the corner that it leaves out last.
constexpr std::array<std::array<int, 4>, 4> faces = {{{1, 2, 3, 0}, {0, 2, 3, 1}, {0, 1, 3, 2}, {0, 1, 2, 3}}};
constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// A place is taken for one over a triangle if it is outside by less than this part of it: the distance from its plane
/// is then as good as that from its edge.
constexpr double overTriangle = 1e-9;

double largestCoordinate(const Corners& corners, const Box& box)
{
    double largest = std::max(box.least.cwiseAbs().maxCoeff(), box.largest.cwiseAbs().maxCoeff());
    for (const Vector3d& corner : corners)
        largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    return largest;
}

/// The least and the largest of axis . x in the box.
std::array<double, 2> extentOf(const Box& box, const Vector3d& axis)
{
    const Vector3d some = axis.cwiseProduct(box.least);
    const Vector3d others = axis.cwiseProduct(box.largest);
    return {some.cwiseMin(others).sum(), some.cwiseMax(others).sum()};
}

std::array<double, 2> extentOf(const Corners& corners, const Vector3d& axis)
{
    const auto [least, largest] =
        std::minmax({axis.dot(corners[0]), axis.dot(corners[1]), axis.dot(corners[2]), axis.dot(corners[3])});
    return {least, largest};
}

bool apart(const std::array<double, 2>& one, const std::array<double, 2>& other, double tolerance)
{
    return one[0] > other[1] + tolerance || other[0] > one[1] + tolerance;
}

bool apartAlong(const Vector3d& axis, const Corners& corners, const Box& box, double tolerance)
{
    return apart(extentOf(corners, axis), extentOf(box, axis), tolerance * axis.lpNorm<1>());
}

bool apartAlongBoxAxes(const Corners& corners, const Box& box, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis)
        if (apartAlong(Vector3d::Unit(axis), corners, box, tolerance))
            return true;
    return false;
}

bool apartAlongFaces(const Corners& corners, const Box& box, double tolerance)
{
    for (const auto& [a, b, c, opposite] : faces) {
        const Vector3d normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        if (apartAlong(normal, corners, box, tolerance))
            return true;
    }
    return false;
}

bool apartAlongEdges(const Corners& corners, const Box& box, double tolerance)
{
    for (const auto& [from, to] : edges) {
        const Vector3d edge = corners[to] - corners[from];
        for (const Vector3d& axis :
             {Vector3d(0, -edge.z(), edge.y()), Vector3d(edge.z(), 0, -edge.x()), Vector3d(-edge.y(), edge.x(), 0)})
            if (apartAlong(axis, corners, box, tolerance))
                return true;
    }
    return false;
}

double squaredDistanceFromEdge(const Vector3d& from, const Vector3d& to, const Vector3d& place)
{
    const Vector3d edge = to - from;
    const double squaredLength = edge.squaredNorm();
    const double along = squaredLength > 0 ? std::clamp((place - from).dot(edge) / squaredLength, 0.0, 1.0) : 0;
    return (from + along * edge - place).squaredNorm();
}

/// Whether the place is over the triangle a, b, c of that normal, and not over the plane around it.
bool isOver(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal, const Vector3d& place)
{
    const double least = -overTriangle * normal.squaredNorm();
    const auto beyond = [&](const Vector3d& from, const Vector3d& to) {
        return (to - from).cross(place - from).dot(normal) < least;
    };
    return !beyond(a, b) && !beyond(b, c) && !beyond(c, a);
}

} // namespace

bool tetrahedronMeetsBox(const Corners& corners, const Box& box, double tolerance)
{
    const double margin = tolerance > 0 ? tolerance * largestCoordinate(corners, box) : 0;
    // Seen from a corner the numbers are small, and differences of nearby floats are exact.
    const Vector3d& origin = corners[0];
    const Corners moved = {Vector3d(0, 0, 0), corners[1] - origin, corners[2] - origin, corners[3] - origin};
    const Box movedBox{box.least - origin, box.largest - origin};
    return !apartAlongBoxAxes(corners, box, margin) && !apartAlongFaces(moved, movedBox, margin) &&
           !apartAlongEdges(moved, movedBox, margin);
}

double squaredDistance(const Corners& corners, const Eigen::Vector3d& place)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : edges) {
        const double fromEdge = squaredDistanceFromEdge(corners[from], corners[to], place);
        if (!(fromEdge >= least)) // also what is not a number, which stays
            least = fromEdge;
    }
    bool within = true;
    for (const auto& [a, b, c, opposite] : faces) {
        const Vector3d normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        const double height = normal.dot(place - corners[a]);
        within &= height * normal.dot(corners[opposite] - corners[a]) > 0;
        // The edges see to triangles that are none.
        if (normal.squaredNorm() > 0 && isOver(corners[a], corners[b], corners[c], normal, place))
            least = std::min(least, height * height / normal.squaredNorm());
    }
    return within ? 0 : least;
}

namespace {

using Eigen::Vector3d;

constexpr double distanceRounding = 8 * std::numeric_limits<double>::epsilon();
/// What the separating axes and the distance from a tetrahedron may be wrong by, relative to the coordinates.
constexpr double testRounding = 1e-13;

// The order of the arguments of std::max below matters: what is not a number counts as 0, so as within.

double distance(const Box& box, const Vector3d& least, const Vector3d& largest)
{
    Vector3d gap;
    for (int axis = 0; axis < 3; ++axis)
        gap[axis] = std::max(std::max(0.0, box.least[axis] - largest[axis]), least[axis] - box.largest[axis]);
    return gap.norm();
}

double distance(const Sphere& sphere, const Vector3d& least, const Vector3d& largest)
{
    return std::max(0.0, distance(Box{sphere.centre, sphere.centre}, least, largest) - sphere.radius);
}

double farthest(const Box& box, const Hull& hull)
{
    Vector3d gap;
    for (int axis = 0; axis < 3; ++axis)
        gap[axis] = std::max(std::max(0.0, box.least[axis] - hull.least[axis]), hull.largest[axis] - box.largest[axis]);
    return gap.norm();
}

double farthest(const Sphere& sphere, const Hull& hull)
{
    return std::max(0.0, farthest(Box{sphere.centre, sphere.centre}, hull) - sphere.radius);
}

/// How far doubles may be off in normal . x - offset, anywhere in the hull, and the margin.
double uncertainty(const HalfSpace& half, const Hull& hull)
{
    const Vector3d size = hull.least.cwiseAbs().cwiseMax(hull.largest.cwiseAbs());
    return hull.margin + distanceRounding * (half.normal.cwiseAbs().dot(size) + std::abs(half.offset) + hull.margin);
}

double distance(const HalfSpace& half, const Hull& hull)
{
    double height = half.normal.dot(hull.corners[0]);
    for (int corner = 1; corner < 4; ++corner)
        height = std::min(height, half.normal.dot(hull.corners[corner]));
    return std::max(0.0, height - half.offset - uncertainty(half, hull));
}

double farthest(const HalfSpace& half, const Hull& hull)
{
    double height = half.normal.dot(hull.corners[0]);
    for (int corner = 1; corner < 4; ++corner)
        height = std::max(height, half.normal.dot(hull.corners[corner]));
    return std::max(0.0, height - half.offset + uncertainty(half, hull));
}

bool isWithin(const Box& box, const Vector3d& place)
{
    return (place.array() >= box.least.array()).all() && (place.array() <= box.largest.array()).all();
}

bool meetsHull(const Box& box, const Hull& hull)
{
    if ((hull.least.array() > box.largest.array()).any() || (hull.largest.array() < box.least.array()).any())
        return false;
    const Vector3d margin = Vector3d::Constant(hull.margin);
    const Box widened{box.least - margin, box.largest + margin};
    for (const Vector3d& corner : hull.corners)
        if (isWithin(widened, corner))
            return true;
    return tetrahedronMeetsBox(hull.corners, widened, testRounding);
}

bool meetsHull(const Sphere& sphere, const Hull& hull)
{
    if (distance(sphere, hull.least, hull.largest) > 0)
        return false;
    const double size = hull.least.cwiseAbs().cwiseMax(hull.largest.cwiseAbs()).maxCoeff();
    const double reach = sphere.radius + hull.margin + testRounding * (size + sphere.centre.cwiseAbs().maxCoeff());
    for (const Vector3d& corner : hull.corners)
        if ((corner - sphere.centre).squaredNorm() <= reach * reach)
            return true;
    return !(squaredDistance(hull.corners, sphere.centre) > reach * reach);
}

bool meetsHull(const HalfSpace& half, const Hull& hull)
{
    return !(distance(half, hull) > 0);
}

} // namespace

Hull::Hull(const Corners& hullCorners, double hullMargin)
    : corners(hullCorners), margin(hullMargin < 0 ? 0 : hullMargin),
      least(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2].cwiseMin(corners[3]))),
      largest(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2].cwiseMax(corners[3]))),
      finite(std::isfinite((corners[0] + corners[1] + corners[2] + corners[3]).sum() + margin))
{
    const Vector3d pad =
        (distanceRounding * least.cwiseAbs().cwiseMax(largest.cwiseAbs())).array() + margin * (1 + distanceRounding);
    least -= pad;
    largest += pad;
}

double distanceTo(const Region& region, const Eigen::Vector3d& place)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return distance(*box, place, place);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return distance(*sphere, place, place);
    const HalfSpace& half = *std::get_if<HalfSpace>(&region);
    return std::max(0.0, half.normal.dot(place) - half.offset);
}

double nearestDistance(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return distance(*box, hull.least, hull.largest);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return distance(*sphere, hull.least, hull.largest);
    return distance(*std::get_if<HalfSpace>(&region), hull);
}

double farthestDistance(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return farthest(*box, hull);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return farthest(*sphere, hull);
    return farthest(*std::get_if<HalfSpace>(&region), hull);
}

bool meets(const Region& region, const Hull& hull)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return meetsHull(*box, hull);
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return meetsHull(*sphere, hull);
    return meetsHull(*std::get_if<HalfSpace>(&region), hull);
}

namespace {

using Node = ErrorField::Node;

constexpr auto valueOf = [](const std::array<double, 2>& knot) { return knot[0]; };
constexpr auto errorOf = [](const std::array<double, 2>& knot) { return knot[1]; };

/// From `first` at 0 to `second` at 1.
double interpolated(double first, double second, double part)
{
    if (!(part > 0)) // also infinity divided by itself
        return first;
    if (part >= 1)
        return second;
    if (std::isinf(first)) // less something infinite it would be no number
        return first;
    return std::clamp(first + (second - first) * part, std::min(first, second), std::max(first, second));
}

double atDistance(const SpaceRamp& ramp, double distance)
{
    if (ramp.falloff > 0)
        return interpolated(ramp.inner, ramp.outer, distance / ramp.falloff);
    return distance > 0 ? ramp.outer : ramp.inner;
}

double leastOf(const SpaceRamp& ramp)
{
    return std::min(ramp.inner, ramp.outer);
}
double largestOf(const SpaceRamp& ramp)
{
    return std::max(ramp.inner, ramp.outer);
}

double leastOf(const ValueRamp& ramp)
{
    return ramp.knots.empty() ? 0 : std::ranges::min(ramp.knots, {}, errorOf)[1];
}

double largestOf(const ValueRamp& ramp)
{
    return ramp.knots.empty() ? 0 : std::ranges::max(ramp.knots, {}, errorOf)[1];
}

double at(const ValueRamp& ramp, double value)
{
    if (std::isnan(value))
        return leastOf(ramp);
    const auto first = std::ranges::lower_bound(ramp.knots, value, {}, valueOf);
    const auto last = std::ranges::upper_bound(first, ramp.knots.end(), value, {}, valueOf);
    if (first != last)
        return errorOf(*std::ranges::min_element(first, last, {}, errorOf));
    if (first == ramp.knots.begin())
        return first == ramp.knots.end() ? 0 : errorOf(*first);
    const auto& [valueBefore, errorBefore] = *(first - 1);
    if (first == ramp.knots.end())
        return errorBefore;
    return interpolated(errorBefore, errorOf(*first), (value - valueBefore) / (valueOf(*first) - valueBefore));
}

double leastOf(const ValueRamp& ramp, const ValueRange& values)
{
    if (!(values.minimum <= values.maximum))
        return leastOf(ramp);
    double found = std::min(at(ramp, values.minimum), at(ramp, values.maximum));
    for (auto knot = std::ranges::lower_bound(ramp.knots, values.minimum, {}, valueOf);
         knot != ramp.knots.end() && valueOf(*knot) <= values.maximum; ++knot)
        found = std::min(found, errorOf(*knot));
    return found;
}

double leastOf(const SpaceRamp& ramp, const Hull& hull)
{
    if (!hull.finite)
        return leastOf(ramp);
    if (ramp.inner > ramp.outer)
        return atDistance(ramp, farthestDistance(ramp.region, hull));
    if (ramp.falloff > 0)
        return atDistance(ramp, nearestDistance(ramp.region, hull));
    return meets(ramp.region, hull) ? ramp.inner : ramp.outer;
}

/// The box around the hull is found when a ramp asks for it.
class Least {
public:
    Least(const Corners& corners, double margin, const ValueRange& values)
        : corners_(corners), margin_(margin), values_(values)
    {
    }

    double of(const Node& node)
    {
        if (const double* const number = std::get_if<double>(&node.content))
            return *number;
        if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content)) {
            if (!hull_)
                hull_.emplace(corners_, margin_);
            return leastOf(*ramp, *hull_);
        }
        if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
            return leastOf(*ramp, values_);
        const Node::Pair& pair = *std::get_if<Node::Pair>(&node.content);
        return applied(pair.operation, of(pair.first.root()), of(pair.second.root()));
    }

private:
    const Corners& corners_;
    double margin_;
    const ValueRange& values_;
    std::optional<Hull> hull_;
};

ValueRange boundsOf(const Node& node)
{
    if (const auto* const pair = std::get_if<Node::Pair>(&node.content)) {
        const ValueRange first = pair->first.bounds();
        const ValueRange second = pair->second.bounds();
        return {applied(pair->operation, first.minimum, second.minimum),
                applied(pair->operation, first.maximum, second.maximum)};
    }
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content))
        return {leastOf(*ramp), largestOf(*ramp)};
    if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
        return {leastOf(*ramp), largestOf(*ramp)};
    const double number = *std::get_if<double>(&node.content);
    return {number, number};
}

double evaluated(const Node& node, const Eigen::Vector3d& place, double value)
{
    if (const double* const number = std::get_if<double>(&node.content))
        return *number;
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&node.content))
        return atDistance(*ramp, distanceTo(ramp->region, place));
    if (const ValueRamp* const ramp = std::get_if<ValueRamp>(&node.content))
        return at(*ramp, value);
    const Node::Pair& pair = *std::get_if<Node::Pair>(&node.content);
    return applied(pair.operation, evaluated(pair.first.root(), place, value),
                   evaluated(pair.second.root(), place, value));
}

} // namespace

double ErrorField::at(const Eigen::Vector3d& place, double value) const
{
    return evaluated(*root_, place, value);
}

ValueRange ErrorField::bounds() const
{
    return boundsOf(*root_);
}

double ErrorField::leastIn(const std::array<Eigen::Vector3d, 4>& corners, double margin, const ValueRange& values) const
{
    if (const double* const number = std::get_if<double>(&root_->content))
        return *number;
    if (const SpaceRamp* const ramp = std::get_if<SpaceRamp>(&root_->content))
        return leastOf(*ramp, Hull(corners, margin));
    return Least(corners, margin, values).of(*root_);
}

} // namespace tetra
