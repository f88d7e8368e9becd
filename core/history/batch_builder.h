// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/disjoint_sets.h"

#include <tan/build.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// An array that grows at its end without ever moving what it holds: growing costs no copy and no moment at which
/// twice the memory is needed. Chunks of 64 Ki elements. Growing may throw std::bad_alloc.
template <class T> class ChunkedArray {
public:
    std::size_t size() const noexcept { return size_; }

    T& operator[](std::size_t index) noexcept { return chunks_[index >> shift][index & mask]; }
    const T& operator[](std::size_t index) const noexcept { return chunks_[index >> shift][index & mask]; }

    void push_back(const T& value)
    {
        if ((size_ & mask) == 0)
            chunks_.push_back(std::make_unique_for_overwrite<T[]>(chunkSize));
        chunks_[size_ >> shift][size_ & mask] = value;
        ++size_;
    }

    /// Calls visit(std::span<const T>), which gives a Status, for all elements in order; ends with its first error.
    template <class Visit> Status forEachChunk(const Visit& visit) const
    {
        for (std::size_t number = 0; number < chunks_.size(); ++number) {
            const std::span<const T> chunk(chunks_[number].get(), std::min(chunkSize, size_ - number * chunkSize));
            if (const Status visited = visit(chunk); !visited)
                return visited;
        }
        return {};
    }

private:
    static constexpr std::size_t shift = 16;
    static constexpr std::size_t chunkSize = std::size_t(1) << shift;
    static constexpr std::size_t mask = chunkSize - 1;

    std::vector<std::unique_ptr<T[]>> chunks_;
    std::size_t size_ = 0;
};

/// The steps of a history between which the running key did not fall: no query separates them (S1), so what is born
/// and dies within is left out. Sites linked by what they do to each other's tetrahedra form a group. What an order of
/// the groups means does not depend on it, so a canonical one is taken: groups by their first point, sites by their
/// point. Numbers are those of the builder unless they are called places: 0 is the batch's first in canonical order.
class HistoryBatch {
public:
    struct Tetrahedron {
        std::array<std::uint32_t, 4> sites; ///< positive; the first one made it
        float error = 0;
        float warping = 0;
        bool dropped = false; ///< died within the batch
    };

    /// Forgets everything; the next step makes site `firstSite` and tetrahedra from `firstTetrahedron` on.
    void start(std::uint32_t firstSite, std::uint32_t firstTetrahedron);
    /// The step's sites and tetrahedra exist. May throw std::bad_alloc, as may the other members that change anything.
    void add(const HistoryStep& step);
    /// Makes one group of all sites: the mesh that they start from has no parts.
    void uniteAll();
    /// Finds the canonical order; comes after the last step.
    void arrange();

    std::uint32_t firstSite() const noexcept { return firstSite_; }
    std::uint32_t siteCount() const noexcept { return static_cast<std::uint32_t>(points_.size()); }
    std::uint32_t firstTetrahedron() const noexcept { return firstTetrahedron_; }
    std::span<const Tetrahedron> tetrahedra() const noexcept { return tetrahedra_; }

    /// The point of the site at `place`.
    std::uint64_t pointAt(std::uint32_t place) const { return points_[order_[place]]; }
    /// Whether the site at the next place belongs to the same group.
    bool groupGoesOn(std::uint32_t place) const
    {
        return place + 1 < siteCount() && firsts_[order_[place]] == firsts_[order_[place + 1]];
    }
    /// Where a site of this batch went.
    std::uint32_t placeOf(std::uint32_t site) const { return places_[site - firstSite_]; }

private:
    std::uint32_t firstSite_ = 0;
    std::uint32_t firstTetrahedron_ = 0;
    std::vector<std::uint64_t> points_;
    DisjointSets groups_;
    std::vector<std::uint32_t> firsts_; ///< of each site, after arrange(): the site of its group's first point
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> places_;
    std::vector<Tetrahedron> tetrahedra_;
};

/// The sites of a positive tetrahedron with the latest brought to the front, still positive.
std::array<std::uint32_t, 4> latestFirst(const std::array<std::uint32_t, 4>& sites);

/// A complete batch (FORMAT.md): its sites in canonical order, and what is to be stored of it. Sites and tetrahedra
/// have the numbers under which they are stored.
struct Batch {
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
class BatchSink {
public:
    virtual ~BatchSink() = default;
    /// May throw std::bad_alloc.
    virtual Status add(const Batch& batch) = 0;
};

/// Turns the steps of a history into batches while they come. Memory: 4 bytes a site, 4 a tetrahedron that was ever
/// made, and one batch whole. Members that return a Status may throw std::bad_alloc.
class BatchBuilder {
public:
    BatchBuilder(std::uint64_t pointCount, BatchSink& sink) : pointCount_(pointCount), sink_(sink) {}

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
    BatchSink& sink_;
    Status failure_; ///< the first one, which every further call gives again
    HistoryBatch batch_;
    float runningKey_ = std::numeric_limits<float>::infinity();
    std::uint64_t alive_ = 0;
    std::uint32_t storedCount_ = 0;
    ChunkedArray<std::uint32_t> finalNumbers_;  ///< of each of the builder's sites
    ChunkedArray<std::uint32_t> storedNumbers_; ///< of each of the builder's tetrahedra

    std::vector<Batch::Destruction> destructions_;
    std::vector<std::uint64_t> points_;
    std::vector<std::uint8_t> groupGoesOn_;
    std::vector<std::uint32_t> starEnds_;
    std::vector<Batch::Tetrahedron> staying_;   ///< as they were made
    std::vector<std::uint32_t> stayingNumbers_; ///< theirs in the batch
    std::vector<Batch::Tetrahedron> sorted_;    ///< star by star
};

} // namespace tetra
