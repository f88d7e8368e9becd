// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/byte_source.h"
#include "core/base/file_writer.h"
#include "core/base/scratch_file.h"
#include "core/history/file_layout.h"
#include "core/history/format.h"
#include "core/history/lattice_frame.h"

#include <tan/model.h>
#include <tan/packed.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace tetra {

/// Writes a packed model (FORMAT.md, "Packed form"): its facts and levels in front, then chunks, which mean what the
/// method says. Nothing appears under the path before finish(). Memory: the levels; chunks wait on the disk. One
/// thread. May throw std::bad_alloc.
class PackedFileWriter {
public:
    /// Facts, text and sums are taken from the model. Errors: the file cannot be written, the model's text or table is
    /// damaged.
    static Result<std::unique_ptr<PackedFileWriter>> create(const std::filesystem::path& output, const Model& model,
                                                            PackMethod method);

    const std::filesystem::path& target() const noexcept { return file_.target(); }
    /// Of a replayed model: along an edge of its blocks.
    void setBlockCells(std::uint32_t cells) noexcept { facts_.blockCells = cells; }
    /// Of one chunk at most format::mostPackedChunkBytes.
    Status addChunk(std::uint32_t kind, std::span<const std::byte> bytes);
    /// All chunks so far make a mesh of so many sites and these bounds, in units of the values and of length. Sites
    /// rise from level to level, errors never do. At most format::mostPackedLevels.
    void endLevel(float error, float warping, std::uint32_t sites, std::uint32_t replayLevel = 0);
    /// Takes the last level back.
    void dropLevel() { levels_.pop_back(); }
    std::size_t levelCount() const noexcept { return levels_.size(); }
    /// The size of the file, if it ended here.
    std::uint64_t size() const noexcept;
    /// Writes the file.
    Status finish();

private:
    PackedFileWriter(FileWriter file, const Model& model, PackMethod method);

    FileWriter file_;
    SpoolFile spool_;
    SpooledArray<std::byte> chunks_{spool_};
    format::Header header_;
    format::PackedFacts facts_;
    std::vector<FrameSection> frame_;
    std::string text_;
    std::vector<format::PackedSum> sums_;
    std::vector<format::PackedLevelEntry> levels_;
};

/// The front of a packed model, and the way to its chunks. Immutable; from any thread, if its source is.
class PackedFile {
public:
    static Result<std::unique_ptr<const PackedFile>> open(ByteSource source, const std::filesystem::path& name,
                                                          const Progress& progress);

    const std::filesystem::path& name() const noexcept { return name_; }
    std::uint64_t size() const noexcept { return source_.size; }
    const ByteSource& source() const noexcept { return source_; }
    /// Its checksum and sections are those of this file, all else is the model's that was packed.
    const format::Header& header() const noexcept { return header_; }
    const ModelDescription& description() const noexcept { return description_; }
    const format::PackedFacts& facts() const noexcept { return facts_; }
    /// Of the sections of the model that was packed.
    std::span<const format::PackedSum> sums() const noexcept { return sums_; }
    /// At least one; sites rise, bytes do not fall and errors do not rise; all of them lie within what the header says.
    std::span<const format::PackedLevelEntry> levels() const noexcept { return levels_; }
    /// Where the chunks begin, and how many bytes they have.
    ByteRange chunks() const noexcept { return chunks_; }
    /// Of a file on this machine compares the checksum of all chunks with that of the table, once: their own ones say
    /// that each is whole, not that they are those of this file. O(bytes of the file). Of a file elsewhere, of which
    /// whoever wants a level reads no more than that, does nothing. From any thread. Errors: damage, cancelled.
    Status checkChunks(const Progress& progress) const;
    /// "... is damaged: WHAT. Copy the file again."
    Error damaged(const Message& what) const;

private:
    PackedFile() = default;
    Status readFront(const Progress& progress);
    Status checkFront() const;
    Status sumChunks(const Progress& progress) const;

    ByteSource source_;
    std::filesystem::path name_;
    format::Header header_;
    ModelDescription description_;
    format::PackedFacts facts_;
    std::vector<format::PackedSum> sums_;
    std::vector<format::PackedLevelEntry> levels_;
    ByteRange chunks_;
    std::uint64_t chunksSum_ = 0; ///< as the table has it
    mutable std::mutex checking_;
    mutable bool areChecked_ = false; ///< guarded: the chunks, and they are right
};

/// Reads chunks in order, each checked against its sum; asks the source for a piece of the file at a time.
class PackedChunkReader {
public:
    /// The first `bytes` of the chunks; all of them for those behind the last level, too.
    PackedChunkReader(const PackedFile& file, std::uint64_t bytes) : file_(file), end_(bytes) {}

    /// How many bytes have been read.
    std::uint64_t place() const noexcept { return place_; }
    /// Whether there is one more, which kind() and bytes() then are. Errors: damage, the source's, cancelled.
    Result<bool> next(const Progress& progress);
    std::uint32_t kind() const noexcept { return head_.kind; }
    /// Until next() is called.
    std::span<const std::byte> bytes() const noexcept { return bytes_; }

private:
    Status have(std::uint64_t count, const Progress& progress);

    const PackedFile& file_;
    std::uint64_t end_;
    std::uint64_t place_ = 0;
    std::uint64_t windowPlace_ = 0;
    std::vector<std::byte> window_; ///< bytes from windowPlace_ on
    format::PackedChunkHead head_;
    std::span<const std::byte> bytes_;
};

} // namespace tetra
