// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/sharp_focus_work.h"

#include "core/base/half.h"
#include "core/mesh/sample_filter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t repairsAtOnce = 256;

} // namespace

/// The file's bounds on the errors of the coarse mesh's tetrahedra, in the order in which extraction gives these.
void SharpFocus::Work::readBounds(std::uint32_t sites)
{
    const double extent = model_.description().range.extent();
    coarseBounds_.assign(coarse_.mesh.tetrahedra.size(), std::numeric_limits<float>::infinity());
    std::size_t slot = 0;
    const std::uint64_t end = std::min(model_.starOffsets()[sites], model_.tetrahedronCount());
    model_.check(model_.ownErrors().first(end)); // what it finds is known to checkIntact()
    for (std::uint64_t t = 0; t < end && slot < coarseBounds_.size(); ++t)
        if (model_.destroyers()[t] >= sites)
            coarseBounds_[slot++] =
                static_cast<float>(static_cast<double>(halfToFloat(model_.ownErrors()[t])) * extent * (1 + 1e-6));
}

Status SharpFocus::Work::knowStars(const Range& range, const Progress& progress)
{
    // Beyond what the model has the bound is not known.
    const std::uint32_t sites = range.fineKnown ? range.fine : 0;
    if (fine_ && fine_->firstCreator() == range.coarse && fine_->siteCount() == sites)
        return {};
    fine_.reset();
    Result<FineStars> stars = FineStars::make(model_, range.coarse, sites, progress);
    if (!stars)
        return stars.error();
    fine_ = *std::move(stars);
    return {};
}

std::array<std::uint32_t, 4> SharpFocus::Work::sitesOf(std::uint32_t slot) const
{
    std::array<std::uint32_t, 4> sites = mesh_.numbers(slot);
    for (std::uint32_t& site : sites)
        site = site < coarseSites_ ? site : addedSites_[site - coarseSites_];
    return sites;
}

/// Looks at slots_. In pieces whose findings are put together in order: it does not matter how many threads there are.
/// Some are missing once the work was cancelled.
void SharpFocus::Work::scan(const FocusLimits& limits, ScannedPart part, const Progress& progress,
                            std::vector<WorstSample>& worst)
{
    constexpr std::size_t pieceSlots = 512;
    const std::size_t count = (slots_.size() + pieceSlots - 1) / pieceSlots;
    const ValueRange& range = model_.description().range;
    const double reach = std::max(std::abs(range.minimum), std::abs(range.maximum));
    std::vector<FilteredTetrahedra> filtered(count);
    std::vector<std::vector<WorstSample>> found(count);
    const auto scanPiece = [&](std::size_t piece) {
        if (progress.cancelled())
            return;
        const std::size_t first = piece * pieceSlots;
        filterTetrahedra(mesh_, std::span(slots_).subspan(first, std::min(pieceSlots, slots_.size() - first)), samples_,
                         reach, limits, part, filtered[piece]);
        scanSamples(mesh_, filtered[piece].suspects, samples_, limits, part, found[piece]);
    };
    if (count < 2)
        for (std::size_t piece = 0; piece < count; ++piece)
            scanPiece(piece);
    else
        tbb::parallel_for(std::size_t(0), count, scanPiece);
    for (const FilteredTetrahedra& some : filtered)
        for (const std::uint32_t slot : some.fine)
            bounds_[slot] = static_cast<float>(limits.least);
    for (const std::vector<WorstSample>& some : found)
        worst.insert(worst.end(), some.begin(), some.end());
}

/// Looks at what changed since the last look, unless its error is known to be small enough.
void SharpFocus::Work::lookAtChanges(const FocusLimits& limits, bool mayBeKnown, const Progress& progress)
{
    worst_.clear();
    slots_.clear();
    bounds_.resize(mesh_.mesh().slotCount());
    constexpr std::size_t ahead = 12;
    const std::span<const std::uint32_t> changed = mesh_.changed();
    for (std::size_t i = 0; i < changed.size(); ++i) {
        if (i + 2 * ahead < changed.size()) {
            mesh_.prefetchNumbers(changed[i + 2 * ahead]);
            __builtin_prefetch(&bounds_[changed[i + 2 * ahead]], 1);
        }
        if (mayBeKnown && i + ahead < changed.size() && mesh_.isAlive(changed[i + ahead]))
            fine_->prefetch(sitesOf(changed[i + ahead]));
        const std::uint32_t slot = changed[i];
        if (!mesh_.isAlive(slot)) {
            bounds_[slot] = 0;
            continue;
        }
        // What the uniform fine mesh has is good enough.
        const bool known = mayBeKnown && fine_->holds(sitesOf(slot));
        bounds_[slot] = known ? static_cast<float>(limits.least) : std::numeric_limits<float>::infinity();
        if (!known)
            slots_.push_back(slot);
    }
    scan(limits, ScannedPart::All, progress, worst_);
    mesh_.acceptChanges();
}

/// Looks at what is inside now and did not change.
void SharpFocus::Work::lookAtOthers(const FocusLimits& limits, bool outsideIsKnown, const Progress& progress)
{
    slots_.clear();
    const auto least = static_cast<float>(limits.least);
    bounds_.resize(mesh_.mesh().slotCount(), 0);
    for (const std::uint32_t slot : mesh_.changed())
        bounds_[slot] = 0;
    const auto isUnknown = [&](std::uint32_t slot) { return bounds_[slot] > least; };
    if (outsideIsKnown) {
        coarseBoxes_.findMeeting(limits.first, limits.last, slots_);
        std::erase_if(slots_, std::not_fn(isUnknown));
    } else {
        for (std::uint32_t slot = 0; slot < coarseBounds_.size(); ++slot)
            if (isUnknown(slot))
                slots_.push_back(slot);
    }
    // What is in place of a coarse tetrahedron may be elsewhere.
    for (const std::uint32_t slot : mesh_.changedEarlier())
        if (slot < coarseBounds_.size() && isUnknown(slot))
            slots_.push_back(slot);
    for (auto slot = static_cast<std::uint32_t>(coarseBounds_.size()); slot < bounds_.size(); ++slot)
        if (isUnknown(slot))
            slots_.push_back(slot);
    scan(limits, outsideIsKnown ? ScannedPart::Limited : ScannedPart::All, progress, others_);
}

/// In rounds: the worst sample of each tetrahedron that is not good enough, the worst first, unless one before it has
/// changed its tetrahedron; then what changed is looked at.
Status SharpFocus::Work::repair(const FocusLimits& limits, const Progress& progress)
{
    while (!worst_.empty()) {
        std::ranges::sort(worst_, isWorse);
        for (std::size_t i = 0; i < worst_.size(); ++i) {
            if (i % repairsAtOnce == 0 && progress.cancelled())
                return cancelledError("Extracting the mesh");
            const WorstSample& worst = worst_[i];
            const DelaunayTetrahedron& now = mesh_.mesh()[worst.slot];
            // Of blocks, several have the sample if it is on their borders.
            if (!(now.determinant() > 0) || now.vertices != worst.tetrahedron)
                continue;
            if (!mesh_.add({&worst.point, 1}))
                return focusTooLarge();
            addedSites_.push_back(sites_->siteAt(lattice_, worst.point).value_or(ExtractedMesh::noSite));
        }
        lookAtChanges(limits, false, progress);
    }
    if (progress.cancelled()) // then nothing may have been found because nothing was looked at
        return cancelledError("Extracting the mesh");
    return {};
}

} // namespace tetra
