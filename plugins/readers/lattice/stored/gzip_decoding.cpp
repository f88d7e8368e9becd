// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored/gzip_decoding.h"

#include <zlib.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tetra {

namespace {

Error damaged(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("its compressed data are damaged (%1). Copy the file again.", what)};
}

/// The unpacked bytes as a stream.
class GzipStream {
public:
    explicit GzipStream(std::span<const std::byte> packed) : rest_(packed), isZlib_(!startsAsGzip(packed))
    {
        constexpr int gzipOnly = 16;
        ready_ = ::inflateInit2(&state_, isZlib_ ? MAX_WBITS : MAX_WBITS + gzipOnly) == Z_OK;
    }
    ~GzipStream() { ::inflateEnd(&state_); }
    GzipStream(const GzipStream&) = delete;
    GzipStream& operator=(const GzipStream&) = delete;

    /// Fills `to`, whose size fits into 32 bits, as far as there are bytes; says how many there were.
    Result<std::size_t> read(std::span<std::byte> to)
    {
        if (!ready_)
            return Error{ErrorKind::OutOfResource,
                         Message::say("Not enough memory to unpack gzip data. Close other programs.")};
        state_.next_out = reinterpret_cast<Bytef*>(to.data());
        state_.avail_out = static_cast<uInt>(to.size());
        while (state_.avail_out > 0 && !ended_)
            if (const Status unpacked = step(); !unpacked)
                return unpacked.error();
        return to.size() - state_.avail_out;
    }

private:
    Status step()
    {
        constexpr std::size_t most = std::size_t(1) << 30;
        const auto given = static_cast<uInt>(std::min(rest_.size(), most));
        state_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(rest_.data()));
        state_.avail_in = given;
        const uInt room = state_.avail_out;
        const int code = ::inflate(&state_, Z_NO_FLUSH);
        rest_ = rest_.subspan(given - state_.avail_in);
        if (code == Z_STREAM_END)
            return nextMember();
        if (code == Z_MEM_ERROR)
            return Error{ErrorKind::OutOfResource,
                         Message::say("Not enough memory to unpack gzip data. Close other programs.")};
        if (code != Z_OK && code != Z_BUF_ERROR)
            return damaged(state_.msg != nullptr ? Message(state_.msg) : Message(code));
        if (rest_.empty() && state_.avail_out == room)
            return damaged(Message::say("they are cut short"));
        return {};
    }

    static bool startsAsGzip(std::span<const std::byte> packed)
    {
        return packed.size() > 2 && packed[0] == std::byte(0x1f) && packed[1] == std::byte(0x8b);
    }

    Status nextMember()
    {
        if (isZlib_ || std::ranges::all_of(rest_, [](std::byte byte) { return byte == std::byte(0); }))
            ended_ = true;
        else if (::inflateReset(&state_) != Z_OK)
            return damaged(Message::say("another part cannot be started"));
        return {};
    }

    std::span<const std::byte> rest_;
    z_stream state_{};
    bool isZlib_ = false;
    bool ready_ = false;
    bool ended_ = false;
};

Error wrongSize(std::uint64_t expected, std::uint64_t found, bool more)
{
    return {ErrorKind::BadInput,
            more ? Message::say("its compressed data hold more than %1 bytes where the description requires %2. The "
                                "sizes or the type are wrong, or the data belong to another file.",
                                found, expected)
                 : Message::say("its compressed data hold only %1 bytes where the description requires %2. The sizes "
                                "or the type are wrong, or the data belong to another file.",
                                found, expected)};
}

} // namespace

Status unpackPart(std::span<const std::byte> packed, std::uint64_t skip, std::span<std::byte> content,
                  std::uint64_t behind, const Progress& progress)
{
    GzipStream stream(packed);
    constexpr std::uint64_t pieceBytes = std::uint64_t(1) << 20;
    std::vector<std::byte> passed(std::min(std::max(skip, behind), pieceBytes));
    const std::uint64_t contentEnd = skip + content.size(), total = contentEnd + behind;
    const auto next = [&](std::uint64_t done) {
        if (done < skip)
            return std::span(passed).first(std::min(skip - done, pieceBytes));
        return done < contentEnd ? content.subspan(done - skip, std::min(contentEnd - done, pieceBytes))
                                 : std::span(passed).first(std::min(total - done, pieceBytes));
    };
    for (std::uint64_t done = 0; done < total;) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        const std::span<std::byte> piece = next(done);
        const Result<std::size_t> read = stream.read(piece);
        if (!read)
            return read.error();
        done += *read;
        if (*read < piece.size())
            return wrongSize(total, done, false);
        progress.report(static_cast<double>(done) / static_cast<double>(total), Message::marked("Reading"));
    }
    std::byte beyond{};
    const Result<std::size_t> more = stream.read({&beyond, 1});
    if (!more)
        return more.error();
    return *more > 0 ? Status(wrongSize(total, total, true)) : Status();
}

} // namespace tetra
