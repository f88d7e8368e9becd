// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/gzip_encoding.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

namespace tetra {

namespace {

constexpr std::size_t pieceBytes = std::size_t(1) << 20;

/// Owns what zlib allocates.
struct Packer {
    Packer()
    {
        constexpr int gzipOnly = 16;
        constexpr int usualMemory = 8;
        ready = ::deflateInit2(&state, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzipOnly, usualMemory,
                               Z_DEFAULT_STRATEGY) == Z_OK;
    }
    ~Packer() { ::deflateEnd(&state); }
    Packer(const Packer&) = delete;
    Packer& operator=(const Packer&) = delete;

    z_stream state{};
    bool ready = false;
};

/// Packs what `packer` was given and writes all that comes out.
Status pack(Packer& packer, int flush, std::span<std::byte> room, FileWriter& file)
{
    do {
        packer.state.next_out = reinterpret_cast<Bytef*>(room.data());
        packer.state.avail_out = static_cast<uInt>(room.size());
        ::deflate(&packer.state, flush);
        if (const Status written = file.write(room.first(room.size() - packer.state.avail_out)); !written)
            return written;
    } while (packer.state.avail_out == 0);
    return {};
}

} // namespace

Status writeGzip(std::span<const std::byte> content, FileWriter& file, const Progress& progress)
{
    Packer packer;
    if (!packer.ready)
        return Error{ErrorKind::OutOfResource,
                     Message::say("Not enough memory to compress the data. Close other programs.")};
    std::vector<std::byte> room(pieceBytes);
    for (std::size_t done = 0; done < content.size();) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Writing"));
        const std::size_t piece = std::min(pieceBytes, content.size() - done);
        packer.state.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(content.data() + done));
        packer.state.avail_in = static_cast<uInt>(piece);
        if (const Status packed = pack(packer, Z_NO_FLUSH, room, file); !packed)
            return packed;
        done += piece;
        progress.report(static_cast<double>(done) / static_cast<double>(content.size()), Message::marked("Writing"));
    }
    return pack(packer, Z_FINISH, room, file);
}

} // namespace tetra
