// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "core/base/guarded.h"
#include "core/refine/greedy.h"
#include "core/refine/lattice/packed_lattice.h"
#include "core/refine/lattice/point_pool.h"

#include <limits>

namespace tetra {

namespace {

/// The space of a curvilinear grid (core/refine/greedy.h): what the selection takes first, and cures (S5) before that.
class CurvilinearSpace {
public:
    CurvilinearSpace(CurvilinearMesh& mesh, CurvilinearSelection selection, HistorySink& sink)
        : mesh_(mesh), selection_(selection), sink_(sink)
    {
    }

    struct Next {
        CurvilinearMesh::Candidate candidate;
        float key = 0;
        bool complete = true; ///< no tetrahedron is flipped that may not stay so
    };
    Next next()
    {
        if (const CurvilinearMesh::Candidate flipped = mesh_.flipped(); flipped.exists())
            return {flipped, std::numeric_limits<float>::infinity(), false};
        const CurvilinearMesh::Candidate worst = mesh_.worst();
        if (selection_ == CurvilinearSelection::Normalised)
            return {worst, worst.measure};
        const CurvilinearMesh::Candidate warping = mesh_.worstWarping();
        return {warping.measure > worst.measure ? warping : worst, mesh_.keyOf(worst.measure, warping.measure)};
    }
    Status insert(const Next& next) { return mesh_.insert(next.candidate, next.key, sink_); }
    std::uint64_t work() const { return 200 + mesh_.pointsMoved(); }
    std::uint64_t pointsAboveStop() const { return mesh_.pointsAboveStop(); }
    void sweep() { mesh_.sweep(); }

private:
    CurvilinearMesh& mesh_;
    CurvilinearSelection selection_;
    HistorySink& sink_;
};

/// Whether the arithmetic of computational space is exact in every block, and the points, those on faces as often as
/// blocks have them, can be numbered.
Status checkSize(const std::array<std::uint32_t, 3>& size, const BlockDivision& blocks)
{
    if (!PackedLattice::fits(size))
        return Error{ErrorKind::OutOfResource, Message::say("The grid has too many points to be refined: coordinates "
                                                            "take more than 32 bits. Crop or subsample it.")};
    if (const auto metric = latticeMetric(blocks.box(0).size, {1, 1, 1}); !metric)
        return metric.error();
    std::uint64_t points = 0;
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
        points += blocks.box(block).pointCount();
    return PointPool::checkSize(points);
}

Result<CurvilinearRefinementResult> refine(const CurvilinearGrid& grid, const BlockDivision& blocks,
                                           const CurvilinearRefinementOptions& options, HistorySink& sink,
                                           const Progress& progress)
{
    CurvilinearMesh mesh(grid, blocks,
                         {.warpingWeight = options.warpingWeight,
                          .largestError = options.valueExtent,
                          .largestWarping = options.positionExtent,
                          .stopKey = options.stopKey,
                          .selection = options.selection});
    if (Status status = sink.begin({options.warpingWeight, true, blocks.blockCells()}); !status)
        return status.error();
    progress.report(0, Message::marked("Distributing the points"));
    if (Status status = mesh.start(sink); !status)
        return status.error();
    CurvilinearSpace space(mesh, options.selection, sink);
    const Result<float> key = refineWorstFirst(space, options.stopKey, sink, progress);
    if (!key)
        return key.error();
    return CurvilinearRefinementResult{mesh.siteCount(), mesh.tetrahedronCount(), *key, mesh.inverted(),
                                       mesh.degenerate()};
}

} // namespace

Result<CurvilinearRefinementResult> refineCurvilinear(const std::array<std::uint32_t, 3>& size,
                                                      std::span<const Eigen::Vector3d> positions,
                                                      const LatticeSamples& samples,
                                                      const CurvilinearRefinementOptions& options, HistorySink& sink,
                                                      const Progress& progress)
{
    const BlockDivision blocks(size, options.blockEdge);
    if (Status status = checkSize(size, blocks); !status)
        return status.error();
    return guarded(
        Message::marked(
            "Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop "
            "or subsample the data."),
        [&] { return refine(CurvilinearGrid(size, positions, samples), blocks, options, sink, progress); });
}

} // namespace tetra
