// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include "core/base/guarded.h"
#include "core/refine/curvilinear/space_errors.h"
#include "core/refine/greedy.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/packed_lattice.h"
#include "core/refine/lattice/point_pool.h"
#include "core/refine/noted_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr float infiniteKey = std::numeric_limits<float>::infinity();

/// The space of a curvilinear grid (core/refine/greedy.h): what the selection takes first, and cures (S5) before that.
class CurvilinearSpace {
public:
    CurvilinearSpace(CurvilinearMesh& mesh, CurvilinearSelection selection, HistorySink& sink)
        : mesh_(mesh), selection_(selection), sink_(sink)
    {
    }
    CurvilinearSpace(CurvilinearMesh& mesh, HistorySink& sink, std::span<const FaceCure> known,
                     std::vector<FaceCure>& found)
        : mesh_(mesh), selection_(CurvilinearSelection::Normalised), sink_(sink), known_(known), found_(&found)
    {
    }

    struct Next {
        CurvilinearMesh::Candidate candidate;
        float key = 0;
        bool complete = true; ///< no tetrahedron is flipped that may not stay so
    };
    Next next()
    {
        // All that are known of one key, with nothing in between.
        if (const Next cure = nextKnown(runningKey_); cure.candidate.exists())
            return cure;
        if (const CurvilinearMesh::Candidate flipped = mesh_.flipped(); flipped.exists()) {
            if (mesh_.isShared(flipped.point))
                found_->push_back({mesh_.wholeIndex(flipped.point), runningKey_});
            return {flipped, infiniteKey, false};
        }
        const Next worst = nextWorst();
        const Next cure = nextKnown(worst.key);
        return cure.candidate.exists() ? cure : worst;
    }
    Status insert(const Next& next)
    {
        runningKey_ = std::min(runningKey_, next.key);
        return mesh_.insert(next.candidate, next.key, sink_);
    }
    std::uint64_t work() const { return 200 + mesh_.pointsMoved(); }
    std::uint64_t pointsAboveStop() const { return mesh_.pointsAboveStop(); }
    void sweep() { mesh_.sweep(); }
    void archive(StateArchive& archive) { archive(mesh_, runningKey_); }

private:
    /// The next known cure if its key is not less than `key` and it is not a site already.
    Next nextKnown(float key)
    {
        while (!known_.empty() && known_.front().key >= key) {
            const FaceCure cure = known_.front();
            known_ = known_.subspan(1);
            if (const CurvilinearMesh::Candidate candidate = mesh_.at(cure.point); candidate.exists())
                return {candidate, cure.key, false};
        }
        return {};
    }
    Next nextWorst()
    {
        const CurvilinearMesh::Candidate worst = mesh_.worst();
        if (selection_ == CurvilinearSelection::Normalised)
            return {worst, worst.measure};
        const CurvilinearMesh::Candidate warping = mesh_.worstWarping();
        return {warping.measure > worst.measure ? warping : worst, mesh_.keyOf(worst.measure, warping.measure)};
    }

    CurvilinearMesh& mesh_;
    CurvilinearSelection selection_;
    HistorySink& sink_;
    std::span<const FaceCure> known_;
    std::vector<FaceCure>* found_ = nullptr; ///< there are no others without other blocks
    float runningKey_ = infiniteKey;
};

/// Whether the arithmetic of computational space is exact, and the points can be numbered.
Status checkSize(const std::array<std::uint32_t, 3>& size)
{
    if (!PackedLattice::fits(size))
        return Error{ErrorKind::OutOfResource,
                     Message::say("The grid has too many points to be refined: its coordinates need more than 32 bits. "
                                  "Crop or subsample it.")};
    if (const auto metric = latticeMetric(size, {1, 1, 1}); !metric)
        return metric.error();
    return PointPool::checkSize(std::uint64_t(size[0]) * size[1] * size[2]);
}

Result<CurvilinearRefinementResult> resultOf(const CurvilinearMesh& mesh, const Result<float>& key)
{
    if (!key)
        return key.error();
    return CurvilinearRefinementResult{mesh.siteCount(), mesh.tetrahedronCount(), *key, mesh.inverted(),
                                       mesh.degenerate()};
}

Result<CurvilinearRefinementResult> finishedBy(CurvilinearSpace& space, const CurvilinearMesh& mesh, double stopKey,
                                               HistorySink& sink, const Progress& progress, SavedState* state = nullptr)
{
    return resultOf(mesh, refineWorstFirst(space, stopKey, sink, progress, state));
}

/// What comes when in a whole grid that keeps the error in space as well (C12): in the grid the worst until it is no
/// worse than the rung; then what one look at the error in space has found; and so by turns, from rung to rung.
class SpaceRefinement {
public:
    SpaceRefinement(const CurvilinearGrid& grid, CurvilinearMesh& mesh, const CurvilinearRefinementOptions& options,
                    HistorySink& sink, const Progress& progress)
        : mesh_(mesh), options_(options), sink_(sink), progress_(progress),
          space_(mesh, CurvilinearSelection::Normalised, sink), errors_(grid, options.valueExtent)
    {
    }

    /// Before anything in the grid, what was found in tetrahedra that no insertion since then has destroyed.
    std::optional<CurvilinearMesh::Candidate> next()
    {
        const auto stands = [this](const SpaceErrors::Worst& worst) {
            const DelaunayTetrahedron& now = mesh_.tetrahedra()[worst.slot];
            return now.determinant() > 0 && now.vertices == worst.tetrahedron;
        };
        while (const SpaceErrors::Worst* const worst = found_.next(stands))
            if (const CurvilinearMesh::Candidate candidate = mesh_.at(worst->point); candidate.exists())
                return candidate;
        const CurvilinearSpace::Next next = space_.next();
        inGrid_ = next.key;
        if (next.complete && !(static_cast<double>(next.key) > rung_))
            return std::nullopt;
        return next.candidate;
    }
    /// Of a mesh that is no rung's last its distance from the data is not known.
    Status insert(const CurvilinearMesh::Candidate& candidate)
    {
        return space_.insert({candidate, std::exchange(key_, infiniteKey), false});
    }
    std::uint64_t work() const { return space_.work(); }
    Status pause()
    {
        const bool cancelled = progress_.cancelled();
        if (options_.state != nullptr)
            options_.state->pause(*this, cancelled);
        if (cancelled)
            return cancelledError(Message::marked("The refinement"));
        space_.sweep();
        return {};
    }
    Result<bool> look()
    {
        if (const Status paused = pause(); !paused)
            return paused.error();
        const float inSpace = errors_.measure(mesh_.tetrahedra(), rung_, found_.found);
        if (found_.begin(SpaceErrors::isWorse))
            return true;
        key_ = std::max(inGrid_, inSpace);
        if (static_cast<double>(key_) > options_.stopKey) {
            goDown();
            return true;
        }
        const Status finished = sink_.finish(key_);
        return finished ? Result<bool>(false) : finished.error();
    }
    /// Of the mesh as it is, if it is a rung's last.
    float key() const { return key_; }

    void archive(StateArchive& archive) { archive(space_, errors_, found_, key_, rung_, first_); }

private:
    static constexpr double downToRung = 0.95;

    void goDown()
    {
        // Below a hundredth of a percent there is one rung, the last: more are not worth their time.
        const double least = 1e-4 * std::max(options_.valueExtent, options_.warpingWeight * options_.positionExtent);
        const auto key = static_cast<double>(key_);
        rung_ = std::max(options_.stopKey, downToRung * key);
        if (rung_ < least)
            rung_ = options_.stopKey;
        first_ = std::max(first_, key);
        const double last = std::max(least, options_.stopKey);
        progress_.report(std::clamp(std::log(first_ / key) / std::log(std::max(first_ / last, 2.0)), 0.0, 1.0),
                         Message::marked("Refining"));
    }

    CurvilinearMesh& mesh_;
    const CurvilinearRefinementOptions& options_;
    HistorySink& sink_;
    const Progress& progress_;
    CurvilinearSpace space_;
    SpaceErrors errors_;
    Round<SpaceErrors::Worst> found_;
    float inGrid_ = 0;                                      ///< the key there
    float key_ = infiniteKey;                               ///< of the mesh as it is, if that is known
    double rung_ = std::numeric_limits<double>::infinity(); ///< that the mesh is on its way to
    double first_ = 0;                                      ///< key that was known
};

Result<CurvilinearRefinementResult> refine(const CurvilinearGrid& grid, const CurvilinearRefinementOptions& options,
                                           HistorySink& sink, const Progress& progress)
{
    const std::array<std::uint32_t, 3>& size = grid.lattice().size();
    const CurvilinearMesh::Options meshOptions{.warpingWeight = options.warpingWeight,
                                               .largestError = options.valueExtent,
                                               .largestWarping = options.positionExtent,
                                               .stopKey = options.stopKey,
                                               .selection = options.selection,
                                               .size = size,
                                               .box = {{0, 0, 0}, size}};
    NotedHistory history(sink, options.state);
    if (Status status = history.begin({options.warpingWeight}); !status)
        return status.error();
    progress.report(0, Message::marked("Distributing the points"));
    CurvilinearMesh mesh;
    if (Status status = mesh.start(grid, meshOptions, history); !status)
        return status.error();
    if (options.inSpace) {
        SpaceRefinement order(grid, mesh, options, history, progress);
        if (Status status = history.goOn(order, progress); !status)
            return status.error();
        const Status refined = refineGreedily(order);
        return resultOf(mesh, refined ? Result<float>(order.key()) : refined.error());
    }
    CurvilinearSpace space(mesh, options.selection, history);
    if (Status status = history.goOn(space, progress); !status)
        return status.error();
    return finishedBy(space, mesh, options.stopKey, history, progress, options.state);
}

constexpr MarkedText noMemoryForGrid = Message::marked(
    "Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop "
    "or subsample the data.");

} // namespace

Result<CurvilinearRefinementResult> refineCurvilinear(const std::array<std::uint32_t, 3>& size,
                                                      std::span<const Eigen::Vector3d> positions,
                                                      const LatticeSamples& samples,
                                                      const CurvilinearRefinementOptions& options, HistorySink& sink,
                                                      const Progress& progress)
{
    if (Status status = checkSize(size); !status)
        return status.error();
    return guarded(noMemoryForGrid, [&] {
        return options.known != nullptr
                   ? refine(CurvilinearGrid(size, positions, samples, *options.known), options, sink, progress)
                   : refine(CurvilinearGrid(size, positions, samples), options, sink, progress);
    });
}

namespace {

bool comesBefore(const FaceCure& one, const FaceCure& other)
{
    return std::tuple(-one.key, one.point) < std::tuple(-other.key, other.point);
}

} // namespace

std::vector<std::uint32_t> FaceCures::add(std::span<const FaceCure> found)
{
    std::vector<bool> changed(ofBlocks_.size());
    std::vector<std::uint32_t> blocks;
    for (const FaceCure& cure : found) {
        const auto& size = division_.size();
        const std::uint64_t row = cure.point / size[0];
        division_.blocksOf({static_cast<std::uint32_t>(cure.point % size[0]), static_cast<std::uint32_t>(row % size[1]),
                            static_cast<std::uint32_t>(row / size[1])},
                           blocks);
        for (const std::uint32_t block : blocks) {
            std::vector<FaceCure>& known = ofBlocks_[block];
            const auto same = std::ranges::find(known, cure.point, &FaceCure::point);
            if (same == known.end())
                known.push_back(cure);
            else if (same->key < cure.key)
                same->key = cure.key;
            else
                continue;
            changed[block] = true;
        }
    }
    blocks.clear();
    for (std::uint32_t block = 0; block < changed.size(); ++block)
        if (changed[block]) {
            std::ranges::sort(ofBlocks_[block], comesBefore);
            blocks.push_back(block);
        }
    return blocks;
}

std::vector<FaceCure> FaceCures::wholeFacesOf(std::span<const FaceCure> found) const
{
    std::vector<FaceCure> whole;
    const auto& size = division_.size();
    for (const FaceCure& cure : found) {
        const std::uint64_t row = cure.point / size[0];
        const std::array<std::uint32_t, 3> at{static_cast<std::uint32_t>(cure.point % size[0]),
                                              static_cast<std::uint32_t>(row % size[1]),
                                              static_cast<std::uint32_t>(row / size[1])};
        std::vector<std::uint32_t> blocks;
        division_.blocksOf(at, blocks);
        for (const std::uint32_t block : blocks)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                LatticeBox face = division_.box(block);
                if ((at[axis] != face.origin[axis] && at[axis] != face.last(axis)) || at[axis] == 0 ||
                    at[axis] + 1 == size[axis])
                    continue;
                face.origin[axis] = at[axis];
                face.size[axis] = 1;
                for (std::uint64_t z = face.origin[2]; z <= face.last(2); ++z)
                    for (std::uint64_t y = face.origin[1]; y <= face.last(1); ++y)
                        for (std::uint64_t x = face.origin[0]; x <= face.last(0); ++x)
                            whole.push_back({(z * size[1] + y) * size[0] + x, infiniteKey});
            }
    }
    std::ranges::sort(whole, {}, &FaceCure::point);
    const auto repeated = std::ranges::unique(whole, {}, &FaceCure::point);
    whole.erase(repeated.begin(), repeated.end());
    return whole;
}

std::vector<FaceCure> FaceCures::all() const
{
    std::vector<FaceCure> cures;
    for (const std::vector<FaceCure>& ofBlock : ofBlocks_)
        cures.insert(cures.end(), ofBlock.begin(), ofBlock.end());
    std::ranges::sort(cures, {}, &FaceCure::point);
    const auto repeated = std::ranges::unique(cures, {}, &FaceCure::point);
    cures.erase(repeated.begin(), repeated.end());
    return cures;
}

struct CurvilinearRefiner::State {
    CurvilinearMesh mesh;
    Buffer<std::byte> boxSamples;
};

CurvilinearRefiner::CurvilinearRefiner() = default;
CurvilinearRefiner::~CurvilinearRefiner() = default;
CurvilinearRefiner::CurvilinearRefiner(CurvilinearRefiner&&) noexcept = default;
CurvilinearRefiner& CurvilinearRefiner::operator=(CurvilinearRefiner&&) noexcept = default;

Result<CurvilinearRefinementResult>
CurvilinearRefiner::refine(const CurvilinearBoxOptions& options, std::span<const Eigen::Vector3d> positions,
                           const LatticeSamples& samples, std::span<const FaceCure> known, std::vector<FaceCure>& found,
                           HistorySink& sink, const Progress& progress)
{
    if (Status status = checkSize(options.box.size); !status)
        return status.error();
    const auto refineBox = [&]() -> Result<CurvilinearRefinementResult> {
        if (!state_)
            state_ = std::make_unique<State>();
        const CurvilinearGrid grid(options.size, options.box, positions,
                                   samples.copyBox(options.size, options.box, state_->boxSamples), options.facts);
        const CurvilinearMesh::Options meshOptions{.warpingWeight = options.warpingWeight,
                                                   .largestError = options.valueExtent,
                                                   .largestWarping = options.positionExtent,
                                                   .stopKey = options.stopKey,
                                                   .size = options.size,
                                                   .box = options.box,
                                                   .centreAtOrigin = options.centreAtOrigin};
        progress.report(0, Message::marked("Distributing the points"));
        if (Status status = state_->mesh.start(grid, meshOptions, sink); !status)
            return status.error();
        CurvilinearSpace space(state_->mesh, sink, known, found);
        return finishedBy(space, state_->mesh, options.stopKey, sink, progress);
    };
    return guarded(noMemoryForGrid, refineBox);
}

} // namespace tetra
