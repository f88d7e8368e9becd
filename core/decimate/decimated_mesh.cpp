// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/decimated_mesh.h"

#include "core/base/rounding.h"
#include "core/geometry/orientation.h"
#include "core/mesh/boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
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
      warpings_(mesh.box && mesh.physical.empty() ? 0 : mesh_.slotCount()), keys_(mesh_.slotCount()),
      boundaryPoints_(mesh.positions, mesh_.triangleCount()), live_(mesh_.slotCount()),
      star_(placedValues_, exactVolumes(mesh.positions)), boundaryCost_(input_, measure_)
{
    double largestValue = 0;
    for (const double value : input_.values)
        largestValue = std::max(largestValue, std::abs(value));
    measure_ = {placeRounding(largestValue),
                placeRounding(2 * largestCoordinate(input_.box ? input_.physical : input_.positions)),
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

/// Marks the vertices of an irregular boundary. Where that is not a surface, because parts touch in a vertex or an
/// edge, and where its triangles touch others, as along a seam whose sides are cut differently, the vertices stay, and
/// with them every such vertex, edge and triangle: the boundary can never come to touch itself elsewhere (C10). The
/// boundary of a grid with holes stays, too, because its warping would have no meaning in two spaces.
void DecimatedMesh::findBoundary()
{
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t triangle = 0; triangle < mesh_.triangleCount(); ++triangle)
        triangles.push_back(mesh_.cornersOf(CollapsibleMesh::firstTriangle + triangle));
    for (const SurfaceTriangle& triangle : triangles)
        for (const std::uint32_t corner : triangle)
            sides_[corner] = boundaryMark;
    boundary_.emplace(input_.positions, triangles);
    if (options_.twoSided && input_.physical.empty() && !triangles.empty())
        boundaryCost_.countDistances(toOriginal_.emplace(input_.positions, triangles));
    for (std::uint32_t vertex = 0; vertex < vertexCount(); ++vertex) {
        if (sides_[vertex] == 0)
            continue;
        star_.set(mesh_, vertex, true);
        if (!input_.physical.empty() || !star_.rimIsOneCycle())
            sides_[vertex] = locked;
    }
    if (!input_.physical.empty())
        return;
    for (const SurfaceTriangle& triangle : triangles)
        if (boundary_->isTouched(triangle))
            for (const std::uint32_t corner : triangle)
                sides_[corner] = locked;
    const std::vector<std::uint32_t> pieces = surfacePieces(triangles);
    maySwallow_ = std::ranges::any_of(pieces, [](std::uint32_t piece) { return piece > 0; });
}

bool DecimatedMesh::mayMove(std::uint32_t vertex, std::uint32_t target) const
{
    if (sides_[vertex] == 0)
        return true;
    if (input_.box)
        return (sides_[vertex] & ~sides_[target]) == 0;
    return sides_[vertex] != locked && sides_[target] != 0;
}

/// In a box the corners of a face on the boundary are on one side; no face inside has three such corners, or it would
/// lie in that side.
bool DecimatedMesh::isOnBoundary(std::uint32_t slot, std::size_t corner) const noexcept
{
    if (!input_.box)
        return CollapsibleMesh::isTriangle(mesh_.neighbours(slot)[corner]);
    const auto face = mesh_.cornersOfFaceOf(slot, corner);
    return (sides_[face[0]] & sides_[face[1]] & sides_[face[2]]) != 0;
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
        samples_.set(star_, input_.physical);
    sampled_ = true;
}

/// What evaluations of collapses need besides the star's geometry.
void DecimatedMesh::gatherPoints()
{
    if (gathered_)
        return;
    gathered_ = true;
    for (const std::uint32_t slot : star_.tetrahedra())
        __builtin_prefetch(std::as_const(pool_)[mesh_.state(slot).inside].data());
    points_.points.clear();
    points_.points.push_back(star_.vertex());
    for (const std::uint32_t slot : star_.tetrahedra()) {
        const auto inside = std::as_const(pool_)[mesh_.state(slot).inside];
        points_.points.insert(points_.points.end(), inside.begin(), inside.end());
    }
    const std::size_t count = points_.count();
    for (std::size_t i = 0; i < std::min(count, pointsAhead); ++i)
        __builtin_prefetch(&placedValues_[points_.points[i]]);
    const std::size_t padded = (count + StarPoints::lanes - 1) / StarPoints::lanes * StarPoints::lanes;
    const std::array<double, 3> origin = placedValues_[star_.vertex()].place;
    const bool physical = !input_.physical.empty(), weighted = !input_.weights.empty();
    for (auto* values : {&points_.value, &points_.error, &points_.place[0], &points_.place[1], &points_.place[2]})
        values->resize(padded);
    points_.owner.resize(padded);
    points_.weight.resize(weighted ? padded : 0);
    points_.warping.resize(physical ? padded : 0);
    for (auto& coordinates : points_.physical)
        coordinates.resize(physical ? padded : 0);
    for (std::size_t i = 0; i < padded; ++i) {
        if (i + pointsAhead < count)
            __builtin_prefetch(&placedValues_[points_.points[i + pointsAhead]]);
        const std::uint32_t point = points_.points[i < count ? i : 0];
        const PlacedValue& placed = placedValues_[point];
        for (std::size_t axis = 0; axis < 3; ++axis)
            points_.place[axis][i] = placed.place[axis] - origin[axis];
        points_.value[i] = placed.value;
        for (std::size_t axis = 0; physical && axis < 3; ++axis)
            points_.physical[axis][i] = input_.physical[point][static_cast<int>(axis)];
        if (weighted)
            points_.weight[i] = static_cast<double>(input_.weights[point]);
    }
}

bool DecimatedMesh::collapse(std::uint32_t vertex, const Candidate& candidate)
{
    const auto [target, mostKey] = candidate;
    if (star_.vertex() != vertex)
        setStar(vertex);
    const auto link = star_.link();
    const auto place = static_cast<std::uint32_t>(std::ranges::find(link, target) - link.begin());
    const bool known = evaluated_ == place;
    for (const std::uint32_t around : link)
        mesh_.prefetchStar(around);
    if (!known)
        setFan(place);
    for (const std::uint32_t slot : star_.tetrahedra())
        keys_.prefetch(slot);
    touched_.assign(link.begin(), link.end());
    logStar();
    if (movesOnBoundary(vertex)) {
        if (!collapseOnBoundary(place, mostKey))
            return false;
    } else {
        if (!known)
            evaluateFan(fan_, measure_, std::numeric_limits<double>::infinity(), points_);
        mesh_.collapse(vertex, target);
        clearStates();
        giveOutPoints();
    }
    for (const std::uint32_t face : fan_.faces())
        raiseOwn(star_.tetrahedra()[face]);
    live_ -= star_.tetrahedra().size() - fan_.faces().size();
    log_.add(vertex, key(), logged_, static_cast<std::uint32_t>(fan_.faces().size()));
    return true;
}

/// What there is to say of the tetrahedra that go.
void DecimatedMesh::logStar()
{
    logged_.clear();
    for (std::size_t i = 0; i < star_.tetrahedra().size(); ++i) {
        const std::uint32_t slot = star_.tetrahedra()[i];
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
    for (const std::uint32_t slot : star_.tetrahedra()) {
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
    shares_.assign(star_.tetrahedra().size(), {});
    const std::span owners = std::span(points_.owner).first(points_.count());
    for (const std::uint32_t owner : owners)
        ++shares_[owner].count;
    for (const std::uint32_t face : fan_.faces())
        mesh_.state(star_.tetrahedra()[face]).inside = pool_.allocate(shares_[face].count);
    for (const std::uint32_t face : fan_.faces())
        shares_[face].next = pool_[mesh_.state(star_.tetrahedra()[face]).inside].data();
    for (std::size_t i = 0; i < owners.size(); ++i) {
        Share& share = shares_[owners[i]];
        *share.next++ = points_.points[i];
        share.error = std::max(share.error, points_.error[i]);
        if (!points_.warping.empty())
            share.warping = std::max(share.warping, points_.warping[i]);
    }
    for (const std::uint32_t face : fan_.faces()) {
        const std::uint32_t slot = star_.tetrahedra()[face];
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

void DecimatedMesh::archive(StateArchive& archive)
{
    archive(mesh_, warpings_, pool_, keys_, log_, boundaryPoints_, evaluations_, live_);
    if (boundary_)
        archive(*boundary_);
    if (toOriginal_)
        archive(*toOriginal_);
    if (archive.isLoading())
        star_.forget();
}

/// Whether a tetrahedron that the collapse makes is inverted in physical space.
bool DecimatedMesh::inverts(std::uint32_t linkPlace) const
{
    if (input_.physical.empty())
        return false;
    const auto at = [&](std::uint32_t place) {
        const Eigen::Vector3d& physical = input_.physical[star_.link()[place]];
        return std::array<double, 3>{physical.x(), physical.y(), physical.z()};
    };
    const int hand = input_.leftHanded ? -1 : 1;
    for (std::size_t face = 0; face < star_.faces().size(); ++face) {
        const auto& [a, b, c] = star_.faces()[face];
        if (!star_.holds(face, linkPlace) && hand * orientationSign(at(linkPlace), at(a), at(b), at(c)) < 0)
            return true;
    }
    return false;
}

/// Whether what is quickly looked at allows a collapse.
bool DecimatedMesh::opens(std::uint32_t linkPlace) const
{
    if (!star_.opensOnto(linkPlace))
        return false;
    const std::uint32_t target = star_.link()[linkPlace];
    return movesOnBoundary(star_.vertex()) ? linkCondition_.isOnRim(target) : mayMove(star_.vertex(), target);
}

double DecimatedMesh::evaluate(std::uint32_t linkPlace, double bound)
{
    setFan(linkPlace);
    ++evaluations_;
    if (!movesOnBoundary(star_.vertex())) {
        const double key = evaluateFan(fan_, measure_, bound, points_);
        evaluated_ = key <= bound ? linkPlace : none;
        return key;
    }
    if (!judging_)
        boundaryCost_.set(mesh_, star_, points_.points, boundaryPoints_);
    judging_ = true;
    return boundaryCost_.evaluate(star_, linkPlace, fan_, bound);
}

/// The error that the vertex itself gets is a bound from below on the key of a collapse. On an irregular boundary it
/// may lie outside of what becomes of the star, so there is none.
void DecimatedMesh::boundCandidates()
{
    const std::uint32_t vertex = star_.vertex();
    if (movesOnBoundary(vertex) || candidates_.size() < 2) {
        leastKeys_.assign(candidates_.size(), 0);
        return;
    }
    gatherSamples();
    around_.setStar(star_, placedValues_[vertex].value, samples_);
    vertexErrors(star_, around_, measure_, samples_, candidates_, leastKeys_);
    constexpr double beyondRounding = 1 - 1e-12;
    const double weight = input_.weights.empty() ? 1 : static_cast<double>(input_.weights[vertex]);
    for (double& key : leastKeys_)
        key *= weight * beyondRounding;
}

/// Which of the candidates is the most promising, if it can be as good as `least`; else how many there are.
std::size_t DecimatedMesh::nextCandidate(double least) const
{
    std::size_t next = leastKeys_.size();
    for (std::size_t i = 0; i < leastKeys_.size(); ++i)
        if (leastKeys_[i] <= least) {
            least = leastKeys_[i];
            next = i;
        }
    return next;
}

/// What takes longer to look at and seldom forbids a collapse.
bool DecimatedMesh::confirms(std::uint32_t linkPlace, Legality legality)
{
    if (movesOnBoundary(star_.vertex()))
        return legality == Legality::OfStar || boundaryAllows(linkPlace);
    return !inverts(linkPlace);
}

/// Of targets of equal keys that comes first which leaves the fewest tetrahedra, then the nearest.
bool DecimatedMesh::precedes(std::uint32_t linkPlace, std::uint32_t other) const
{
    const auto rank = [this](std::uint32_t place) {
        const auto& [x, y, z] = star_.place(place);
        return std::tuple(-static_cast<std::int64_t>(star_.faceCountOf(place)), x * x + y * y + z * z,
                          star_.link()[place]);
    };
    return rank(linkPlace) < rank(other);
}

DecimatedMesh::Candidate DecimatedMesh::bestOfCandidates(Legality legality)
{
    const auto link = star_.link();
    while (!candidates_.empty()) {
        boundCandidates();
        double least = std::numeric_limits<double>::infinity();
        std::uint32_t best = none;
        for (std::size_t i = nextCandidate(least); i < candidates_.size(); i = nextCandidate(least)) {
            const std::uint32_t place = candidates_[i];
            leastKeys_[i] = std::numeric_limits<double>::quiet_NaN();
            const double key = evaluate(place, least);
            if (best != none && (key > least || (key == least && !precedes(place, best))))
                continue;
            least = key;
            best = place;
        }
        if (confirms(best, legality))
            return {link[best], roundedUp(std::max(least, keyOfFacesAround()))};
        std::erase(candidates_, best);
    }
    return {};
}

DecimatedMesh::Candidate DecimatedMesh::best(std::uint32_t vertex, Legality legality)
{
    if (!input_.box && sides_[vertex] == locked)
        return {};
    setStar(vertex);
    candidates_.clear();
    for (std::uint32_t place = 0; place < star_.link().size(); ++place)
        if (opens(place))
            candidates_.push_back(place);
    return bestOfCandidates(legality);
}

DecimatedMesh::Candidate DecimatedMesh::judge(std::uint32_t vertex, std::uint32_t target)
{
    if (!input_.box && sides_[vertex] == locked)
        return {};
    setStar(vertex);
    candidates_.clear();
    const auto place = static_cast<std::uint32_t>(std::ranges::find(star_.link(), target) - star_.link().begin());
    if (place < star_.link().size() && opens(place))
        candidates_.push_back(place);
    return bestOfCandidates(Legality::Whole);
}

/// The key that the faces of the star opposite to its vertex have by the points outside: collapses leave it as it is.
double DecimatedMesh::keyOfFacesAround() const
{
    double largest = 0;
    if (input_.box)
        return largest;
    for (const std::uint32_t slot : star_.tetrahedra()) {
        const std::uint32_t opposite = mesh_.neighbours(slot)[indexOf(mesh_.vertices(slot), star_.vertex())];
        if (!CollapsibleMesh::isTriangle(opposite))
            continue;
        const BoundaryPoints::Relation& relation = boundaryPoints_[opposite];
        largest = std::max(largest, static_cast<double>(keyOf(relation.error, relation.warping)));
    }
    return largest;
}

/// The boundary triangles that go and come with a collapse.
void DecimatedMesh::setBoundaryChange(std::uint32_t linkPlace)
{
    const auto link = star_.link();
    addedTriangles_.clear();
    removedTriangles_.clear();
    for (const VertexStar::RimTriangle& rim : star_.rim()) {
        const std::uint32_t a = link[rim.corners[0]], b = link[rim.corners[1]];
        removedTriangles_.push_back({star_.vertex(), a, b});
        if (rim.corners[0] != linkPlace && rim.corners[1] != linkPlace)
            addedTriangles_.push_back({link[linkPlace], a, b});
    }
}

/// Some boundary triangle must be left that the points outside can be related to.
bool DecimatedMesh::boundaryAllows(std::uint32_t linkPlace)
{
    const auto comesWithTetrahedron = [&](const VertexStar::RimTriangle& rim) {
        return BoundaryCost::comesWithTetrahedron(star_, rim, linkPlace);
    };
    if (std::ranges::none_of(star_.rim(), comesWithTetrahedron))
        return false;
    setBoundaryChange(linkPlace);
    return linkCondition_.allows(mesh_, star_, linkPlace) &&
           !boundary_->meetsItself(addedTriangles_, removedTriangles_) && !(maySwallow_ && swallows(linkPlace));
}

/// Whether a part of the mesh, such as one in a notch of another, would lie inside of the tetrahedra that a collapse
/// makes, without its boundary meeting theirs.
bool DecimatedMesh::swallows(std::uint32_t linkPlace)
{
    const auto link = star_.link();
    addedTetrahedra_.clear();
    for (std::size_t face = 0; face < star_.faces().size(); ++face)
        if (!star_.holds(face, linkPlace)) {
            const auto& [a, b, c] = star_.faces()[face];
            addedTetrahedra_.push_back({link[linkPlace], link[a], link[b], link[c]});
        }
    boundary_->replace(removedTriangles_, {});
    const bool swallowed = boundary_->liesInside(addedTetrahedra_);
    boundary_->replace({}, removedTriangles_);
    return swallowed;
}

/// Points outside may have come to lie where the new tetrahedra will be since it was judged.
bool DecimatedMesh::collapseOnBoundary(std::uint32_t linkPlace, float mostKey)
{
    boundaryCost_.set(mesh_, star_, points_.points, boundaryPoints_);
    const double key = boundaryCost_.evaluate(star_, linkPlace, fan_, std::numeric_limits<double>::infinity());
    if (key > static_cast<double>(mostKey) || !boundaryAllows(linkPlace))
        return false;
    boundary_->replace(removedTriangles_, addedTriangles_);
    mesh_.collapse(star_.vertex(), star_.link()[linkPlace]);
    clearStates();
    for (const VertexStar::RimTriangle& rim : star_.rim())
        boundaryPoints_.clear(rim.triangle);
    relateToBoundary();
    return true;
}

/// Gives the points to the tetrahedra and boundary triangles that have them, as they were evaluated.
void DecimatedMesh::relateToBoundary()
{
    for (const BoundaryCost::Error& error : boundaryCost_.errors()) {
        if (error.keptBy != none)
            boundaryPoints_.takeOutside(error.keptBy, error.point);
        if (error.inFan != none) {
            TetrahedronState& state = mesh_.state(star_.tetrahedra()[error.inFan]);
            state.inside = pool_.appended(state.inside, {&error.point, 1});
            state.error = std::max(state.error, roundedUp(error.error));
        } else {
            boundaryPoints_.addOutside(error.triangle, error.point, roundedUp(error.error), roundedUp(error.warping));
        }
    }
    for (const BoundaryCost::Warping& warping : boundaryCost_.warpings())
        boundaryPoints_.addOfBoundary(warping.triangle, warping.point, roundedUp(warping.warping));
    for (const BoundaryCost::Distance& one : boundaryCost_.distances())
        boundaryPoints_.setDistance(one.triangle, one.distance, roundedUp(one.distance));
}

} // namespace tetra
