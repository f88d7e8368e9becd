// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/pinch_repair.h"

#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace tetra {

namespace {

void keepOnly(CutCells& cut, const std::vector<bool>& removed)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < cut.tetrahedra.size(); ++t)
        if (!removed[t]) {
            cut.tetrahedra[kept] = cut.tetrahedra[t];
            cut.cells[kept++] = cut.cells[t];
        }
    cut.tetrahedra.resize(kept);
    cut.cells.resize(kept);
}

bool hasVertex(const Tetrahedron& tetrahedron, std::uint32_t vertex)
{
    return std::ranges::find(tetrahedron, vertex) != tetrahedron.end();
}

/// Groups of tetrahedra around an edge or a vertex that hang together by faces around it.
class Groups {
public:
    Groups(const CutCells& cut, const MeshFaces& faces, std::span<const std::uint32_t> centre,
           const std::vector<std::uint32_t>& around)
    {
        for (const std::uint32_t t : around)
            if (std::ranges::all_of(centre, [&](std::uint32_t v) { return hasVertex(cut.tetrahedra[t], v); }))
                group_.emplace(t, unset);
        for (auto& [first, group] : group_)
            if (group == unset)
                fill(cut, faces, centre, first);
    }
    std::size_t count() const { return sizes_.size(); }
    /// Calls visit(t) for all but those of the largest group.
    template <class Visit> void forSmaller(Visit&& visit) const
    {
        const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes_) - sizes_.begin());
        for (const auto& [t, group] : group_)
            if (group != largest)
                visit(t);
    }
    template <class Visit> void forAll(Visit&& visit) const
    {
        for (const auto& [t, group] : group_)
            visit(t);
    }

private:
    static constexpr std::uint32_t unset = 0xffffffff;

    void fill(const CutCells& cut, const MeshFaces& faces, std::span<const std::uint32_t> centre, std::uint32_t first)
    {
        const auto number = static_cast<std::uint32_t>(sizes_.size());
        sizes_.push_back(0);
        std::vector<std::uint32_t> open{first};
        group_[first] = number;
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            ++sizes_.back();
            for (std::uint32_t f = 0; f < 4; ++f) {
                const std::uint32_t partner = faces.partners[4 * t + f];
                if (partner == MeshFaces::none || std::ranges::count(centre, cut.tetrahedra[t][f]) != 0)
                    continue;
                const auto next = group_.find(FaceAdjacency::cellOf(partner));
                if (next != group_.end() && next->second == unset) {
                    next->second = number;
                    open.push_back(next->first);
                }
            }
        }
    }

    std::map<std::uint32_t, std::uint32_t> group_;
    std::vector<std::uint32_t> sizes_;
};

/// Which tetrahedra a round takes away; none if the boundary is a manifold.
std::vector<bool> findPinches(const CutCells& cut, const MeshFaces& faces)
{
    std::vector<std::array<std::uint32_t, 3>> boundary;
    for (const std::uint32_t side : faces.boundary)
        boundary.push_back(sideCorners(cut.tetrahedra, side));
    const ManifoldBreaches breaches = findBreaches(boundary);
    if (breaches.none())
        return {};
    std::map<std::uint32_t, std::vector<std::uint32_t>> around;
    for (const auto& [a, b] : breaches.edges)
        around[a];
    for (const std::uint32_t vertex : breaches.vertices)
        around[vertex];
    std::uint32_t largestPoint = 0;
    for (const Tetrahedron& tetrahedron : cut.tetrahedra)
        largestPoint = std::max(largestPoint, std::ranges::max(tetrahedron));
    std::vector<bool> wanted(std::size_t(largestPoint) + 1);
    for (const auto& [vertex, list] : around)
        wanted[vertex] = true;
    for (std::uint32_t t = 0; t < cut.tetrahedra.size(); ++t)
        for (const std::uint32_t vertex : cut.tetrahedra[t])
            if (wanted[vertex])
                around[vertex].push_back(t);

    std::vector<bool> removed(cut.tetrahedra.size());
    const auto remove = [&](std::uint32_t t) { removed[t] = true; };
    for (const auto& edge : breaches.edges)
        Groups(cut, faces, edge, around[edge[0]]).forSmaller(remove);
    for (const std::uint32_t vertex : breaches.vertices) {
        const Groups groups(cut, faces, std::span(&vertex, 1), around[vertex]);
        if (groups.count() > 1)
            groups.forSmaller(remove);
        else
            groups.forAll(remove);
    }
    return removed;
}

} // namespace

std::uint64_t removeDuplicates(CutCells& cut, MeshFaces& faces)
{
    std::map<Tetrahedron, std::uint32_t> seen; // few: only those at crowded faces can be there twice, or alone
    std::vector<bool> removed(cut.tetrahedra.size());
    const auto look = [&](std::uint32_t t) {
        Tetrahedron sorted = cut.tetrahedra[t];
        std::ranges::sort(sorted);
        const auto [first, isNew] = seen.emplace(sorted, t);
        removed[t] = !isNew && first->second != t;
    };
    // Of two alike that nothing else touches, the faces match each other, folded.
    for (const std::uint32_t t : faces.crowded)
        look(t);
    for (const std::uint32_t t : faces.folded)
        look(t);
    const auto count = static_cast<std::uint64_t>(std::ranges::count(removed, true));
    if (count > 0) {
        keepOnly(cut, removed);
        faces = findMeshFaces(cut.tetrahedra);
    }
    return count;
}

std::uint64_t removePinches(CutCells& cut, MeshFaces& faces, std::uint64_t most, const Progress& progress)
{
    std::uint64_t total = 0;
    while (!progress.cancelled()) {
        const std::vector<bool> removed = findPinches(cut, faces);
        const auto count = static_cast<std::uint64_t>(std::ranges::count(removed, true));
        if (count == 0 || total + count > most || count == cut.tetrahedra.size())
            break;
        keepOnly(cut, removed);
        faces = findMeshFaces(cut.tetrahedra);
        total += count;
    }
    return total;
}

} // namespace tetra
