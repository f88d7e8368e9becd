// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/irregular_check.h"

#include "core/base/number_text.h"
#include "core/cells/boundary_check.h"
#include "core/cells/boundary_manifold.h"
#include "core/cells/cell_orientation.h"
#include "core/mesh/face_adjacency.h"

#include <algorithm>
#include <string>

namespace tetra {

namespace {

using Positions = std::span<const Eigen::Vector3d>;
using TetrahedronSpan = std::span<const std::array<std::uint32_t, 4>>;

constexpr std::string_view checkingMesh = "Checking the mesh";

std::string placeText(const Eigen::Vector3d& place)
{
    return "(" + formatNumber(place[0]) + ", " + formatNumber(place[1]) + ", " + formatNumber(place[2]) + ")";
}

Error fault(std::uint64_t count, std::string_view one, std::string_view several, const Eigen::Vector3d& place)
{
    return {ErrorKind::BadInput, "The mesh has " + std::to_string(count) + " " +
                                     std::string(count == 1 ? one : several) + ", one at " + placeText(place) +
                                     ". Repair the mesh in the program that made it."};
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
    return fault(count, "tetrahedron that is flat or inverted", "tetrahedra that are flat or inverted",
                 centreOf(positions, tetrahedra[first]));
}

Status checkFaces(Positions positions, TetrahedronSpan tetrahedra, const MeshFaces& faces)
{
    if (!faces.crowded.empty())
        return fault(faces.crowded.size(), "tetrahedron at a face that three or more share",
                     "tetrahedra at faces that three or more share", centreOf(positions, tetrahedra[faces.crowded[0]]));
    if (!faces.folded.empty())
        return fault(faces.folded.size(), "tetrahedron that overlaps its neighbour",
                     "tetrahedra that overlap a neighbour on the same side of a face",
                     centreOf(positions, tetrahedra[faces.folded[0]]));
    return {};
}

Status checkManifold(Positions positions, const ManifoldBreaches& breaches)
{
    if (!breaches.edges.empty())
        return fault(breaches.edges.size(), "edge in which parts of it only touch",
                     "edges in which parts of it only touch", positions[breaches.edges[0][0]]);
    if (!breaches.vertices.empty())
        return fault(breaches.vertices.size(), "point in which parts of it only touch",
                     "points in which parts of it only touch", positions[breaches.vertices[0]]);
    return {};
}

Status checkPoints(const Dataset& dataset)
{
    const auto bad = [](std::string text) { return Error{ErrorKind::BadInput, std::move(text)}; };
    if (!dataset.positions || !dataset.tetrahedra || dataset.tetrahedra->empty())
        return bad("The dataset is no irregular mesh: it has no positions or no tetrahedra.");
    const auto& positions = *dataset.positions;
    if (positions.size() != dataset.values.count() || dataset.values.notFiniteCount() > 0 ||
        !std::ranges::all_of(positions, [](const auto& position) { return position.allFinite(); }))
        return bad("The mesh does not have a finite position and a finite value for each point.");
    std::vector<bool> used(positions.size());
    for (const auto& tetrahedron : *dataset.tetrahedra)
        for (const std::uint32_t point : tetrahedron) {
            if (point >= positions.size())
                return bad("A tetrahedron of the mesh names point " + std::to_string(point) + " of " +
                           std::to_string(positions.size()) + ".");
            used[point] = true;
        }
    if (const auto unused = std::ranges::count(used, false); unused > 0)
        return bad("The mesh has " + std::to_string(unused) + " points that no tetrahedron uses.");
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
    const BoundaryFaults faults = checkBoundary(positions, boundary, progress);
    if (progress.cancelled())
        return cancelledError(checkingMesh);
    if (faults.meetings > 0)
        return fault(faults.meetings,
                     "pair of boundary faces that cut or touch each other: cells overlap or do not fit "
                     "together there",
                     "pairs of boundary faces that cut or touch each other: cells overlap or do not fit together there",
                     positions[boundary[faults.meeting[0]][0]]);
    if (faults.buried > 0)
        return fault(faults.buried, "part inside another part", "parts inside other parts",
                     positions[boundary[faults.buriedTriangle][0]]);
    return {};
}

Status checkIrregular(const Dataset& dataset, const Progress& progress)
{
    if (const Status points = checkPoints(dataset); !points)
        return points;
    const TetrahedronSpan tetrahedra = *dataset.tetrahedra;
    if (tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource, "The mesh has more than " + std::to_string(largestAdjacentCellCount) +
                                                   " tetrahedra. Take a part of it."};
    if (const Status positive = checkSigns(*dataset.positions, tetrahedra); !positive)
        return positive;
    return checkTetrahedra(*dataset.positions, tetrahedra, findMeshFaces(tetrahedra), progress);
}

} // namespace tetra
