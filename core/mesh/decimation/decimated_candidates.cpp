// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/decimated_mesh.h"

#include "core/mesh/exact_orientation.h"
#include "core/mesh/rounding.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace tetra {

/// Whether a tetrahedron that the collapse makes is inverted in physical space.
bool DecimatedMesh::inverts(std::uint32_t linkPlace) const
{
    if (input_.lifted.empty())
        return false;
    const auto at = [&](std::uint32_t place) {
        const Eigen::Vector3d& lifted = input_.lifted[star_.link()[place]];
        return std::array<double, 3>{lifted.x(), lifted.y(), lifted.z()};
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
        boundaryJudge_.set(mesh_, star_, points_.points, boundaryPoints_);
    judging_ = true;
    return boundaryJudge_.evaluate(star_, linkPlace, fan_, bound);
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

} // namespace tetra
