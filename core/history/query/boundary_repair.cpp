// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/boundary_repair.h"

#include "core/base/sort_unique.h"
#include "core/history/walk.h"
#include "core/mesh/boundary.h"
#include "core/mesh/boundary_faults.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr MarkedText testing = Message::marked("Testing the boundary");

/// When a site enters: later ones of the same batch at the same time, for it has no mesh between them.
using EntryTime = float;
constexpr EntryTime beforeAll = -std::numeric_limits<EntryTime>::infinity();
constexpr EntryTime afterAll = std::numeric_limits<EntryTime>::infinity();

EntryTime timeOf(const Model& model, std::uint32_t site)
{
    if (site >= model.siteCount())
        return afterAll;
    model.check(model.runningKeys()[site]); // whoever asked learns of damage in the end
    return -model.runningKeys()[site];
}

/// The boundary of a closed set's mesh, each triangle with the life of its tetrahedron.
struct LivingBoundary {
    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;
    std::vector<EntryTime> births;
    std::vector<EntryTime> deaths;
    std::vector<std::uint32_t> destroyers;
};

/// Model::never also if the file does not name the tetrahedron any more.
std::uint32_t destroyerOf(const Model& model, const Tetrahedron& sites)
{
    for (const std::uint64_t t : starOf(model, sites[0]))
        if (model.otherSites()[t] == std::array{sites[1], sites[2], sites[3]})
            return model.destroyers()[t];
    return Model::never;
}

LivingBoundary boundaryOf(const Model& model, const ExtractedMesh& mesh)
{
    const std::span<const Tetrahedron> tetrahedra = mesh.mesh.tetrahedra;
    const FaceAdjacency adjacency = matchFaces(tetrahedra);
    LivingBoundary boundary;
    constexpr std::uint8_t allInner = 15;
    for (std::uint32_t cell = 0; cell < tetrahedra.size(); ++cell) {
        if (adjacency.innerFaces[cell] == allInner)
            continue;
        Tetrahedron sites = tetrahedra[cell];
        std::ranges::transform(sites, sites.begin(), [&](std::uint32_t vertex) { return mesh.sites[vertex]; });
        const std::uint32_t destroyer = destroyerOf(model, sites);
        for (std::uint32_t face = 0; face < 4; ++face) {
            if ((adjacency.innerFaces[cell] >> face & 1) != 0)
                continue;
            boundary.triangles.push_back(sideCorners(tetrahedra, 4 * cell + face));
            boundary.births.push_back(timeOf(model, sites[0]));
            boundary.deaths.push_back(timeOf(model, destroyer));
            boundary.destroyers.push_back(destroyer);
        }
    }
    for (const std::uint32_t vertex : renumberUsed(boundary.triangles, mesh.sites.size()))
        boundary.positions.push_back(model.position(mesh.sites[vertex]));
    return boundary;
}

/// Where triangles lie near each other of which one was destroyed before the other was made: a grid of places, each
/// with the first death and the last birth of the triangles whose boxes reach into it. Most are far from any such
/// place.
class LifeGrid {
public:
    LifeGrid(const LivingBoundary& boundary, std::span<const Eigen::AlignedBox3d> boxes)
    {
        Eigen::Vector3d sizes = Eigen::Vector3d::Zero();
        for (const Eigen::AlignedBox3d& box : boxes) {
            all_.extend(box);
            sizes += box.sizes();
        }
        constexpr double mostPlaces = 48; // along an axis
        for (int axis = 0; axis < 3; ++axis) {
            const double size = sizes[axis] / static_cast<double>(boxes.size());
            const double places = size > 0 ? 2 * all_.sizes()[axis] / size : 1;
            counts_[axis] = static_cast<int>(std::clamp(places, 1.0, mostPlaces));
        }
        const auto places = static_cast<std::size_t>(counts_.prod());
        firstDeath_.assign(places, afterAll);
        lastBirth_.assign(places, beforeAll);
        for (std::size_t t = 0; t < boxes.size(); ++t)
            visit(boxes[t], [&](std::size_t place) {
                firstDeath_[place] = std::min(firstDeath_[place], boundary.deaths[t]);
                lastBirth_[place] = std::max(lastBirth_[place], boundary.births[t]);
            });
    }

    /// Whether something near died at that time or before.
    bool hasDeath(const Eigen::AlignedBox3d& box, EntryTime time) const
    {
        EntryTime first = afterAll;
        visit(box, [&](std::size_t place) { first = std::min(first, firstDeath_[place]); });
        return first <= time;
    }
    /// Whether something near was born at that time or after.
    bool hasBirth(const Eigen::AlignedBox3d& box, EntryTime time) const
    {
        EntryTime last = beforeAll;
        visit(box, [&](std::size_t place) { last = std::max(last, lastBirth_[place]); });
        return last >= time;
    }

private:
    template <class Visit> void visit(const Eigen::AlignedBox3d& box, const Visit& call) const
    {
        const Eigen::Array3i from = placeOf(box.min()), to = placeOf(box.max());
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int x = from[0]; x <= to[0]; ++x)
                    call(static_cast<std::size_t>((z * counts_[1] + y) * counts_[0] + x));
    }
    Eigen::Array3i placeOf(const Eigen::Vector3d& position) const
    {
        Eigen::Array3i place;
        for (int axis = 0; axis < 3; ++axis) {
            const double size = all_.sizes()[axis];
            const double share = size > 0 ? (position[axis] - all_.min()[axis]) / size : 0;
            place[axis] = std::min(static_cast<int>(share * counts_[axis]), counts_[axis] - 1);
        }
        return place;
    }

    Eigen::AlignedBox3d all_;
    Eigen::Array3i counts_;
    std::vector<EntryTime> firstDeath_;
    std::vector<EntryTime> lastBirth_;
};

/// Collects what destroys the tetrahedra at fault. No part can lie inside of tetrahedra of another without meeting its
/// boundary: each piece of the boundary has a vertex among the initial sites, since collapses keep the pieces, and
/// every tetrahedron belongs to some prefix, which has this vertex, too, and nothing over it.
class BoundaryTest {
public:
    BoundaryTest(const LivingBoundary& boundary, std::uint32_t known) : boundary_(boundary), known_(known) {}

    BoundaryRepair run(const Progress& progress)
    {
        if (boundary_.triangles.empty())
            return std::move(repair_);
        findBreachesOfManifold();
        if (repair_.isSound)
            findMeetings(progress);
        sortUnique(repair_.sites);
        return std::move(repair_);
    }

private:
    void destroy(std::uint32_t triangle)
    {
        repair_.isSound = false;
        if (boundary_.destroyers[triangle] < known_)
            repair_.sites.push_back(boundary_.destroyers[triangle]);
    }

    /// At vertices of whose triangles one died before another one was born. Where parts of the data touch each other,
    /// prefixes have breaches, too: those are let be.
    void findBreachesOfManifold()
    {
        struct Lives {
            EntryTime lastBirth = beforeAll;
            EntryTime firstDeath = afterAll;
            bool differ() const { return firstDeath <= lastBirth; }
        };
        std::vector<Lives> around(boundary_.positions.size());
        for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
            for (const std::uint32_t vertex : boundary_.triangles[t]) {
                around[vertex].lastBirth = std::max(around[vertex].lastBirth, boundary_.births[t]);
                around[vertex].firstDeath = std::min(around[vertex].firstDeath, boundary_.deaths[t]);
            }
        const auto differ = [&](std::uint32_t vertex) { return around[vertex].differ(); };
        std::vector<Triangle> some;
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
            if (std::ranges::any_of(boundary_.triangles[t], differ)) {
                some.push_back(boundary_.triangles[t]);
                numbers.push_back(t);
            }
        const ManifoldBreaches breaches = findBreaches(some); // with the border of these triangles
        std::vector<bool> breached(boundary_.positions.size());
        for (const auto& [from, to] : breaches.edges)
            if (differ(from) || differ(to))
                breached[from] = breached[to] = true;
        for (const std::uint32_t vertex : breaches.vertices)
            breached[vertex] = differ(vertex);
        for (const std::uint32_t t : numbers)
            for (const std::uint32_t vertex : boundary_.triangles[t])
                if (breached[vertex] && boundary_.deaths[t] <= around[vertex].lastBirth)
                    destroy(t);
    }

    void findMeetings(const Progress& progress)
    {
        std::vector<Eigen::AlignedBox3d> boxes(boundary_.triangles.size());
        std::ranges::transform(boundary_.triangles, boxes.begin(), [this](const Triangle& triangle) {
            return TriangleBoxes::boxOf(boundary_.positions, triangle);
        });
        const LifeGrid grid(boundary_, boxes);
        std::vector<Triangle> old;
        std::vector<std::uint32_t> numbers; // of the old ones
        for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
            if (grid.hasBirth(boxes[t], boundary_.deaths[t])) {
                old.push_back(boundary_.triangles[t]);
                numbers.push_back(t);
            }
        if (old.empty())
            return;
        const TriangleBoxes oldBoxes(boundary_.positions, old);
        tbb::enumerable_thread_specific<std::vector<std::uint32_t>> found;
        tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(boundary_.triangles.size())),
                          [&](const auto& range) {
                              for (std::uint32_t t = range.begin(); t != range.end() && !progress.cancelled(); ++t)
                                  if (grid.hasDeath(boxes[t], boundary_.births[t]))
                                      oldBoxes.visitMeeting(
                                          boundary_.triangles[t],
                                          [&](std::uint32_t other) {
                                              return boundary_.deaths[numbers[other]] <= boundary_.births[t];
                                          },
                                          [&](std::uint32_t other) { found.local().push_back(numbers[other]); });
                          });
        for (const std::vector<std::uint32_t>& some : found)
            for (const std::uint32_t triangle : some)
                destroy(triangle);
    }

    const LivingBoundary& boundary_;
    std::uint32_t known_; ///< sites
    BoundaryRepair repair_;
};

} // namespace

Result<BoundaryRepair> testBoundary(const Model& model, const ExtractedMesh& mesh, std::uint32_t known,
                                    const Progress& progress)
{
    progress.report(0, testing);
    const LivingBoundary boundary = boundaryOf(model, mesh);
    if (progress.cancelled())
        return cancelledError(testing);
    BoundaryRepair repair = BoundaryTest(boundary, known).run(progress);
    if (progress.cancelled())
        return cancelledError(testing);
    return repair;
}

} // namespace tetra
