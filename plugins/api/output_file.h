// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/written_content.h"

#include <tan/base.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

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

/// The file that a writer fills. It is the program's: it grows beside its target under another name, and takes its
/// place, synced, only when the writer has returned without an error; if not, nothing is left of it. The program also
/// tells how far the writing is, and ends it with an error within a second of being cancelled. So after an error all
/// that a writer does is return it.
class OutputFile {
public:
    virtual ~OutputFile() = default;

    /// Under which the file will be seen. For messages, and for what the name says; not to be opened.
    virtual const std::filesystem::path& target() const = 0;
    /// About how many bytes all files together will have, so that it is known how far the writing is.
    virtual void expect(std::uint64_t bytes) = 0;
    /// Appends.
    virtual Status bytes(std::span<const std::byte> bytes) = 0;
    /// Another file, which appears together with this one, just before it. Lives as long as this one.
    virtual Result<OutputFile*> another(const std::filesystem::path& target) = 0;
    /// Something that the user has to know of the file that was written, in a sentence that names it: "'a.stl' is in
    /// millimetres." Commands and the window tell it once the file is in its place; after an error nobody does.
    virtual void remark(Message sentence) = 0;

    Status text(std::string_view text) { return bytes(std::as_bytes(std::span(text))); }

    /// `count` records of `recordBytes` each, which fill(index, where) writes one after the other.
    template <class Fill> Status records(std::uint64_t count, std::size_t recordBytes, Fill&& fill)
    {
        if (recordBytes == 0)
            return {};
        const std::uint64_t atOnce = std::max<std::uint64_t>(pieceBytes / recordBytes, 1);
        std::vector<std::byte> piece;
        for (std::uint64_t first = 0; first < count; first += atOnce) {
            const std::uint64_t end = std::min(count, first + atOnce);
            piece.resize((end - first) * recordBytes);
            std::byte* where = piece.data();
            for (std::uint64_t index = first; index < end; ++index, where += recordBytes)
                fill(index, where);
            if (const Status written = bytes(piece); !written)
                return written;
        }
        return {};
    }

    /// Records of the vertices of all parts, one part after the other: fill(part, index, where).
    template <class Fill> Status vertexRecords(const SurfaceContent& content, std::size_t recordBytes, Fill&& fill)
    {
        for (const SurfacePart& part : content.parts) {
            const auto record = [&](std::uint64_t index, std::byte* where) { fill(part, index, where); };
            if (const Status written = records(part.positions.size(), recordBytes, record); !written)
                return written;
        }
        return {};
    }

    /// Records of the triangles of all parts, whose vertices are counted through: fill(corners, where), with the
    /// triangle's three corners.
    template <class Fill> Status triangleRecords(const SurfaceContent& content, std::size_t recordBytes, Fill&& fill)
    {
        std::uint64_t firstVertex = 0;
        for (const SurfacePart& part : content.parts) {
            const auto record = [&](std::uint64_t index, std::byte* where) {
                const auto& [a, b, c] = part.triangles[index];
                fill(std::array{firstVertex + a, firstVertex + b, firstVertex + c}, where);
            };
            if (const Status written = records(part.triangles.size(), recordBytes, record); !written)
                return written;
            firstVertex += part.positions.size();
        }
        return {};
    }

private:
    static constexpr std::size_t pieceBytes = 1 << 18;
};

} // namespace tetra
