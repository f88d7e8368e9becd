// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/batch_builder.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"

#include <tan/base.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// The history of one block on its way to a model, sorted and complete: a *run*. Its bytes are a header, the words that
/// tell its batches, and its tetrahedra, group by group; they are read by the version of TAn that wrote them only.
/// Instead of all that a run of a curvilinear grid may have cures on faces that its block needs of the others: then it
/// has to be made again.
///
/// Words, for each batch: the running key's bits, the number of groups; for each group: its numbers of sites, of
/// tetrahedra that it made and of those that it destroyed, and the points of its sites. Sites are numbered in this
/// order.
struct BlockRunHeader {
    std::array<char, 8> magic{'T', 'A', 'N', 'R', 'U', 'N', '0', '4'};
    std::uint64_t fingerprint = 0; ///< of all that the run depends on, the cures on its block's faces among it
    std::uint32_t block = 0;
    std::uint32_t siteCount = 0;
    std::uint64_t wordCount = 0;
    std::uint64_t tetrahedronCount = 0;
    float finalKey = 0;
    std::uint32_t recordBytes = 0; ///< of a tetrahedron
    std::uint64_t livingCount = 0; ///< tetrahedra of the mesh of all sites
    std::uint64_t cureCount = 0;
    std::uint32_t inverted = 0;   ///< tetrahedra of the mesh of all sites that stay so
    std::uint32_t degenerate = 0; ///< and those without volume
    std::uint64_t checksum = 0;   ///< of the header up to here and of all that follows
};
static_assert(sizeof(BlockRunHeader) == 80);

/// A tetrahedron in a run: its sites, positive, and its destroyer, `never` if there is none. Blocks of fewer than
/// 65,535 sites do with 16 bits, and where nothing can warp without the warping.
struct NarrowTetrahedron {
    static constexpr std::uint16_t never = 0xffff;

    std::array<std::uint16_t, 4> sites{};
    std::uint16_t destroyer = never;
    std::uint16_t ownError = 0;
};
struct WarpedTetrahedron {
    static constexpr std::uint16_t never = 0xffff;

    std::array<std::uint16_t, 4> sites{};
    std::uint16_t destroyer = never;
    std::uint16_t ownError = 0;
    std::uint16_t ownWarping = 0;
};
struct WideTetrahedron {
    static constexpr std::uint32_t never = 0xffffffff;

    std::array<std::uint32_t, 4> sites{};
    std::uint32_t destroyer = never;
    std::uint16_t ownError = 0;
    std::uint16_t ownWarping = 0;
};
static_assert(sizeof(NarrowTetrahedron) == 12 && sizeof(WarpedTetrahedron) == 14 && sizeof(WideTetrahedron) == 24);

/// What a run takes, in bytes.
std::uint64_t runBytes(const BlockRunHeader& header) noexcept;

/// A finished run; the bytes are its recorder's, until that starts the next one.
struct FinishedRun {
    BlockRunHeader header;
    std::array<std::span<const std::byte>, 3> content; ///< words, tetrahedra, cures: what follows the header
};

/// Of a header, but for its own sum, and what follows it.
std::uint64_t runChecksum(const BlockRunHeader& header, std::span<const std::span<const std::byte>> content);

/// Takes the history of one block after another, in memory used again.
class BlockRunRecorder final : public HistorySink, private BatchSink {
public:
    /// All of the whole dataset; `diagonal` of the box around it, 0 where there is no warping.
    BlockRunRecorder(std::uint64_t pointCount, double valueExtent, double diagonal)
        : pointCount_(pointCount), valueExtent_(valueExtent), diagonal_(diagonal)
    {
    }

    /// Forgets the last block.
    void start();
    Status add(const HistoryStep& step) override;
    Status finish(float finalKey) override;
    /// What else is known of a block of a curvilinear grid; before finished().
    void setFindings(std::vector<FaceCure> cures, std::uint64_t inverted, std::uint64_t degenerate);
    /// After finish(). `fingerprint`: BlockRunHeader's.
    FinishedRun finished(std::uint64_t fingerprint, std::uint32_t block);

    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::uint64_t tetrahedronCount() const noexcept { return tetrahedra_.size(); }

private:
    Status add(const Batch& batch) override;
    void addGroup(const Batch& batch, std::size_t first, std::size_t end);
    std::span<const std::byte> narrowed();

    std::uint64_t pointCount_;
    double valueExtent_;
    double diagonal_;
    std::unique_ptr<BatchBuilder> builder_;
    float finalKey_ = 0;
    std::uint64_t livingCount_ = 0;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> words_;
    std::vector<WideTetrahedron> tetrahedra_;
    std::vector<std::uint32_t> destroyed_; ///< by each site of a batch
    std::vector<NarrowTetrahedron> narrow_;
    std::vector<WarpedTetrahedron> warped_;
    std::vector<FaceCure> cures_;
    std::uint32_t inverted_ = 0;
    std::uint32_t degenerate_ = 0;
};

/// That a mesh of so many tetrahedra fits a model, or as many as are expected in the end as far as that can be known.
/// An Error (OutOfResource) if not.
Status checkMeshSize(std::uint64_t tetrahedra, std::uint64_t expected);

} // namespace tetra
