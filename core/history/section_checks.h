// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/checksum.h"
#include "core/history/file_layout.h"
#include "core/history/format.h"
#include "core/history/number_limits.h"

#include <tan/base.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace tetra {

/// The checksums of a section that is written piece by piece: of all of it, and of each of its chunks. Members that
/// take bytes may throw std::bad_alloc.
class SectionSums {
public:
    void add(std::span<const std::byte> bytes);
    std::uint64_t ofWhole() const noexcept { return whole_.value(); }
    /// Of everything added so far; the last chunk may be a short one.
    std::vector<std::uint64_t> ofChunks() const;

private:
    Checksum whole_;
    Checksum chunk_;
    std::uint64_t inChunk_ = 0; ///< bytes of the chunk that is not full yet
    std::vector<std::uint64_t> full_;
};

/// What the section ChunkSums holds, of all sections before it in the table.
class ChunkSums {
public:
    ChunkSums() : elements_{format::chunkBytes} {}

    void append(const SectionSums& sums);
    std::span<const std::byte> bytes() const noexcept { return std::as_bytes(std::span(elements_)); }

private:
    std::vector<std::uint64_t> elements_;
};

/// Finds out whether what is read of a model's sections is what was written there, and whether it can be: numbers have
/// limits (number_limits.h). A file with checksums of chunks is
/// checked where it is read, each chunk once, in whatever thread reads it first. Of an older file, whose sums are of
/// whole sections, all is read once by a thread of low priority, from the beginning on. Damage that was found stays
/// known. Safe to use from any number of threads.
class SectionChecks {
public:
    /// Reads the chunks' checksums, or starts the thread. Errors: damaged checksums.
    static Result<std::unique_ptr<const SectionChecks>> make(std::shared_ptr<const MappedFile> file,
                                                             const FileLayout& layout);
    /// Stops the thread, within milliseconds where the disk can be read.
    ~SectionChecks();
    SectionChecks(const SectionChecks&) = delete;
    SectionChecks& operator=(const SectionChecks&) = delete;

    /// Checks the chunks of a part of one section, on several threads if they are many. False if any damage is known,
    /// there or elsewhere. What was checked before costs a look at a bit of each chunk.
    bool check(std::span<const std::byte> part) const noexcept;
    /// Waits for the thread, and helps it. Errors: damage, cancelled.
    Status finish(const Progress& progress) const;
    /// An Error that names the file, the section and what is wrong there if damage is known.
    Status damage() const;

private:
    struct Watched {
        std::uint32_t id = 0;
        NumberLimits limits;
        std::span<const std::byte> bytes;
        std::uint64_t sum = 0;                 ///< of the whole
        std::span<const std::uint64_t> chunks; ///< theirs, if there are any
        /// A bit for each chunk: whether a thread has set about checking it, and whether it has done so.
        std::unique_ptr<std::atomic<std::uint64_t>[]> begun;
        std::unique_ptr<std::atomic<std::uint64_t>[]> done;
    };

    SectionChecks(std::shared_ptr<const MappedFile> file, const FileLayout& layout);
    Status readChunkSums(const FileLayout& layout);
    void startThread();
    const Watched& sectionOf(const std::byte* place) const noexcept;
    bool isDone(const Watched& section, std::uint64_t first, std::uint64_t end) const noexcept;
    void checkChunks(const Watched& section, std::uint64_t first, std::uint64_t end) const noexcept;
    void checkChunk(const Watched& section, std::uint64_t chunk) const noexcept;
    void checkNumbers(const Watched& section, std::uint64_t offset, std::span<const std::byte> part) const noexcept;
    bool goOn() const noexcept;

    std::shared_ptr<const MappedFile> file_;
    std::vector<Watched> sections_; ///< in the order of their places
    int chunkBits_ = 0;             ///< chunks are of 2^chunkBits_ bytes; 0: there are no sums of chunks
    mutable std::atomic<std::uint32_t> damaged_ = 0; ///< the id of a section that is, or 0 ...
    mutable std::atomic<bool> isImpossible_ = false; ///< ... and whether that is its numbers, not its checksum

    /// What the thread does, piece by piece.
    mutable std::mutex mutex_;
    mutable std::size_t section_ = 0; ///< guarded, as are the next two: the one that is being read
    mutable std::uint64_t read_ = 0;  ///< of its bytes
    mutable Checksum sum_;
    mutable std::atomic<std::uint64_t> readInAll_ = 0;
    std::jthread thread_;
};

} // namespace tetra
