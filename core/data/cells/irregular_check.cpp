// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"

#include "core/geometry/orientation.h"
#include "core/mesh/boundary.h"
#include "core/mesh/boundary_faults.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <string>
#include <vector>

namespace tetra {

namespace {

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
    if (!faults.meetings.empty()) {
        const std::uint64_t count = faults.meetings.size();
        const std::string place = placeText(positions[boundary[faults.meetings[0][0]][0]]);
        return fault(count == 1 ? Message::say("1 pair of boundary faces that cut or touch each other: cells overlap "
                                               "or do not fit together there, one at %1",
                                               place)
                                : Message::say("%1 pairs of boundary faces that cut or touch each other: cells overlap "
                                               "or do not fit together there, one at %2",
                                               count, place));
    }
    if (!faults.buried.empty()) {
        const std::uint64_t count = faults.buried.size();
        const std::string place = placeText(positions[boundary[faults.buried[0]][0]]);
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
