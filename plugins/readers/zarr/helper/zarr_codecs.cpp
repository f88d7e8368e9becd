// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_codecs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

namespace tetra {
namespace {

using Bytes = std::span<const std::byte>;

Error damagedChunk(const Message& how)
{
    return {ErrorKind::BadInput, Message::say("it is damaged: %1. Copy or export it again.", how)};
}

Error unpacksToMore(std::uint64_t most)
{
    return damagedChunk(Message::say("it unpacks to more than the expected %1 bytes", most));
}

/// The most bytes that a codec can make of so many.
std::uint64_t mostPacked(const ZarrCodec& codec, std::uint64_t bytes)
{
    constexpr std::uint64_t ends = std::uint64_t(1) << 16U, checksum = 4;
    switch (codec.kind) {
    case ZarrCodec::Kind::Checksum: return bytes + checksum;
    case ZarrCodec::Kind::Shuffle:
    case ZarrCodec::Kind::Delta: return bytes;
    default: return bytes + bytes / 8 + ends;
    }
}

/// zlib takes no more than 4 GB at once.
void feed(z_stream& stream, Bytes& rest, std::byte*& to, std::uint64_t& room)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 30U;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(rest.data()));
    stream.avail_in = static_cast<uInt>(std::min<std::uint64_t>(rest.size(), most));
    stream.next_out = reinterpret_cast<Bytef*>(to);
    stream.avail_out = static_cast<uInt>(std::min(room, most));
}

/// All members of a gzip file, or a stream of zlib, up to `most` bytes.
Status inflateInto(Bytes packed, bool isGzip, std::uint64_t most, Buffer<std::byte>& to)
{
    constexpr int withZlibHeader = 15, withGzipHeader = 15 + 16;
    z_stream stream{};
    if (inflateInit2(&stream, isGzip ? withGzipHeader : withZlibHeader) != Z_OK)
        throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> closing(&stream, inflateEnd);
    to.resize(most + 1); // one more than there may be, so that what is too much shows
    std::byte* end = to.data();
    std::uint64_t room = most + 1;
    for (int state = Z_OK;;) {
        feed(stream, packed, end, room);
        const auto given = stream.avail_in, space = stream.avail_out;
        state = inflate(&stream, Z_NO_FLUSH);
        packed = packed.subspan(given - stream.avail_in);
        room -= space - stream.avail_out;
        end += space - stream.avail_out;
        if (state == Z_MEM_ERROR)
            throw std::bad_alloc();
        const bool isStuck = given == stream.avail_in && space == stream.avail_out;
        if (state == Z_STREAM_END) {
            const bool hasAnother =
                isGzip && packed.size() > 2 && packed[0] == std::byte(0x1f) && packed[1] == std::byte(0x8b);
            if (!hasAnother)
                break;
            inflateReset(&stream);
        } else if (room == 0 && (state == Z_OK || state == Z_BUF_ERROR)) {
            return unpacksToMore(most);
        } else if ((state != Z_OK && state != Z_BUF_ERROR) || isStuck) {
            return damagedChunk(state == Z_OK || state == Z_BUF_ERROR ? Message::say("it is cut short")
                                                                      : Message::say("it cannot be unpacked"));
        }
    }
    to.resize(most + 1 - room);
    if (room == 0)
        return unpacksToMore(most);
    return {};
}

Status unpackZstandard(Bytes packed, std::uint64_t most, Buffer<std::byte>& to)
{
    to.resize(most);
    const std::size_t size = ZSTD_decompress(to.data(), to.size(), packed.data(), packed.size());
    if (ZSTD_isError(size) != 0)
        return damagedChunk(Message::say("Zstandard says '%1'", std::string(ZSTD_getErrorName(size))));
    to.resize(size);
    return {};
}

Status unpackBlosc(Bytes packed, std::uint64_t most, Buffer<std::byte>& to)
{
    std::size_t size = 0;
    if (blosc_cbuffer_validate(packed.data(), packed.size(), &size) != 0)
        return damagedChunk(Message::say("it does not begin like Blosc data, or is cut short"));
    if (size > most)
        return damagedChunk(Message::say("it unpacks to %1 bytes, more than the expected %2", size, most));
    to.resize(size);
    const int unpacked = blosc_decompress_ctx(packed.data(), to.data(), to.size(), 1);
    if (unpacked < 0 || static_cast<std::size_t>(unpacked) != size)
        return damagedChunk(Message::say("Blosc cannot unpack it (%1)", unpacked));
    return {};
}

Status removeChecksum(Bytes packed, Buffer<std::byte>& to)
{
    constexpr std::size_t length = 4;
    if (packed.size() < length)
        return damagedChunk(Message::say("it is cut short"));
    const Bytes content = packed.first(packed.size() - length);
    std::uint32_t said = 0;
    for (std::size_t byte = 0; byte < length; ++byte)
        said |= std::to_integer<std::uint32_t>(packed[content.size() + byte]) << 8 * byte;
    if (castagnoliChecksum(content) != said)
        return damagedChunk(Message::say("its checksum is wrong"));
    to.assign(content.begin(), content.end());
    return {};
}

/// Back from all first bytes, all second ones ...; what is left over of the last element stays at the end.
void unshuffle(Bytes packed, std::size_t elementSize, Buffer<std::byte>& to)
{
    to.resize(packed.size());
    const std::size_t count = packed.size() / elementSize;
    for (std::size_t byte = 0; byte < elementSize; ++byte)
        for (std::size_t element = 0; element < count; ++element)
            to[element * elementSize + byte] = packed[byte * count + element];
    std::ranges::copy(packed.subspan(count * elementSize),
                      to.begin() + static_cast<std::ptrdiff_t>(count * elementSize));
}

template <class T> T swappedIf(bool isSwapped, T value)
{
    auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    if (isSwapped)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

/// Sums of differences: whole numbers modulo their size, floating point numbers rounded each time as NumPy does.
template <class T> void sumUp(Bytes packed, bool isSwapped, Buffer<std::byte>& to)
{
    to.assign(packed.begin(), packed.end());
    T sum{};
    for (std::size_t at = 0; at + sizeof(T) <= to.size(); at += sizeof(T)) {
        T value{};
        std::memcpy(&value, to.data() + at, sizeof value);
        sum = static_cast<T>(sum + swappedIf(isSwapped, value));
        value = swappedIf(isSwapped, sum);
        std::memcpy(to.data() + at, &value, sizeof value);
    }
}

Status undoDelta(Bytes packed, const ZarrCodec& codec, Buffer<std::byte>& to)
{
    const bool isSwapped = codec.isBigEndian != (std::endian::native == std::endian::big);
    switch (codec.number) {
    case ZarrNumber::UInt8:
    case ZarrNumber::Int8: sumUp<std::uint8_t>(packed, false, to); break;
    case ZarrNumber::UInt16:
    case ZarrNumber::Int16: sumUp<std::uint16_t>(packed, isSwapped, to); break;
    case ZarrNumber::UInt32:
    case ZarrNumber::Int32: sumUp<std::uint32_t>(packed, isSwapped, to); break;
    case ZarrNumber::UInt64:
    case ZarrNumber::Int64: sumUp<std::uint64_t>(packed, isSwapped, to); break;
    case ZarrNumber::Float32: sumUp<float>(packed, isSwapped, to); break;
    case ZarrNumber::Float64: sumUp<double>(packed, isSwapped, to); break;
    case ZarrNumber::Float16:
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its differences of numbers of 16 bits (the filter 'delta') are not read. Write it without them.")};
    }
    return {};
}

Status undo(const ZarrCodec& codec, Bytes packed, std::uint64_t most, Buffer<std::byte>& to)
{
    switch (codec.kind) {
    case ZarrCodec::Kind::Zlib: return inflateInto(packed, false, most, to);
    case ZarrCodec::Kind::Gzip: return inflateInto(packed, true, most, to);
    case ZarrCodec::Kind::Zstd: return unpackZstandard(packed, most, to);
    case ZarrCodec::Kind::Blosc: return unpackBlosc(packed, most, to);
    case ZarrCodec::Kind::Checksum: return removeChecksum(packed, to);
    case ZarrCodec::Kind::Shuffle: unshuffle(packed, codec.elementSize, to); return {};
    case ZarrCodec::Kind::Delta: break;
    }
    return undoDelta(packed, codec, to);
}

} // namespace

Result<Bytes> ChunkUnpacking::unpack(Bytes packed, std::span<const ZarrCodec> codecs, std::uint64_t expected)
{
    std::vector<std::uint64_t> most{expected}; // bytes before each codec, and at the end those of the file
    for (const ZarrCodec& codec : codecs)
        most.push_back(mostPacked(codec, most.back()));
    if (packed.size() > most.back())
        return damagedChunk(
            Message::say("it has %1 bytes, more than its %2 bytes of numbers can yield", packed.size(), expected));
    Bytes bytes = packed;
    for (std::size_t left = codecs.size(); left-- > 0; std::swap(one_, other_)) {
        if (const Status undone = undo(codecs[left], bytes, most[left], one_); !undone)
            return undone.error();
        bytes = one_; // moved to the other when the next is made: its bytes stay where they are
    }
    if (bytes.size() != expected)
        return damagedChunk(Message::say("it has %1 bytes of numbers instead of %2", bytes.size(), expected));
    return bytes;
}

std::uint32_t castagnoliChecksum(Bytes bytes) noexcept
{
    constexpr std::uint32_t polynomial = 0x82f63b78;
    constexpr auto table = [] {
        std::array<std::uint32_t, 256> all{};
        for (std::uint32_t byte = 0; byte < all.size(); ++byte) {
            std::uint32_t rest = byte;
            for (int bit = 0; bit < 8; ++bit)
                rest = (rest & 1U) != 0 ? rest >> 1U ^ polynomial : rest >> 1U;
            all[byte] = rest;
        }
        return all;
    }();
    std::uint32_t rest = ~std::uint32_t(0);
    for (const std::byte byte : bytes)
        rest = table[(rest ^ std::to_integer<std::uint32_t>(byte)) & 0xffU] ^ rest >> 8U;
    return ~rest;
}

} // namespace tetra
