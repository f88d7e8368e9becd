// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/packed/parts_history.h"
#include "core/refine/curvilinear/curvilinear_grid.h"

#include <tan/base.h>
#include <tan/model.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// Histories that follow from their sites (PARTS.md). Refinement inserts the point of the largest error, and of equal
/// ones the first; that point is a site. So whoever refines with the sites alone, as if there were no other points,
/// makes the same choices, since the largest error of all points is the largest one of the sites, too; and the first
/// sites of a model, up to a mesh of known error, make the first part of its history. Only the tetrahedra's own bounds
/// hold what other points have, of which this finds a lower bound.

/// What it takes besides the sites.
struct SiteFacts {
    HistoryFacts history;
    CurvilinearFacts grid;                    ///< of curvilinear grids
    std::vector<std::uint64_t> foldedCells{}; ///< likewise
};

/// Whether a model can be one of these: refined as a whole, without weights, by the worst point of all. O(1).
bool maySitesTell(const Model& model);

/// The points of a lattice or grid, as far as they are known, and the history that these make. Allocations throw
/// std::bad_alloc.
class KnownSites {
public:
    KnownSites(const SiteFacts& facts, std::shared_ptr<std::byte> samples);

    const SiteFacts& facts() const noexcept { return facts_; }
    std::span<std::byte> samples() noexcept { return {samples_.get(), pointCount() * sampleBytes()}; }
    std::span<const std::byte> samples() const noexcept { return {samples_.get(), pointCount() * sampleBytes()}; }
    /// Three coordinates a point; empty of regular lattices.
    std::span<std::byte> positions() noexcept { return positions_; }
    std::span<const std::byte> positions() const noexcept { return positions_; }
    bool isKnown(std::uint64_t point) const noexcept { return isKnown_[point]; }
    void setKnown(std::uint64_t point) noexcept { isKnown_[point] = true; }
    double coordinate(std::uint64_t point, std::size_t axis) const noexcept;
    std::uint64_t pointCount() const noexcept { return isKnown_.size(); }
    std::size_t sampleBytes() const noexcept { return sampleSize(facts_.history.sampleType); }
    std::size_t coordinateBytes() const noexcept { return facts_.history.coordinateBytes; }

    /// Refines with the known points. Own bounds are those that these points give. Errors: what refinement has;
    /// cancelled; a history larger than the facts allow.
    Result<HistoryArrays> history(const Progress& progress) const;

private:
    SiteFacts facts_;
    std::shared_ptr<std::byte> samples_;
    std::vector<std::byte> positions_;
    std::vector<bool> isKnown_;
};

/// Whether two histories are the same but for own bounds.
bool sameButForBounds(const HistoryArrays& history, const Model& model);

/// Own bounds that hold for every mesh at the end of a batch, from the running keys: `endKey` is that of the last mesh.
void boundByKeys(const HistoryFacts& facts, float endKey, HistoryArrays& history);

struct SiteCoding; ///< the mesh of the sites so far, and what has been learnt

/// Codes the sites of a model in sets, each against the mesh of those before it.
class SiteEncoder {
public:
    /// Errors: too large a lattice, memory.
    static Result<std::unique_ptr<SiteEncoder>> make(const Model& model, const SiteFacts& facts,
                                                     const Progress& progress);
    ~SiteEncoder();

    /// The sites from those that have been coded on up to `end`, which ends a batch; the first set has those of the
    /// first mesh.
    Result<std::vector<std::byte>> encode(std::uint32_t end, const Progress& progress);
    const HistoryCost& cost() const noexcept { return cost_; }
    /// All sites of the model.
    const KnownSites& sites() const noexcept;

private:
    SiteEncoder(const Model& model, std::unique_ptr<SiteCoding> coding);

    const Model& model_;
    std::unique_ptr<SiteCoding> coding_;
    std::uint32_t coded_ = 0;
    HistoryCost cost_;
};

/// The other way.
class SiteDecoder {
public:
    static Result<std::unique_ptr<SiteDecoder>> make(const SiteFacts& facts, const Progress& progress);
    ~SiteDecoder();

    /// `count` more sites. False if the bytes are not what an encoder makes of so many: then the decoder is of no
    /// further use.
    Result<bool> decode(std::span<const std::byte> bytes, std::uint32_t count, const Progress& progress);
    /// Those so far; the mesh is given back.
    const KnownSites& takeSites();

private:
    explicit SiteDecoder(std::unique_ptr<SiteCoding> coding);

    std::unique_ptr<SiteCoding> coding_;
};

/// Codes the own bounds of a whole history, which has those that its sites give, and puts them in their place.
std::vector<std::byte> encodeOwnBounds(const SiteFacts& facts, HistoryArrays& history, const Model& model);
/// The other way. False if the bytes are not what an encoder makes.
[[nodiscard]] bool decodeOwnBounds(const SiteFacts& facts, std::span<const std::byte> bytes, HistoryArrays& history);

} // namespace tetra
