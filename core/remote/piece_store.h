// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/byte_source.h"
#include "core/remote/cache_folder.h"

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// Those pieces of a file that are there already, in a sparse file of a cache folder, with a checksum each: what a disk
/// damaged, or a program that was killed left half written, counts as not there. Any number of threads and programs may
/// use the same one at once; two that write a piece write the same.
///
/// The file: magic, size of the original, length of the key, checksum of what comes before and the key; the key; at a
/// multiple of 4096 the checksums of the pieces, 0 for one that is not there; at a multiple of 16384 the pieces.
class TAN_INTERNAL PieceStore {
public:
    static constexpr std::uint64_t pieceBytes = 16 << 10;

    /// The store of what `key` stands for, of `size` bytes; one that does not fit is replaced. A `temporary` one is
    /// nobody else's, and removed at the end.
    static Result<std::shared_ptr<PieceStore>> open(const CacheFolder& folder, std::string_view key, std::uint64_t size,
                                                    bool temporary, const Progress& progress);
    ~PieceStore();
    PieceStore(const PieceStore&) = delete;
    PieceStore& operator=(const PieceStore&) = delete;

    std::uint64_t size() const noexcept { return size_; }
    std::uint64_t pieces() const noexcept { return (size_ + pieceBytes - 1) / pieceBytes; }
    ByteRange rangeOf(std::uint64_t piece) const noexcept;

    /// Which of the pieces that `ranges` touch are not there, ascending; not whether those that are there are sound.
    std::vector<std::uint64_t> missing(std::span<const ByteRange> ranges) const;
    /// Reads a piece into `to`, as long as rangeOf() it; false if it is not there or damaged.
    bool read(std::uint64_t piece, std::span<std::byte> to) const;
    /// Keeps a piece, as long as rangeOf() it. Errors: no room under the limit, or on the disk.
    Status write(std::uint64_t piece, std::span<const std::byte> bytes);
    /// From here on no piece is there.
    void clear();

private:
    PieceStore(const CacheFolder& folder, CachedFile file) : folder_(folder), file_(std::move(file)) {}
    Status put(std::span<const std::byte> bytes, std::uint64_t offset);

    CacheFolder folder_;
    CachedFile file_;
    std::uint64_t size_ = 0;
    std::uint64_t sumsAt_ = 0, piecesAt_ = 0;
    bool temporary_ = false;
    std::mutex growing_;
    std::uint64_t room_ = 0; ///< bytes that may be written before room is asked for again
};

} // namespace tetra
