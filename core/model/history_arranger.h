// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/history.h"
#include "core/model/chunked_array.h"
#include "core/model/history_batch.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// A complete batch (FORMAT.md): its sites in canonical order, and what is to be stored of it. Sites and tetrahedra
/// have the numbers under which they are stored.
struct ArrangedBatch {
    struct Tetrahedron {
        std::array<std::uint32_t, 4> sites; ///< positive, the latest first
        float error = 0;
        float warping = 0;
    };
    /// A tetrahedron of an earlier batch and the site that destroyed it.
    struct Destruction {
        std::uint32_t tetrahedron = 0;
        std::uint32_t destroyer = 0;
    };

    float runningKey = 0;
    std::uint32_t firstSite = 0;
    std::uint32_t firstTetrahedron = 0;
    std::span<const std::uint64_t> points;
    std::span<const std::uint8_t> groupGoesOn;
    std::span<const std::uint32_t> starEnds; ///< of each site, counted in `tetrahedra`
    std::span<const Tetrahedron> tetrahedra; ///< star by star
    std::span<const Destruction> destructions;
};

/// Takes what complete batches are made of.
class ArrangedBatchSink {
public:
    virtual ~ArrangedBatchSink() = default;
    /// May throw std::bad_alloc.
    virtual Status add(const ArrangedBatch& batch) = 0;
};

/// Turns the steps of a history into batches while they come. Memory: 4 bytes a site, 4 a tetrahedron that was ever
/// made, and one batch whole. Members that return a Status may throw std::bad_alloc.
class HistoryArranger {
public:
    HistoryArranger(std::uint64_t pointCount, ArrangedBatchSink& sink) : pointCount_(pointCount), sink_(sink) {}

    /// Plugins are written by others: a step that does not fit is an Error whose text says only what is wrong with it,
    /// and the end of the history.
    Status add(const HistoryStep& step);
    /// Hands over the last batch.
    Status finish();
    /// In place of finish(): forgets the batch that is not complete. Nothing can be added then.
    void abandonBatch();

    std::uint32_t siteCount() const noexcept { return batch_.firstSite() + batch_.siteCount(); }
    /// Of the batch that is not complete; also the key of the mesh before it.
    float runningKey() const noexcept { return runningKey_; }
    /// Handed over so far.
    std::uint32_t storedCount() const noexcept { return storedCount_; }
    /// In the mesh after the last step.
    std::uint64_t aliveCount() const noexcept { return alive_; }

private:
    Status take(const HistoryStep& step);
    Status check(const HistoryStep& step) const;
    Status record(const HistoryStep& step);
    Status closeBatch();
    void numberSites();
    void sortTetrahedra();
    std::uint32_t madeCount() const noexcept { return static_cast<std::uint32_t>(storedNumbers_.size()); }

    /// The number of a tetrahedron that is dead.
    static constexpr std::uint32_t gone = 0xffffffff;

    std::uint64_t pointCount_;
    ArrangedBatchSink& sink_;
    Status failure_; ///< the first one, which every further call gives again
    HistoryBatch batch_;
    float runningKey_ = std::numeric_limits<float>::infinity();
    std::uint64_t alive_ = 0;
    std::uint32_t storedCount_ = 0;
    ChunkedArray<std::uint32_t> finalNumbers_;  ///< of each of the builder's sites
    ChunkedArray<std::uint32_t> storedNumbers_; ///< of each of the builder's tetrahedra

    std::vector<ArrangedBatch::Destruction> destructions_;
    std::vector<std::uint64_t> points_;
    std::vector<std::uint8_t> groupGoesOn_;
    std::vector<std::uint32_t> starEnds_;
    std::vector<ArrangedBatch::Tetrahedron> staying_; ///< as they were made
    std::vector<std::uint32_t> stayingNumbers_;       ///< theirs in the batch
    std::vector<ArrangedBatch::Tetrahedron> sorted_;  ///< star by star
};

} // namespace tetra
