// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/decimated_mesh.h"

#include "core/mesh/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetra {

namespace {

/// The mark of vertices on an irregular boundary.
constexpr std::uint8_t boundaryMark = 1;

/// How many points are asked for before the first of them is read: about what the nearest cache holds.
constexpr std::size_t pointsAhead = 128;

std::array<double, 3> arrayOf(const Eigen::Vector3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/// Residuals are sums of a few products of numbers of this size, each rounded at 2^-53 of it.
double placeRounding(double magnitude)
{
    return std::ldexp(magnitude, -48);
}

double largestCoordinate(std::span<const Eigen::Vector3d> positions)
{
    double largest = 0;
    for (const Eigen::Vector3d& position : positions)
        largest = std::max(largest, position.cwiseAbs().maxCoeff());
    return largest;
}

/// Whether six-fold volumes are exact in doubles, whatever the order of their terms.
bool exactVolumes(std::span<const Eigen::Vector3d> positions)
{
    return std::ranges::all_of(positions, [](const Eigen::Vector3d& position) {
        return (position.array() == position.array().floor()).all() && position.cwiseAbs().maxCoeff() < 32768;
    });
}

std::vector<PlacedValue> placedValuesOf(const DecimationMesh& mesh)
{
    std::vector<PlacedValue> points;
    points.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        points.push_back({arrayOf(mesh.positions[i]), mesh.values[i]});
    return points;
}

} // namespace

DecimatedMesh::DecimatedMesh(const DecimationMesh& mesh, const DecimationOptions& options)
    : input_(mesh), placedValues_(placedValuesOf(mesh)), options_(options),
      mesh_(vertexCount(), mesh.tetrahedra, !mesh.box),
      warpings_(mesh.box && mesh.lifted.empty() ? 0 : mesh_.slotCount()), keys_(mesh_.slotCount()),
      boundaryPoints_(mesh_.triangleCount()), live_(mesh_.slotCount()),
      star_(placedValues_, exactVolumes(mesh.positions)), boundaryJudge_(input_, measure_)
{
    double largestValue = 0;
    for (const double value : input_.values)
        largestValue = std::max(largestValue, std::abs(value));
    measure_ = {placeRounding(largestValue),
                placeRounding(2 * largestCoordinate(input_.box ? input_.lifted : input_.positions)),
                options.warpingWeight};
    findSides();
    constexpr std::uint64_t loggedByTetrahedron = 4; // 3.4 to 3.8 are
    log_.reserve(vertexCount(), loggedByTetrahedron * mesh_.slotCount());
}

void DecimatedMesh::findSides()
{
    sides_.resize(vertexCount(), 0);
    if (!input_.box) {
        findBoundary();
        return;
    }
    Eigen::Vector3d least = input_.positions.front(), greatest = least;
    for (const Eigen::Vector3d& position : input_.positions) {
        least = least.cwiseMin(position);
        greatest = greatest.cwiseMax(position);
    }
    for (std::uint32_t vertex = 0; vertex < vertexCount(); ++vertex)
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = input_.positions[vertex][axis];
            const int bits = (coordinate == least[axis] ? 1 : 0) | (coordinate == greatest[axis] ? 2 : 0);
            sides_[vertex] = static_cast<std::uint8_t>(sides_[vertex] | bits << 2 * axis);
        }
}

/// Marks the vertices of an irregular boundary. Where that is no surface, they stay; so does, for want of a meaning of
/// its warping in two spaces, that of a grid with holes.
void DecimatedMesh::findBoundary()
{
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t triangle = 0; triangle < mesh_.triangleCount(); ++triangle)
        triangles.push_back(mesh_.cornersOf(CollapsibleMesh::firstTriangle + triangle));
    for (const SurfaceTriangle& triangle : triangles)
        for (const std::uint32_t corner : triangle)
            sides_[corner] = boundaryMark;
    boundary_.emplace(input_.positions, triangles);
    for (std::uint32_t vertex = 0; vertex < vertexCount(); ++vertex) {
        if (sides_[vertex] == 0)
            continue;
        star_.set(mesh_, vertex, true);
        if (!input_.lifted.empty() || !star_.rimIsOneCycle())
            sides_[vertex] = locked;
    }
}

bool DecimatedMesh::mayMove(std::uint32_t vertex, std::uint32_t target) const
{
    if (sides_[vertex] == 0)
        return true;
    if (input_.box)
        return (sides_[vertex] & ~sides_[target]) == 0;
    return sides_[vertex] != locked && sides_[target] != 0;
}

float DecimatedMesh::keyOf(float error, float warping) const
{
    return std::max(error, roundedUp(options_.warpingWeight * static_cast<double>(warping)));
}

void DecimatedMesh::fetchAhead(std::uint32_t vertex, int step) const
{
    if (step == 0)
        return mesh_.prefetchStarsPlace(vertex);
    if (step == 1)
        return mesh_.prefetchStar(vertex);
    for (const std::uint32_t slot : mesh_.star(vertex))
        mesh_.prefetch(slot);
}

void DecimatedMesh::setStar(std::uint32_t vertex)
{
    star_.set(mesh_, vertex, movesOnBoundary(vertex));
    star_.measure();
    gathered_ = judging_ = sampled_ = false;
    evaluated_ = none;
    if (movesOnBoundary(vertex))
        linkCondition_.set(star_);
}

void DecimatedMesh::setFan(std::uint32_t linkPlace)
{
    gatherPoints();
    gatherSamples();
    fan_.set(star_, linkPlace, samples_);
}

void DecimatedMesh::gatherSamples()
{
    if (!sampled_)
        samples_.set(star_, input_.lifted);
    sampled_ = true;
}

/// What evaluations of collapses need besides the star's geometry.
void DecimatedMesh::gatherPoints()
{
    if (gathered_)
        return;
    gathered_ = true;
    for (const std::uint32_t slot : star_.slots())
        __builtin_prefetch(std::as_const(pool_)[mesh_.state(slot).inside].data());
    points_.points.clear();
    points_.points.push_back(star_.vertex());
    for (const std::uint32_t slot : star_.slots()) {
        const auto inside = std::as_const(pool_)[mesh_.state(slot).inside];
        points_.points.insert(points_.points.end(), inside.begin(), inside.end());
    }
    const std::size_t count = points_.count();
    for (std::size_t i = 0; i < std::min(count, pointsAhead); ++i)
        __builtin_prefetch(&placedValues_[points_.points[i]]);
    const std::size_t room = (count + StarPoints::lanes - 1) / StarPoints::lanes * StarPoints::lanes;
    const std::array<double, 3> origin = placedValues_[star_.vertex()].place;
    const bool lifted = !input_.lifted.empty(), weighted = !input_.weights.empty();
    for (auto* values : {&points_.value, &points_.error, &points_.place[0], &points_.place[1], &points_.place[2]})
        values->resize(room);
    points_.owner.resize(room);
    points_.weight.resize(weighted ? room : 0);
    points_.warping.resize(lifted ? room : 0);
    for (auto& coordinates : points_.lifted)
        coordinates.resize(lifted ? room : 0);
    for (std::size_t i = 0; i < room; ++i) {
        if (i + pointsAhead < count)
            __builtin_prefetch(&placedValues_[points_.points[i + pointsAhead]]);
        const std::uint32_t point = points_.points[i < count ? i : 0];
        const PlacedValue& placed = placedValues_[point];
        for (std::size_t axis = 0; axis < 3; ++axis)
            points_.place[axis][i] = placed.place[axis] - origin[axis];
        points_.value[i] = placed.value;
        for (std::size_t axis = 0; lifted && axis < 3; ++axis)
            points_.lifted[axis][i] = input_.lifted[point][static_cast<int>(axis)];
        if (weighted)
            points_.weight[i] = static_cast<double>(input_.weights[point]);
    }
}

bool DecimatedMesh::collapse(std::uint32_t vertex, std::uint32_t target)
{
    if (star_.vertex() != vertex)
        setStar(vertex);
    const auto link = star_.link();
    const auto place = static_cast<std::uint32_t>(std::ranges::find(link, target) - link.begin());
    const bool known = evaluated_ == place;
    for (const std::uint32_t around : link)
        mesh_.prefetchStar(around);
    if (!known)
        setFan(place);
    for (const std::uint32_t slot : star_.slots())
        keys_.prefetch(slot);
    touched_.assign(link.begin(), link.end());
    logStar();
    if (movesOnBoundary(vertex)) {
        if (!collapseOnBoundary(vertex, target))
            return false;
    } else {
        if (!known)
            evaluateFan(fan_, measure_, std::numeric_limits<double>::infinity(), points_);
        mesh_.collapse(vertex, target);
        clearStates();
        giveOutPoints();
    }
    for (const std::uint32_t face : fan_.faces())
        raiseOwn(star_.slots()[face]);
    live_ -= star_.slots().size() - fan_.faces().size();
    log_.add(vertex, key(), logged_, static_cast<std::uint32_t>(fan_.faces().size()));
    return true;
}

/// What there is to say of the tetrahedra that go.
void DecimatedMesh::logStar()
{
    logged_.clear();
    for (std::size_t i = 0; i < star_.slots().size(); ++i) {
        const std::uint32_t slot = star_.slots()[i];
        const TetrahedronState& state = mesh_.state(slot);
        CollapseLog::Tetrahedron& entry = logged_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            entry.others[k] = star_.link()[star_.faces()[i][k]];
        entry.error = state.error;
        entry.warping = warpingOf(slot);
        entry.madeBy = state.madeBy;
    }
}

void DecimatedMesh::clearStates()
{
    for (const std::uint32_t slot : star_.slots()) {
        pool_.release(mesh_.state(slot).inside);
        mesh_.state(slot) = {.inside = {}, .error = 0, .madeBy = log_.collapseCount()};
        if (!warpings_.empty())
            warpings_[slot] = 0;
        if (!mesh_.alive(slot)) // the keys of the others are set when they are known
            keys_.set(slot, 0);
    }
}

/// Gives the points of the star to the tetrahedra of the fan, as they were evaluated.
void DecimatedMesh::giveOutPoints()
{
    shares_.assign(star_.slots().size(), {});
    const std::span owners = std::span(points_.owner).first(points_.count());
    for (const std::uint32_t owner : owners)
        ++shares_[owner].count;
    for (const std::uint32_t face : fan_.faces())
        mesh_.state(star_.slots()[face]).inside = pool_.allocate(shares_[face].count);
    for (const std::uint32_t face : fan_.faces())
        shares_[face].next = pool_[mesh_.state(star_.slots()[face]).inside].data();
    for (std::size_t i = 0; i < owners.size(); ++i) {
        Share& share = shares_[owners[i]];
        *share.next++ = points_.points[i];
        share.error = std::max(share.error, points_.error[i]);
        if (!points_.warping.empty())
            share.warping = std::max(share.warping, points_.warping[i]);
    }
    for (const std::uint32_t face : fan_.faces()) {
        const std::uint32_t slot = star_.slots()[face];
        mesh_.state(slot).error = roundedUp(shares_[face].error);
        if (!warpings_.empty())
            warpings_[slot] = roundedUp(shares_[face].warping);
    }
}

/// Brings a tetrahedron's own error and warping up to what is related to it.
void DecimatedMesh::raiseOwn(std::uint32_t slot)
{
    float& error = mesh_.state(slot).error;
    if (!input_.box)
        for (const std::uint32_t neighbour : mesh_.neighbours(slot))
            if (CollapsibleMesh::isTriangle(neighbour)) {
                error = std::max(error, boundaryPoints_[neighbour].error);
                warpings_[slot] = std::max(warpings_[slot], boundaryPoints_[neighbour].warping);
            }
    keys_.set(slot, keyOf(error, warpingOf(slot)));
}

std::vector<CollapseLog::Coarsest> DecimatedMesh::coarsest() const
{
    std::vector<CollapseLog::Coarsest> tetrahedra;
    for (std::uint32_t slot = 0; slot < mesh_.slotCount(); ++slot)
        if (mesh_.alive(slot))
            tetrahedra.push_back(
                {mesh_.vertices(slot), mesh_.state(slot).error, warpingOf(slot), mesh_.state(slot).madeBy});
    return tetrahedra;
}

} // namespace tetra
