// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/boundary_repair.h"

#include "core/base/sort_unique.h"
#include "core/history/walk.h"
#include "core/mesh/boundary.h"
#include "core/mesh/boundary_faults.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr MarkedText testing = Message::marked("Testing the boundary");

/// The boundary of a closed set's mesh, each triangle with the life of its tetrahedron.
struct LivingBoundary {
    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> creators;
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
            boundary.creators.push_back(sites[0]);
            boundary.destroyers.push_back(destroyer);
        }
    }
    for (const std::uint32_t vertex : renumberUsed(boundary.triangles, mesh.sites.size()))
        boundary.positions.push_back(model.position(mesh.sites[vertex]));
    return boundary;
}

/// Collects what destroys the tetrahedra at fault.
class BoundaryTest {
public:
    BoundaryTest(const LivingBoundary& boundary, std::uint32_t end) : boundary_(boundary), end_(end) {}

    BoundaryRepair run(const Progress& progress)
    {
        findBreachesOfManifold();
        if (repair_.isSound)
            findMeetings(progress);
        if (repair_.isSound && !touches_ && !progress.cancelled())
            findBuriedParts(progress);
        sortUnique(repair_.sites);
        return std::move(repair_);
    }

private:
    void destroy(std::uint32_t triangle)
    {
        repair_.isSound = false;
        if (boundary_.destroyers[triangle] < end_)
            repair_.sites.push_back(boundary_.destroyers[triangle]);
    }

    /// Where parts of the data touch each other, prefixes have breaches, too: those are let be.
    void findBreachesOfManifold()
    {
        const ManifoldBreaches breaches = findBreaches(boundary_.triangles);
        touches_ = !breaches.none();
        if (!touches_)
            return;
        std::vector<bool> breached(boundary_.positions.size());
        for (const auto& edge : breaches.edges)
            breached[edge[0]] = breached[edge[1]] = true;
        for (const std::uint32_t vertex : breaches.vertices)
            breached[vertex] = true;
        std::vector<std::uint32_t> newest(boundary_.positions.size()); // creator around the vertex
        const auto visitBreached = [&](const auto& visit) {
            for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
                for (const std::uint32_t vertex : boundary_.triangles[t])
                    if (breached[vertex])
                        visit(t, newest[vertex]);
        };
        visitBreached(
            [&](std::uint32_t t, std::uint32_t& creator) { creator = std::max(creator, boundary_.creators[t]); });
        visitBreached([&](std::uint32_t t, std::uint32_t creator) {
            if (boundary_.destroyers[t] <= creator)
                destroy(t);
        });
    }

    /// Of the triangles that some other one outlives from its first site on, and of these.
    void findMeetings(const Progress& progress)
    {
        std::uint32_t newest = 0, soonest = std::numeric_limits<std::uint32_t>::max();
        for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t) {
            newest = std::max(newest, boundary_.creators[t]);
            soonest = std::min(soonest, boundary_.destroyers[t]);
        }
        std::vector<Triangle> old;
        std::vector<std::uint32_t> numbers; // of the old ones
        for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
            if (boundary_.destroyers[t] <= newest) {
                old.push_back(boundary_.triangles[t]);
                numbers.push_back(t);
            }
        if (old.empty())
            return;
        const TriangleBoxes boxes(boundary_.positions, old);
        for (std::uint32_t t = 0; t < boundary_.triangles.size() && !progress.cancelled(); ++t)
            if (boundary_.creators[t] >= soonest)
                boxes.visitMeeting(
                    boundary_.triangles[t],
                    [&](std::uint32_t other) { return boundary_.destroyers[numbers[other]] <= boundary_.creators[t]; },
                    [&](std::uint32_t other) { destroy(numbers[other]); });
    }

    /// Where something lies inside of other tetrahedra, all that reaches near it is refined.
    void findBuriedParts(const Progress& progress)
    {
        const std::vector<std::uint32_t> buried = findBuried(boundary_.positions, boundary_.triangles, {}, progress);
        if (buried.empty())
            return;
        repair_.isSound = false;
        const std::vector<std::uint32_t> components = surfacePieces(boundary_.triangles);
        for (const std::uint32_t part : buried) {
            Eigen::AlignedBox3d box;
            for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
                if (components[t] == components[part])
                    box.extend(TriangleBoxes::boxOf(boundary_.positions, boundary_.triangles[t]));
            for (std::uint32_t t = 0; t < boundary_.triangles.size(); ++t)
                if (TriangleBoxes::boxOf(boundary_.positions, boundary_.triangles[t]).intersects(box))
                    destroy(t);
        }
    }

    const LivingBoundary& boundary_;
    std::uint32_t end_;
    bool touches_ = false; ///< itself in vertices or edges
    BoundaryRepair repair_;
};

} // namespace

Result<BoundaryRepair> testBoundary(const Model& model, const ExtractedMesh& mesh, std::uint32_t end,
                                    const Progress& progress)
{
    progress.report(0, testing);
    const LivingBoundary boundary = boundaryOf(model, mesh);
    if (progress.cancelled())
        return cancelledError(testing);
    BoundaryRepair repair = BoundaryTest(boundary, end).run(progress);
    if (progress.cancelled())
        return cancelledError(testing);
    return repair;
}

} // namespace tetra
