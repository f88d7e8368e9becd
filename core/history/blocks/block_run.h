// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/batch_builder.h"

#include <tan/base.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

/// The history of one block on its way to a model, sorted and complete: a *run*. In a file it is a header, the words
/// that tell its batches, and its tetrahedra, group by group. Files are read by the program that wrote them only.
///
/// Words, for each batch: the running key's bits, the number of groups; for each group: its numbers of sites, of
/// tetrahedra that it made and of those that it destroyed, and the points of its sites. Sites are numbered in this
/// order.
struct BlockRunHeader {
    std::array<char, 8> magic{'T', 'A', 'N', 'R', 'U', 'N', '0', '2'};
    std::uint64_t fingerprint = 0; ///< of all that the run depends on
    std::uint32_t block = 0;
    std::uint32_t siteCount = 0;
    std::uint64_t wordCount = 0;
    std::uint64_t tetrahedronCount = 0;
    float finalKey = 0;
    std::uint32_t recordBytes = 0; ///< of a tetrahedron
    std::uint64_t livingCount = 0; ///< tetrahedra of the mesh of all sites
    std::uint64_t checksum = 0;    ///< of the header up to here and of all that follows
};
static_assert(sizeof(BlockRunHeader) == 64);

/// A tetrahedron in a run: its sites, positive, and its destroyer, `never` if there is none. Blocks of fewer than
/// 65,535 sites do with 16 bits.
template <class Number> struct BlockRunTetrahedron {
    static constexpr Number never = static_cast<Number>(-1);

    std::array<Number, 4> sites{};
    Number destroyer = never;
    std::uint16_t ownError = 0;
};
using NarrowTetrahedron = BlockRunTetrahedron<std::uint16_t>;
using WideTetrahedron = BlockRunTetrahedron<std::uint32_t>;
static_assert(sizeof(NarrowTetrahedron) == 12 && sizeof(WideTetrahedron) == 24);

/// Takes the history of one block after another, in memory used again.
class BlockRunRecorder final : public HistorySink, private BatchSink {
public:
    /// `pointCount` and `valueExtent` of the whole dataset.
    BlockRunRecorder(std::uint64_t pointCount, double valueExtent) : pointCount_(pointCount), valueExtent_(valueExtent)
    {
    }

    /// Forgets the last block.
    void start();
    Status add(const HistoryStep& step) override;
    Status finish(float finalKey) override;
    /// Writes the finished run; the file is there whole or not at all. Its bytes are not synced: after a power failure
    /// the checksum tells.
    Status write(const std::filesystem::path& path, std::uint64_t fingerprint, std::uint32_t block);

    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::uint64_t tetrahedronCount() const noexcept { return tetrahedra_.size(); }

private:
    Status add(const Batch& batch) override;
    void addGroup(const Batch& batch, std::size_t first, std::size_t end);
    void narrow();

    std::uint64_t pointCount_;
    double valueExtent_;
    std::unique_ptr<BatchBuilder> builder_;
    float finalKey_ = 0;
    std::uint64_t livingCount_ = 0;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> words_;
    std::vector<WideTetrahedron> tetrahedra_;
    std::vector<std::uint32_t> destroyed_; ///< by each site of a batch
    std::vector<NarrowTetrahedron> narrow_;
};

/// Of its file, in all.
std::uint64_t runBytes(const BlockRunHeader& header) noexcept;

/// That a mesh of so many tetrahedra fits a model, or as many as are expected in the end as far as that can be known.
/// An Error (OutOfResource) if not.
Status checkMeshSize(std::uint64_t tetrahedra, std::uint64_t expected);

/// The runs of all blocks of a build, as files in one folder. Reading is safe from any number of threads.
class RunFiles {
public:
    /// Runs of `blockCount` blocks that depend on what `fingerprint` stands for.
    RunFiles(std::filesystem::path folder, std::uint64_t fingerprint, std::uint32_t blockCount);
    ~RunFiles();
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;

    std::uint32_t blockCount() const noexcept { return static_cast<std::uint32_t>(headers_.size()); }
    std::filesystem::path path(std::uint32_t block) const;
    std::uint64_t fingerprint() const noexcept { return fingerprint_; }

    /// Whether the run of the block is there, whole and of this build: reads all of it.
    bool intact(std::uint32_t block) const;

    /// Of a run that is there; for building.
    Result<BlockRunHeader> readHeader(std::uint32_t block) const;

    /// Reads the headers; comes before the members below, when all runs are there.
    Status open();
    const BlockRunHeader& header(std::uint32_t block) const { return headers_[block]; }
    Status readWords(std::uint32_t block, std::uint64_t first, std::span<std::uint32_t> words) const;
    Status readTetrahedra(std::uint32_t block, std::uint64_t first, std::uint64_t count, std::span<std::byte> to) const;

private:
    class OpenFile;

    Result<BlockRunHeader> readHeader(const OpenFile& file, std::uint32_t block) const;
    Status read(std::uint32_t block, std::uint64_t offset, std::span<std::byte> to) const;
    Error unreadable(std::uint32_t block, int systemError) const;
    Error unreadable(std::uint32_t block, const Message& why) const;
    Error damaged(std::uint32_t block) const;

    std::filesystem::path folder_;
    std::uint64_t fingerprint_;
    std::vector<BlockRunHeader> headers_;
    std::vector<int> descriptors_; ///< none if there are too many to keep them open
};

} // namespace tetra
