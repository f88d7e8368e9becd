// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/manifold.h"

#include "core/base/disjoint_sets.h"
#include "core/base/sort_unique.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace tetra {

namespace {

bool hasCorner(const Tetrahedron& corners, std::uint32_t point)
{
    return std::ranges::find(corners, point) != corners.end();
}

/// The tetrahedra around each point, one after the other.
struct PartStars {
    std::vector<std::uint64_t> begin;
    std::vector<std::uint32_t> tetrahedra;

    PartStars(std::span<const Tetrahedron> all, std::uint32_t points, const std::vector<std::uint8_t>& chosen)
        : begin(points + std::size_t(1), 0)
    {
        forEach(all, chosen, [&](std::uint32_t, std::uint32_t point) { ++begin[point + std::size_t(1)]; });
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        tetrahedra.resize(begin.back());
        std::vector<std::uint64_t> next(begin.begin(), begin.end() - 1);
        forEach(all, chosen, [&](std::uint32_t cell, std::uint32_t point) { tetrahedra[next[point]++] = cell; });
    }

    std::span<const std::uint32_t> of(std::uint32_t point) const
    {
        return std::span(tetrahedra).subspan(begin[point], begin[point + std::size_t(1)] - begin[point]);
    }

private:
    template <class Visit>
    static void forEach(std::span<const Tetrahedron> all, const std::vector<std::uint8_t>& chosen, const Visit& visit)
    {
        for (std::uint32_t cell = 0; cell < all.size(); ++cell)
            if (chosen[cell] != 0)
                for (const std::uint32_t point : all[cell])
                    visit(cell, point);
    }
};

/// What lies around a point: its tetrahedra as triangles of the point's link, and their edges.
class Link {
public:
    Link(std::span<const Tetrahedron> all, std::uint32_t centre, std::vector<std::uint32_t> cells)
        : all_(all), centre_(centre), cells_(std::move(cells))
    {
        for (std::uint32_t i = 0; i < cells_.size(); ++i)
            addEdges(i);
        std::ranges::sort(edges_);
    }

    /// The tetrahedra that must go for the boundary to be a manifold here; empty if it is.
    std::vector<std::uint32_t> superfluous() const
    {
        DisjointSets parts = joined([](const Edge&) { return true; });
        if (auto cells = allButTheLargest(parts, cells_); !cells.empty())
            return cells;
        const std::vector<Edge> rim = rimEdges();
        if (const auto pinch = pinchedPoint(rim))
            return aroundEdge(*pinch);
        return isOneLoop(rim) ? std::vector<std::uint32_t>() : cells_;
    }

private:
    struct Edge {
        std::uint32_t a = 0;
        std::uint32_t b = 0; ///< above a
        std::uint32_t triangle = 0;

        auto operator<=>(const Edge&) const = default;
        bool sameAs(const Edge& other) const { return a == other.a && b == other.b; }
    };

    void addEdges(std::uint32_t triangle)
    {
        const Tetrahedron& corners = all_[cells_[triangle]];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                if (corners[i] != centre_ && corners[j] != centre_)
                    edges_.push_back({std::min(corners[i], corners[j]), std::max(corners[i], corners[j]), triangle});
    }

    /// Triangles that share an edge which `counts`.
    template <class Counts> DisjointSets joined(const Counts& counts) const
    {
        DisjointSets groups(cells_.size());
        for (std::size_t i = 1; i < edges_.size(); ++i)
            if (edges_[i].sameAs(edges_[i - 1]) && counts(edges_[i]))
                groups.join(edges_[i].triangle, edges_[i - 1].triangle);
        return groups;
    }

    std::vector<Edge> rimEdges() const
    {
        std::vector<Edge> rim;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool isShared = (i > 0 && edges_[i].sameAs(edges_[i - 1])) ||
                                  (i + 1 < edges_.size() && edges_[i].sameAs(edges_[i + 1]));
            if (!isShared)
                rim.push_back(edges_[i]);
        }
        return rim;
    }

    /// A point of the link at which more than two edges of its rim meet: the edge to it has several fans.
    static std::optional<std::uint32_t> pinchedPoint(const std::vector<Edge>& rim)
    {
        std::vector<std::uint32_t> ends;
        for (const Edge& edge : rim)
            ends.insert(ends.end(), {edge.a, edge.b});
        std::ranges::sort(ends);
        for (std::size_t i = 2; i < ends.size(); ++i)
            if (ends[i] == ends[i - 2])
                return ends[i];
        return {};
    }

    static bool isOneLoop(const std::vector<Edge>& rim)
    {
        std::vector<std::uint32_t> points;
        for (const Edge& edge : rim)
            points.insert(points.end(), {edge.a, edge.b});
        sortUnique(points);
        const auto number = [&](std::uint32_t point) {
            return static_cast<std::uint32_t>(std::ranges::lower_bound(points, point) - points.begin());
        };
        DisjointSets loops(points.size());
        for (const Edge& edge : rim)
            loops.join(number(edge.a), number(edge.b));
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            count += loops.root(i) == i ? 1 : 0;
        return count <= 1;
    }

    std::vector<std::uint32_t> aroundEdge(std::uint32_t other) const
    {
        DisjointSets fans = joined([other](const Edge& edge) { return edge.a == other || edge.b == other; });
        std::vector<std::uint32_t> around;
        for (const std::uint32_t cell : cells_)
            if (hasCorner(all_[cell], other))
                around.push_back(cell);
        return allButTheLargest(fans, around);
    }

    /// Of the cells `among`, those that are not in the group with most of them.
    std::vector<std::uint32_t> allButTheLargest(DisjointSets& groups, const std::vector<std::uint32_t>& among) const
    {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> members; // group and cell
        for (std::uint32_t i = 0; i < cells_.size(); ++i)
            if (std::ranges::find(among, cells_[i]) != among.end())
                members.emplace_back(groups.root(i), cells_[i]);
        std::ranges::sort(members);
        std::uint32_t largest = 0;
        std::ptrdiff_t most = 0;
        for (auto begin = members.begin(); begin != members.end();) {
            const auto end =
                std::find_if(begin, members.end(), [&](const auto& member) { return member.first != begin->first; });
            if (end - begin > most) {
                most = end - begin;
                largest = begin->first;
            }
            begin = end;
        }
        std::vector<std::uint32_t> others;
        for (const auto& [group, cell] : members)
            if (group != largest)
                others.push_back(cell);
        return others;
    }

    std::span<const Tetrahedron> all_;
    std::uint32_t centre_;
    std::vector<std::uint32_t> cells_;
    std::vector<Edge> edges_;
};

/// Elsewhere the mesh is as it was.
std::vector<std::uint32_t> pointsOfOthers(std::span<const Tetrahedron> tetrahedra, std::uint32_t points,
                                          const std::vector<std::uint8_t>& chosen)
{
    std::vector<std::uint8_t> isOne(points);
    for (std::size_t cell = 0; cell < tetrahedra.size(); ++cell)
        if (chosen[cell] == 0)
            for (const std::uint32_t point : tetrahedra[cell])
                isOne[point] = 1;
    std::vector<std::uint32_t> result;
    for (std::uint32_t point = 0; point < points; ++point)
        if (isOne[point] != 0)
            result.push_back(point);
    return result;
}

} // namespace

std::uint64_t restrictToManifold(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t points,
                                 std::vector<std::uint8_t>& chosen)
{
    const PartStars stars(tetrahedra, points, chosen);
    std::vector<std::uint32_t> toLookAt = pointsOfOthers(tetrahedra, points, chosen);
    std::uint64_t removed = 0;
    while (!toLookAt.empty()) {
        const std::uint32_t point = toLookAt.back();
        toLookAt.pop_back();
        std::vector<std::uint32_t> cells;
        for (const std::uint32_t cell : stars.of(point))
            if (chosen[cell] != 0)
                cells.push_back(cell);
        for (const std::uint32_t cell : Link(tetrahedra, point, std::move(cells)).superfluous()) {
            chosen[cell] = 0;
            ++removed;
            toLookAt.insert(toLookAt.end(), tetrahedra[cell].begin(), tetrahedra[cell].end());
        }
    }
    return removed;
}

} // namespace tetra
