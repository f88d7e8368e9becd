// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"

#include "core/base/sort_unique.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/orientation.h"
#include "core/geometry/tetrahedron_overlap.h"
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

/// Tetrahedra that have part in every overlap there is in a mesh, or none.
std::vector<std::uint32_t> suspects(Positions positions, TetrahedronSpan tetrahedra, const MeshFaces& faces,
                                    const Progress& progress)
{
    std::vector<std::uint32_t> result = faces.crowded;
    result.insert(result.end(), faces.folded.begin(), faces.folded.end());
    std::vector<Triangle> boundary;
    for (const std::uint32_t side : faces.boundary)
        boundary.push_back(sideCorners(tetrahedra, side));
    const std::vector<bool> touched = findTouched(positions, boundary, progress);
    if (std::ranges::find(touched, true) != touched.end()) {
        std::vector<bool> there(positions.size());
        for (std::size_t t = 0; t < boundary.size(); ++t)
            if (touched[t])
                for (const std::uint32_t corner : boundary[t])
                    there[corner] = true;
        for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
            if (std::ranges::any_of(tetrahedra[t], [&](std::uint32_t corner) { return there[corner]; }))
                result.push_back(t);
    }
    // With other faces the boundary alone says nothing; those that have them are among the suspects.
    if (faces.crowded.empty() && faces.folded.empty()) {
        const std::vector<std::uint32_t> buried = findBuried(positions, boundary, touched, progress);
        if (!buried.empty()) {
            const std::vector<std::uint32_t> pieces = surfacePieces(boundary, touched);
            std::vector<bool> isBuried(boundary.size());
            for (const std::uint32_t triangle : buried)
                isBuried[pieces[triangle]] = true;
            for (std::size_t t = 0; t < boundary.size(); ++t)
                if (isBuried[pieces[t]])
                    result.push_back(FaceAdjacency::cellOf(faces.boundary[t]));
        }
    }
    sortUnique(result);
    return result;
}

} // namespace

MeshOverlaps findOverlaps(Positions positions, TetrahedronSpan tetrahedra, const MeshFaces& faces,
                          const std::function<bool(std::uint32_t, std::uint32_t)>& enough, const Progress& progress)
{
    MeshOverlaps found;
    progress.report(0, checkingMesh);
    const std::vector<std::uint32_t> suspected = suspects(positions, tetrahedra, faces, progress);
    if (suspected.empty())
        return found;
    const auto boxOf = [&](std::uint32_t t) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t corner : tetrahedra[t])
            box.extend(positions[corner]);
        return box;
    };
    const BoxTree tree(tetrahedra.size(), boxOf, [&](std::uint32_t t, Eigen::Index axis) {
        const auto& [a, b, c, d] = tetrahedra[t];
        return positions[a][axis] + positions[b][axis] + positions[c][axis] + positions[d][axis];
    });
    for (const std::uint32_t one : suspected) {
        if (progress.cancelled() || !found.complete)
            break;
        const Eigen::AlignedBox3d box = boxOf(one);
        const auto near = [&](const Eigen::AlignedBox3d& other) { return box.intersects(other); };
        tree.visitNear(near, [&](std::uint32_t other) {
            if (!found.complete || progress.cancelled() || other == one || !near(boxOf(other)) ||
                (other < one && std::ranges::binary_search(suspected, other)) ||
                !tetrahedraOverlap(positions, tetrahedra[one], tetrahedra[other]))
                return;
            found.pairs.push_back({std::min(one, other), std::max(one, other)});
            found.complete = !enough(one, other);
        });
    }
    std::ranges::sort(found.pairs);
    return found;
}

namespace {

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

Status checkPoints(const Dataset& dataset)
{
    const auto bad = [](Message text) { return Error{ErrorKind::BadInput, std::move(text)}; };
    if (!dataset.positions || !dataset.tetrahedra || dataset.tetrahedra->empty())
        return bad(Message::say("The dataset is not an irregular mesh: it has no positions or no tetrahedra."));
    const auto& positions = *dataset.positions;
    if (positions.size() != dataset.values.count() || dataset.values.notFiniteCount() > 0 ||
        !std::ranges::all_of(positions, isUsablePlace))
        return bad(Message::say("The mesh does not have a finite value for each point, and a finite position that is "
                                "not too large to compute with."));
    std::vector<bool> used(positions.size());
    for (const auto& tetrahedron : *dataset.tetrahedra)
        for (const std::uint32_t point : tetrahedron) {
            if (point >= positions.size())
                return bad(
                    Message::say("A tetrahedron of the mesh refers to point %1 of %2.", point, positions.size()));
            used[point] = true;
        }
    if (const auto unused = std::ranges::count(used, false); unused > 0)
        return bad(Message::say("The mesh has %1 points that no tetrahedron uses.", unused));
    return {};
}

} // namespace

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
    const Positions positions = *dataset.positions;
    const MeshFaces faces = findMeshFaces(tetrahedra);
    if (const Status matching = checkFaces(positions, tetrahedra, faces); !matching)
        return matching;
    constexpr std::uint64_t most = 1000;
    std::uint64_t count = 0;
    const MeshOverlaps overlaps = findOverlaps(
        positions, tetrahedra, faces, [&](std::uint32_t, std::uint32_t) { return ++count > most; }, progress);
    if (progress.cancelled())
        return cancelledError(checkingMesh);
    if (overlaps.pairs.empty())
        return {};
    const std::string place = placeText(centreOf(positions, tetrahedra[overlaps.pairs[0][0]]));
    if (count > most)
        return fault(Message::say("more than %1 pairs of tetrahedra that overlap, one at %2", most, place));
    return fault(count == 1 ? Message::say("1 pair of tetrahedra that overlap, one at %1", place)
                            : Message::say("%1 pairs of tetrahedra that overlap, one at %2", count, place));
}

} // namespace tetra
