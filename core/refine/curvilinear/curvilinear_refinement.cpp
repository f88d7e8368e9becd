// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "core/refine/lattice/packed_lattice.h"
#include "core/refine/lattice/point_pool.h"

#include <algorithm>
#include <limits>
#include <new>

namespace tetra {

namespace {

/// What comes next, and the key of the mesh before it.
struct NextPoint {
    CurvilinearMesh::Candidate candidate;
    float key = 0;
    bool consistent = true;
};

NextPoint choose(CurvilinearMesh& mesh, CurvilinearSelection selection)
{
    if (const CurvilinearMesh::Candidate flipped = mesh.flipped(); flipped.exists())
        return {flipped, std::numeric_limits<float>::infinity(), false};
    const CurvilinearMesh::Candidate worst = mesh.worst();
    if (selection == CurvilinearSelection::Normalised)
        return {worst, worst.measure};
    const CurvilinearMesh::Candidate warping = mesh.worstWarping();
    return {warping.measure > worst.measure ? warping : worst, mesh.keyOf(worst.measure, warping.measure)};
}

/// Whether the arithmetic of computational space is exact in every block, and the points, those on faces as often as
/// blocks have them, can be numbered.
Status checkSize(const std::array<std::uint32_t, 3>& size, const BlockDivision& blocks)
{
    if (!PackedLattice::fits(size))
        return Error{ErrorKind::OutOfResource, "The grid has too many points to be refined: coordinates take more than "
                                               "32 bits. Crop or subsample it."};
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
    if (Status status = sink.begin({options.warpingWeight}); !status)
        return status.error();
    progress.report(0, "Distributing the points");
    if (Status status = mesh.start(sink); !status)
        return status.error();
    const double pointsAtStart = static_cast<double>(std::max<std::uint64_t>(mesh.pointsAboveStop(), 1));
    double fraction = 0;
    // Early insertions move millions of points, late ones a few: ask by work done, not by insertions.
    constexpr std::uint64_t workBetweenReports = 1u << 20;
    std::uint64_t work = 0;
    for (;;) {
        const NextPoint choice = choose(mesh, options.selection);
        if (choice.consistent && choice.key <= options.stopKey) {
            if (Status status = sink.finish(choice.key); !status)
                return status.error();
            return CurvilinearRefinementResult{mesh.siteCount(), mesh.tetrahedronCount(), choice.key, mesh.inverted(),
                                               mesh.degenerate()};
        }
        if (Status status = mesh.insert(choice.candidate, choice.key, sink); !status)
            return status.error();
        work += 200 + mesh.pointsMoved();
        if (work < workBetweenReports)
            continue;
        work = 0;
        if (progress.cancelled())
            return cancelledError("The refinement");
        // The error is not monotone, and so what is left to do is not.
        fraction = std::max(fraction, 1 - static_cast<double>(mesh.pointsAboveStop()) / pointsAtStart);
        progress.report(fraction, "Refining");
        mesh.sweep();
    }
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
    try {
        return refine(CurvilinearGrid(size, positions, samples), blocks, options, sink, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to refine this grid. Close other programs, use a "
                                               "machine with more memory, or crop or subsample the data."};
    }
}

} // namespace tetra
