// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lattice_refinement.h"

#include "core/mesh/box_refinement.h"

#include <new>

namespace tetra {

namespace {

Status checkBox(const LatticeBoxOptions& options)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (options.box.size[axis] < 2 || options.box.size[axis] > options.latticeSize[axis] ||
            options.box.origin[axis] > options.latticeSize[axis] - options.box.size[axis])
            return Error{ErrorKind::WrongUsage, "A block of the lattice needs two points along each axis and must not "
                                                "stick out. Choose another block size."};
    if (!exactWithMetric(options.box.size, options.metric))
        return Error{ErrorKind::OutOfResource, "A block of the lattice is too large to be refined with exact "
                                               "arithmetic. Choose a smaller block size."};
    return {};
}

} // namespace

class LatticeRefiner::State {
public:
    BoxRefinement refinement;
    Buffer<std::byte> samples;
};

LatticeRefiner::LatticeRefiner() = default;
LatticeRefiner::~LatticeRefiner() = default;
LatticeRefiner::LatticeRefiner(LatticeRefiner&&) noexcept = default;
LatticeRefiner& LatticeRefiner::operator=(LatticeRefiner&&) noexcept = default;

Result<LatticeRefinementResult> LatticeRefiner::refine(const LatticeBoxOptions& options, const LatticeSamples& samples,
                                                       HistorySink& sink, const Progress& progress)
{
    if (Status status = checkBox(options); !status)
        return status.error();
    try {
        if (!state_)
            state_ = std::make_unique<State>();
        const bool whole = options.box.size == options.latticeSize;
        return state_->refinement.run(
            options, whole ? samples : samples.copyBox(options.latticeSize, options.box, state_->samples), sink,
            progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to refine this lattice. Close other programs, use a "
                                               "machine with more memory, or crop or subsample the data."};
    }
}

Result<LatticeRefinementResult> refineLattice(const LatticeRefinementOptions& options, const LatticeSamples& samples,
                                              HistorySink& sink, const Progress& progress)
{
    const Result<LatticeMetric> metric = latticeMetric(options.size, options.spacing);
    if (!metric)
        return metric.error();
    LatticeBoxOptions whole;
    whole.latticeSize = options.size;
    whole.box = {{0, 0, 0}, options.size};
    whole.metric = *metric;
    whole.valueExtent = options.valueExtent;
    whole.stopError = options.stopError;
    return LatticeRefiner().refine(whole, samples, sink, progress);
}

} // namespace tetra
