// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/boundary_cost.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace tetra {

void BoundaryPoints::clear(std::uint32_t triangle)
{
    pool_.release(at(triangle).outside);
    pool_.release(at(triangle).ofBoundary);
    at(triangle) = {};
}

void BoundaryPoints::addOutside(std::uint32_t triangle, std::uint32_t point, float error, float warping)
{
    Relation& relation = at(triangle);
    relation.outside = pool_.appended(relation.outside, {&point, 1});
    everOutside_.insert(point);
    relation.error = std::max(relation.error, error);
    relation.warping = std::max(relation.warping, warping);
}

void BoundaryPoints::addOfBoundary(std::uint32_t triangle, std::uint32_t point, float warping)
{
    Relation& relation = at(triangle);
    relation.ofBoundary = pool_.appended(relation.ofBoundary, {&point, 1});
    relation.warping = std::max(relation.warping, warping);
}

void BoundaryPoints::setDistance(std::uint32_t triangle, double distance, float warping)
{
    Relation& relation = at(triangle);
    relation.distance = distance;
    relation.warping = std::max(relation.warping, warping);
}

void BoundaryPoints::takeOutside(std::uint32_t triangle, std::uint32_t point)
{
    Relation& relation = at(triangle);
    relation.outside = pool_.without(relation.outside, point);
}

namespace {

/// How far outside of a tetrahedron, as a share of it, a place may seem by rounding.
constexpr double insideTolerance = 1e-11;

/// By how much of its edges the box around a star is widened where points may lie in it.
constexpr double besideStar = 1e-9;

} // namespace

void BoundaryCost::set(const CollapsibleMesh& mesh, const VertexStar& star, std::span<const std::uint32_t> inside,
                       const BoundaryPoints& relations)
{
    vertex_ = star.vertex();
    findKept(mesh, star);
    distance_ = 0;
    for (const VertexStar::RimTriangle& rim : star.rim())
        distance_ = std::max(distance_, relations[rim.triangle].distance);
    least_ = greatest_ = {};
    for (std::uint32_t place = 0; place < star.link().size(); ++place)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least_[axis] = std::min(least_[axis], star.place(place)[axis]);
            greatest_[axis] = std::max(greatest_[axis], star.place(place)[axis]);
        }
    points_.clear();
    ofBoundary_.clear();
    for (const std::uint32_t point : inside)
        addPoint(point, none, false, points_);
    addPoint(vertex_, none, false, ofBoundary_);
    for (const VertexStar::RimTriangle& rim : star.rim()) {
        for (const std::uint32_t point : relations.outside(rim.triangle))
            addPoint(point, none, false, points_);
        for (const std::uint32_t point : relations.ofBoundary(rim.triangle))
            addPoint(point, none, false, ofBoundary_);
    }
    for (const Triangle& triangle : kept_)
        for (const std::uint32_t point : relations.outside(triangle.number))
            addPoint(point, triangle.number, true, points_);
    const Eigen::Vector3d margin = besideStar * (Eigen::Vector3d(greatest_.data()) - Eigen::Vector3d(least_.data()));
    const Eigen::Vector3d& place = input_.positions[vertex_];
    relations.visitEverOutside(
        {place + Eigen::Vector3d(least_.data()) - margin, place + Eigen::Vector3d(greatest_.data()) + margin},
        [&](std::uint32_t point) { addPoint(point, none, true, points_); });
    dropDoubles();
}

/// A point of a tetrahedron may also be related to a triangle. Only one entry is kept: one whose triangle keeps the
/// point, if there is one.
void BoundaryCost::dropDoubles()
{
    ranks_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Point& point = points_[i];
        const std::uint64_t behind = (point.keptBy == none ? 2U : 0U) + (point.stays ? 1U : 0U);
        ranks_.push_back({std::uint64_t(point.point) << 2 | behind, i});
    }
    std::ranges::sort(ranks_);
    const auto surplus = std::ranges::unique(ranks_, {}, [](const auto& rank) { return rank.first >> 2; });
    ranks_.erase(surplus.begin(), surplus.end());
    distinct_.clear();
    for (const auto& [rank, place] : ranks_)
        distinct_.push_back(points_[place]);
    points_.swap(distinct_);
}

/// Whether the box around the star has the place, or nearly.
bool BoundaryCost::mayBeInStar(const Vector& place) const
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double margin = besideStar * (greatest_[axis] - least_[axis]);
        if (place[axis] < least_[axis] - margin || place[axis] > greatest_[axis] + margin)
            return false;
    }
    return true;
}

void BoundaryCost::findKept(const CollapsibleMesh& mesh, const VertexStar& star)
{
    kept_.clear();
    for (const std::uint32_t slot : star.tetrahedra()) {
        const std::size_t corner = indexOf(mesh.vertices(slot), vertex_);
        const std::uint32_t opposite = mesh.neighbours(slot)[corner];
        if (CollapsibleMesh::isTriangle(opposite))
            kept_.push_back(triangleOf(opposite, mesh.cornersOfFaceOf(slot, corner)));
    }
}

BoundaryCost::Triangle BoundaryCost::triangleOf(std::uint32_t number, const std::array<std::uint32_t, 3>& corners) const
{
    Triangle triangle;
    triangle.number = number;
    triangle.vertices = corners;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.corners[i] = placeOf(corners[i]);
        triangle.values[i] = input_.values[corners[i]];
    }
    const auto& [a, b, c] = triangle.corners;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        triangle.least[axis] = std::min({a[axis], b[axis], c[axis]});
        triangle.greatest[axis] = std::max({a[axis], b[axis], c[axis]});
    }
    return triangle;
}

void BoundaryCost::addPoint(std::uint32_t point, std::uint32_t keptBy, bool stays, std::vector<Point>& to)
{
    to.push_back({point, keptBy, stays, placeOf(point)});
}

BoundaryCost::Vector BoundaryCost::placeOf(std::uint32_t vertex) const
{
    const Eigen::Vector3d place = input_.positions[vertex] - input_.positions[vertex_];
    return {place.x(), place.y(), place.z()};
}

/// Takes the triangle, if it is nearer.
void BoundaryCost::approach(const Triangle& triangle, const Vector& place, Nearest& nearest) const
{
    double fromBox = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double away = std::max({triangle.least[axis] - place[axis], place[axis] - triangle.greatest[axis], 0.0});
        fromBox += away * away;
    }
    if (fromBox >= nearest.squaredDistance)
        return;
    std::array<Vector, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            corners[i][axis] = triangle.corners[i][axis] - place[axis];
    const auto weights = nearestWeights(corners);
    double squaredDistance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double away =
            weights[0] * corners[0][axis] + weights[1] * corners[1][axis] + weights[2] * corners[2][axis];
        squaredDistance += away * away;
    }
    if (squaredDistance >= nearest.squaredDistance)
        return;
    nearest = {squaredDistance, 0, triangle.number};
    for (std::size_t i = 0; i < 3; ++i)
        nearest.value += weights[i] * triangle.values[i];
}

/// On the boundary triangles of the tetrahedra that the collapse makes.
BoundaryCost::Nearest BoundaryCost::onFan(const Point& point) const
{
    Nearest nearest;
    for (const auto& triangles : {std::span(fresh_), std::span(kept_)})
        for (const Triangle& triangle : triangles)
            approach(triangle, point.place, nearest);
    return nearest;
}

double BoundaryCost::warpingOf(const Point& point, const Nearest& projection) const
{
    const double distance = std::sqrt(projection.squaredDistance);
    return distance > measure_.leastWarping ? weight(point.point) * distance : 0;
}

double BoundaryCost::errorOf(const Point& point, double interpolated) const
{
    const double residual = std::abs(input_.values[point.point] - interpolated);
    return residual > measure_.leastError ? weight(point.point) * residual : 0;
}

double BoundaryCost::judgeError(const Point& point, const CollapseStar& fan)
{
    Vector place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] = point.place[axis] - fan.apex()[axis];
    Error error{point.point, point.keptBy, none, none, 0, 0};
    if (mayBeInStar(point.place))
        error.inFan = faceAt(fan, place, insideTolerance);
    if (error.inFan != none) {
        error.error = errorOf(point, fan.interpolated(error.inFan, 0, fan.weightsAt(error.inFan, place)));
    } else {
        if (point.stays)
            return 0;
        const Nearest projection = onFan(point);
        error.triangle = projection.triangle;
        error.error = errorOf(point, projection.value);
        error.warping = warpingOf(point, projection);
    }
    errors_.push_back(error);
    return std::max(error.error, measure_.warpingWeight * error.warping);
}

double BoundaryCost::judgeWarping(const Point& point)
{
    const Nearest projection = onFan(point);
    warpings_.push_back({point.point, projection.triangle, warpingOf(point, projection)});
    return measure_.warpingWeight * warpings_.back().warping;
}

namespace {

struct InPlane {
    Eigen::Vector2d place;
    double height;
};

double crossInPlane(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

/// How far any place of the new boundary triangles is from one of the old: seen along the mean of the old normals both
/// lie over one polygon. There, where they are functions, which are linear in the parts into which their edges cut it,
/// their difference is largest at a corner of a part: at the vertex, or where an edge of one crosses one of the other.
/// Infinity if they are no functions.
double BoundaryCost::stepOf(const VertexStar& star, std::uint32_t linkPlace) const
{
    constexpr double none = std::numeric_limits<double>::infinity();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    const auto placeIn = [&](std::uint32_t place) { return Eigen::Vector3d(star.place(place).data()); };
    for (const VertexStar::RimTriangle& rim : star.rim())
        normal += placeIn(rim.corners[0]).cross(placeIn(rim.corners[1]));
    const double length = normal.norm();
    if (!(length > 0))
        return none;
    normal /= length;
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    const auto seen = [&](std::uint32_t place) {
        const Eigen::Vector3d at = placeIn(place);
        return InPlane{{at.dot(x), at.dot(y)}, at.dot(normal)};
    };
    const InPlane to = seen(linkPlace);
    double turned = 0, largest = 0;
    bool holdsVertex = false;
    for (const VertexStar::RimTriangle& rim : star.rim()) {
        const InPlane a = seen(rim.corners[0]), b = seen(rim.corners[1]);
        if (!(crossInPlane(a.place, b.place) > 0))
            return none;
        turned += std::atan2(crossInPlane(a.place, b.place), a.place.dot(b.place));
        if (rim.corners[0] == linkPlace || rim.corners[1] == linkPlace)
            continue;
        const Eigen::Vector2d toA = a.place - to.place, toB = b.place - to.place;
        const double area = crossInPlane(toA, toB);
        if (!(area > 0))
            return none;
        // The vertex is the origin: its height over the new triangle.
        const double ofA = crossInPlane(-to.place, toB) / area, ofB = crossInPlane(toA, -to.place) / area;
        constexpr double beside = -1e-9;
        if (ofA >= beside && ofB >= beside && ofA + ofB <= 1 - beside) {
            holdsVertex = true;
            largest = std::max(largest, std::abs((1 - ofA - ofB) * to.height + ofA * a.height + ofB * b.height));
        }
        // The new edge to the first corner, and all the old ones.
        for (const VertexStar::RimTriangle& other : star.rim()) {
            const InPlane old = seen(other.corners[0]);
            const double across = crossInPlane(toA, old.place);
            if (across == 0)
                continue;
            // to + s (a - to) = t old
            const double s = crossInPlane(old.place, to.place) / across, t = crossInPlane(toA, -to.place) / -across;
            if (s >= beside && s <= 1 - beside && t >= beside && t <= 1 - beside)
                largest = std::max(largest, std::abs(to.height + s * (a.height - to.height) - t * old.height));
        }
    }
    constexpr double oneTurn = 7; // a little more than that, and much less than two
    return turned < oneTurn && holdsVertex ? largest : none;
}

/// Of the new boundary triangles: bounds on their distances from the original boundary, no closer than what counts
/// beside `cost` or says that it is more than `bound`. Returns the cost with them.
double BoundaryCost::judgeDistances(const VertexStar& star, std::uint32_t linkPlace, double cost, double bound)
{
    const double step = stepOf(star, linkPlace);
    const double sum = distance_ + (step > measure_.leastWarping ? step : 0);
    const double tooMuch = bound / measure_.warpingWeight;
    for (const Triangle& triangle : fresh_) {
        if (cost > bound)
            break;
        const double enough = cost / measure_.warpingWeight;
        distances_.push_back({triangle.number, toBoundary_->bound(triangle.vertices, sum, enough, tooMuch)});
        cost = std::max(cost, measure_.warpingWeight * distances_.back().distance);
    }
    return cost;
}

double BoundaryCost::evaluate(const VertexStar& star, std::uint32_t linkPlace, const CollapseStar& fan, double bound)
{
    fresh_.clear();
    for (const VertexStar::RimTriangle& rim : star.rim())
        if (comesWithTetrahedron(star, rim, linkPlace))
            fresh_.push_back(triangleOf(
                rim.triangle, {star.link()[linkPlace], star.link()[rim.corners[0]], star.link()[rim.corners[1]]}));
    errors_.clear();
    warpings_.clear();
    double largest = 0;
    for (auto point = ofBoundary_.begin(); point != ofBoundary_.end() && largest <= bound; ++point)
        largest = std::max(largest, judgeWarping(*point));
    for (auto point = points_.begin(); point != points_.end() && largest <= bound; ++point)
        largest = std::max(largest, judgeError(*point, fan));
    distances_.clear();
    return toBoundary_ != nullptr && largest <= bound ? judgeDistances(star, linkPlace, largest, bound) : largest;
}

} // namespace tetra
