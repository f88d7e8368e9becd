// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"

#include <tan/base.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

/// A FileWriter for files of many records, that tells how far it is and hears that it should stop after every piece of
/// a quarter of a megabyte.
class TAN_INTERNAL MeshOutput {
public:
    /// `bytes`: about how many there will be. `progress` outlives it.
    static Result<MeshOutput> create(const std::filesystem::path& path, std::uint64_t bytes, const Message& activity,
                                     const Progress& progress);

    Status text(std::string_view text) { return bytes(std::as_bytes(std::span(text))); }
    Status bytes(std::span<const std::byte> bytes);
    /// `count` records of `recordBytes` each, which fill(index, where) writes one after the other.
    template <class Fill> Status records(std::uint64_t count, std::size_t recordBytes, Fill&& fill);
    Status commit() { return file_.commit(); }

private:
    static constexpr std::size_t pieceBytes = 1 << 18;

    MeshOutput(FileWriter file, std::uint64_t bytes, const Message& activity, const Progress& progress)
        : file_(std::move(file)), total_(std::max<std::uint64_t>(bytes, 1)), activity_(activity), progress_(&progress)
    {
    }
    Status piece(std::span<const std::byte> bytes);

    FileWriter file_;
    std::uint64_t total_;
    Message activity_;
    const Progress* progress_;
    std::vector<std::byte> piece_;
};

template <class Fill> Status MeshOutput::records(std::uint64_t count, std::size_t recordBytes, Fill&& fill)
{
    if (recordBytes == 0)
        return {};
    const std::uint64_t atOnce = std::max<std::uint64_t>(pieceBytes / recordBytes, 1);
    for (std::uint64_t first = 0; first < count; first += atOnce) {
        const std::uint64_t end = std::min(count, first + atOnce);
        piece_.resize((end - first) * recordBytes);
        std::byte* where = piece_.data();
        for (std::uint64_t index = first; index < end; ++index, where += recordBytes)
            fill(index, where);
        if (const Status written = piece(piece_); !written)
            return written;
    }
    return {};
}

/// Puts the bytes of a number at `where`, which moves behind them: as they lie in memory, or turned round.
template <class T> void putNumber(std::byte*& where, T number)
{
    std::memcpy(where, &number, sizeof number);
    where += sizeof number;
}
template <class T> void putTurned(std::byte*& where, T number)
{
    std::byte* const begin = where;
    putNumber(where, number);
    std::reverse(begin, where);
}

} // namespace tetra
