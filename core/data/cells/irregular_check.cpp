// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"

#include "core/geometry/box_tree.h"
#include "core/geometry/orientation.h"
#include "core/geometry/triangles.h"
#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace tetra {

namespace {

/// Where a closed surface, the boundary of positive tetrahedra that match, shows that they overlap.
struct BoundaryFaults {
    std::uint64_t meetings = 0;             ///< pairs of triangles that meet where they share nothing; ...
    std::array<std::uint32_t, 2> meeting{}; ///< ... one of them
    std::uint64_t buried = 0;               ///< components whose outer side is inside of other tetrahedra; ...
    std::uint32_t buriedTriangle = 0;       ///< ... a triangle of one
    bool none() const { return meetings == 0 && buried == 0; }
};

constexpr std::uint64_t enoughMeetings = 100000;

class BoundaryChecking {
public:
    BoundaryChecking(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles)
        : positions_(positions), triangles_(triangles), boxes_(boxesOf(positions, triangles)),
          tree_(
              boxes_.size(), [this](std::uint32_t t) -> const Eigen::AlignedBox3d& { return boxes_[t]; },
              [this](std::uint32_t t, Eigen::Index axis) { return boxes_[t].center()[axis]; })
    {
        for (const Eigen::AlignedBox3d& box : boxes_)
            all_.extend(box);
    }

    BoundaryFaults run(const Progress& progress)
    {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (progress.cancelled() || faults_.meetings > enoughMeetings)
                return faults_;
            findMeetings(t);
        }
        if (faults_.meetings == 0)
            findBuried(progress);
        return faults_;
    }

private:
    static std::vector<Eigen::AlignedBox3d> boxesOf(std::span<const Eigen::Vector3d> positions,
                                                    std::span<const Triangle> triangles)
    {
        std::vector<Eigen::AlignedBox3d> boxes(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t vertex : triangles[t])
                boxes[t].extend(positions[vertex]);
        return boxes;
    }

    void findMeetings(std::uint32_t t)
    {
        const auto near = [&](const Eigen::AlignedBox3d& box) { return box.intersects(boxes_[t]); };
        tree_.visitNear(near, [&](std::uint32_t other) {
            if (other <= t || !near(boxes_[other]) ||
                !surfaceTrianglesMeet(positions_, triangles_[t], triangles_[other]))
                return;
            if (faults_.meetings++ == 0)
                faults_.meeting = {t, other};
        });
    }

    void findBuried(const Progress& progress)
    {
        const std::vector<std::uint32_t> components = surfaceComponents(triangles_);
        std::vector<std::uint32_t> firsts; // a triangle of each
        std::vector<double> volumes;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (components[t] == firsts.size()) {
                firsts.push_back(t);
                volumes.push_back(0);
            }
            const Eigen::Vector3d& origin = positions_[triangles_[firsts[components[t]]][0]];
            const auto& [a, b, c] = triangles_[t];
            volumes[components[t]] +=
                (positions_[a] - origin).dot((positions_[b] - origin).cross(positions_[c] - origin));
        }
        for (std::uint32_t component = 0; component < firsts.size() && !progress.cancelled(); ++component) {
            // The outside of a cavity's surface is what it encloses, where its own winding number is -1.
            const int own = volumes[component] < 0 ? -1 : 0;
            if (firsts.size() == 1 && own == 0)
                return;
            if (own + windingOfOthers(component, positions_[triangles_[firsts[component]][0]], components) == 0)
                continue;
            if (faults_.buried++ == 0)
                faults_.buriedTriangle = firsts[component];
        }
    }

    /// How often the other components wind around a point that is not on them.
    int windingOfOthers(std::uint32_t component, const Eigen::Vector3d& from,
                        const std::vector<std::uint32_t>& components)
    {
        for (;;) {
            Eigen::Vector3d direction;
            for (double& coordinate : direction)
                coordinate = std::uniform_real_distribution(0.3, 1.0)(random_);
            const Eigen::Vector3d to = from + (3 * all_.diagonal().norm() + 1) * direction;
            if (const auto winding = windingAlong(component, from, to, components))
                return *winding;
        }
    }

    std::optional<int> windingAlong(std::uint32_t component, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                    const std::vector<std::uint32_t>& components) const
    {
        const Eigen::Vector3d way = to - from;
        const auto near = [&](const Eigen::AlignedBox3d& box) {
            // All its directions rise: where it enters the box is before it leaves. With room for rounding.
            constexpr double tolerance = 1e-9;
            const Eigen::Array3d enters = (box.min() - from).array() / way.array();
            const Eigen::Array3d leaves = (box.max() - from).array() / way.array();
            return enters.maxCoeff() - tolerance <= leaves.minCoeff() + tolerance && leaves.minCoeff() >= -tolerance;
        };
        int winding = 0;
        bool unclear = false;
        tree_.visitNear(near, [&](std::uint32_t t) {
            if (unclear || components[t] == component || !near(boxes_[t]))
                return;
            const auto& [a, b, c] = triangles_[t];
            const Crossing crossing = crossingOf(from, to, positions_[a], positions_[b], positions_[c]);
            unclear = crossing == Crossing::Unclear;
            winding += crossing == Crossing::Leaving ? 1 : crossing == Crossing::Entering ? -1 : 0;
        });
        return unclear ? std::nullopt : std::optional(winding);
    }

    std::span<const Eigen::Vector3d> positions_;
    std::span<const Triangle> triangles_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    BoxTree tree_;
    Eigen::AlignedBox3d all_;
    std::mt19937 random_{1};
    BoundaryFaults faults_;
};

/// Together with matching faces and a manifold boundary, finding no fault proves that the tetrahedra cover what
/// they cover once: how many of them lie over a point is the boundary's winding number there, which only changes at the
/// boundary, by one, and is zero just outside each of its components. Exact, but for which side of a closed surface is
/// the inner one, which its volume in doubles tells. Ends counting early when cancelled; expected O(n log n) for a
/// surface that does not meet itself much. `triangles` are a manifold, seen from outside counterclockwise.
BoundaryFaults findBoundaryFaults(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles,
                                  const Progress& progress)
{
    return BoundaryChecking(positions, triangles).run(progress);
}

using Positions = std::span<const Eigen::Vector3d>;
using TetrahedronSpan = std::span<const std::array<std::uint32_t, 4>>;

constexpr MarkedText checkingMesh = Message::marked("Checking the mesh");

std::string placeText(const Eigen::Vector3d& place)
{
    return "(" + formatNumber(place[0]) + ", " + formatNumber(place[1]) + ", " + formatNumber(place[2]) + ")";
}

Error fault(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("The mesh has %1. Repair the mesh in the program that made it.", what)};
}

Eigen::Vector3d centreOf(Positions positions, const std::array<std::uint32_t, 4>& tetrahedron)
{
    return (positions[tetrahedron[0]] + positions[tetrahedron[1]] + positions[tetrahedron[2]] +
            positions[tetrahedron[3]]) /
           4;
}

Status checkSigns(Positions positions, TetrahedronSpan tetrahedra)
{
    std::uint64_t count = 0;
    std::size_t first = 0;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        if (orientation(positions, tetrahedra[t]) <= 0 && count++ == 0)
            first = t;
    if (count == 0)
        return {};
    const std::string place = placeText(centreOf(positions, tetrahedra[first]));
    return fault(count == 1 ? Message::say("1 tetrahedron that is flat or inverted, one at %1", place)
                            : Message::say("%1 tetrahedra that are flat or inverted, one at %2", count, place));
}

Status checkFaces(Positions positions, TetrahedronSpan tetrahedra, const MeshFaces& faces)
{
    if (!faces.crowded.empty()) {
        const std::uint64_t count = faces.crowded.size();
        const std::string place = placeText(centreOf(positions, tetrahedra[faces.crowded[0]]));
        return fault(count == 1
                         ? Message::say("1 tetrahedron at a face that three or more share, one at %1", place)
                         : Message::say("%1 tetrahedra at faces that three or more share, one at %2", count, place));
    }
    if (!faces.folded.empty()) {
        const std::uint64_t count = faces.folded.size();
        const std::string place = placeText(centreOf(positions, tetrahedra[faces.folded[0]]));
        return fault(count == 1
                         ? Message::say("1 tetrahedron that overlaps its neighbour, one at %1", place)
                         : Message::say("%1 tetrahedra that overlap a neighbour on the same side of a face, one at %2",
                                        count, place));
    }
    return {};
}

Status checkManifold(Positions positions, const ManifoldBreaches& breaches)
{
    if (!breaches.edges.empty()) {
        const std::uint64_t count = breaches.edges.size();
        const std::string place = placeText(positions[breaches.edges[0][0]]);
        return fault(count == 1 ? Message::say("1 edge in which parts of it only touch, one at %1", place)
                                : Message::say("%1 edges in which parts of it only touch, one at %2", count, place));
    }
    if (!breaches.vertices.empty()) {
        const std::uint64_t count = breaches.vertices.size();
        const std::string place = placeText(positions[breaches.vertices[0]]);
        return fault(count == 1 ? Message::say("1 point in which parts of it only touch, one at %1", place)
                                : Message::say("%1 points in which parts of it only touch, one at %2", count, place));
    }
    return {};
}

Status checkPoints(const Dataset& dataset)
{
    const auto bad = [](Message text) { return Error{ErrorKind::BadInput, std::move(text)}; };
    if (!dataset.positions || !dataset.tetrahedra || dataset.tetrahedra->empty())
        return bad(Message::say("The dataset is no irregular mesh: it has no positions or no tetrahedra."));
    const auto& positions = *dataset.positions;
    if (positions.size() != dataset.values.count() || dataset.values.notFiniteCount() > 0 ||
        !std::ranges::all_of(positions, [](const auto& position) { return position.allFinite(); }))
        return bad(Message::say("The mesh does not have a finite position and a finite value for each point."));
    std::vector<bool> used(positions.size());
    for (const auto& tetrahedron : *dataset.tetrahedra)
        for (const std::uint32_t point : tetrahedron) {
            if (point >= positions.size())
                return bad(Message::say("A tetrahedron of the mesh names point %1 of %2.", point, positions.size()));
            used[point] = true;
        }
    if (const auto unused = std::ranges::count(used, false); unused > 0)
        return bad(Message::say("The mesh has %1 points that no tetrahedron uses.", unused));
    return {};
}

} // namespace

Status checkTetrahedra(Positions positions, TetrahedronSpan tetrahedra, const MeshFaces& faces,
                       const Progress& progress)
{
    if (const Status matching = checkFaces(positions, tetrahedra, faces); !matching)
        return matching;
    std::vector<std::array<std::uint32_t, 3>> boundary;
    for (const std::uint32_t side : faces.boundary)
        boundary.push_back(sideCorners(tetrahedra, side));
    if (const Status manifold = checkManifold(positions, findBreaches(boundary)); !manifold)
        return manifold;
    progress.report(0.6, checkingMesh);
    const BoundaryFaults faults = findBoundaryFaults(positions, boundary, progress);
    if (progress.cancelled())
        return cancelledError(checkingMesh);
    if (faults.meetings > 0) {
        const std::uint64_t count = faults.meetings;
        const std::string place = placeText(positions[boundary[faults.meeting[0]][0]]);
        return fault(count == 1 ? Message::say("1 pair of boundary faces that cut or touch each other: cells overlap "
                                               "or do not fit together there, one at %1",
                                               place)
                                : Message::say("%1 pairs of boundary faces that cut or touch each other: cells overlap "
                                               "or do not fit together there, one at %2",
                                               count, place));
    }
    if (faults.buried > 0) {
        const std::uint64_t count = faults.buried;
        const std::string place = placeText(positions[boundary[faults.buriedTriangle][0]]);
        return fault(count == 1 ? Message::say("1 part inside another part, one at %1", place)
                                : Message::say("%1 parts inside other parts, one at %2", count, place));
    }
    return {};
}

Status checkIrregular(const Dataset& dataset, const Progress& progress)
{
    if (const Status points = checkPoints(dataset); !points)
        return points;
    const TetrahedronSpan tetrahedra = *dataset.tetrahedra;
    if (tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource, Message::say("The mesh has more than %1 tetrahedra. Take a part of it.",
                                                            largestAdjacentCellCount)};
    if (const Status positive = checkSigns(*dataset.positions, tetrahedra); !positive)
        return positive;
    return checkTetrahedra(*dataset.positions, tetrahedra, findMeshFaces(tetrahedra), progress);
}

} // namespace tetra
