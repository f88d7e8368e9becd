// SPDX-License-Identifier: GPL-3.0-or-later
// The format: DICOM PS3.5 (data structures and encoding) and PS3.10 (files).
#include "plugins/readers/images/dicom/dicom_extent.h"

#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

namespace tetra {
namespace {

std::uint64_t numberAt(std::string_view bytes, std::size_t place, std::size_t size, bool isBig)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[place + (isBig ? i : size - 1 - i)]);
    return value;
}

/// Whether `kind` is one of the words of two letters in `kinds`.
bool isKindAmong(std::string_view kind, std::string_view kinds)
{
    return kind.find(' ') == std::string_view::npos && kinds.find(kind) != std::string_view::npos;
}

} // namespace

DicomExtent dicomExtent(std::string_view bytes)
{
    constexpr std::string_view shortKinds = "AW AE AS CS UI DA DS DT IS LO LT PN ST TM SH FL SL AT UL US SS FD";
    constexpr std::string_view longKinds = "OB OW UN SQ OD OF OL OV UC UR UT SV UV";
    constexpr std::uint64_t undefined = 0xffffffff, pixels = 0x7fe00010, syntax = 0x00020010;
    constexpr std::size_t preamble = 128;
    std::size_t at = bytes.starts_with("DICM") ? 4 : bytes.substr(0, preamble + 4).ends_with("DICM") ? preamble + 4 : 0;
    constexpr DicomExtent cut{.isWhole = false, .deflatedAt = {}};
    bool isBigFile = false, isImplicit = false, isDeflated = false;
    while (at < bytes.size()) {
        if (isDeflated && numberAt(bytes, at, 1, false) != 2) // behind the first group
            return {.isWhole = true, .deflatedAt = at};
        if (bytes.size() - at < 8)
            return cut;
        const bool isBig = isBigFile && numberAt(bytes, at, 2, false) != 2; // the first group is always little-endian
        const std::uint64_t tag = numberAt(bytes, at, 2, isBig) << 16U | numberAt(bytes, at + 2, 2, isBig);
        const bool hasKind = tag >> 16U != 0xfffe && (!isImplicit || tag >> 16U == 2); // items have none
        const std::string_view kind = hasKind ? bytes.substr(at + 4, 2) : std::string_view("  ");
        std::uint64_t length = 0;
        if (isKindAmong(kind, longKinds)) {
            if (bytes.size() - at < 12)
                return cut;
            length = numberAt(bytes, at + 8, 4, isBig);
            at += 12;
        } else {
            const bool isShort = isKindAmong(kind, shortKinds);
            length = isShort ? numberAt(bytes, at + 6, 2, isBig) : numberAt(bytes, at + 4, 4, isBig);
            at += 8;
        }
        if (tag == pixels)
            return {};           // they are looked at by themselves
        if (length == undefined) // what it holds comes next
            continue;
        if (length > bytes.size() - at)
            return cut;
        const std::string_view value = bytes.substr(at, length);
        if (tag == syntax) {
            isDeflated = value.starts_with("1.2.840.10008.1.2.1.99");
            isBigFile = value.starts_with("1.2.840.10008.1.2.2");
            isImplicit = value.substr(0, value.find_last_not_of(std::string_view(" \0", 2)) + 1) == "1.2.840.10008.1.2";
        }
        at += length;
    }
    return {};
}

bool unpacksWithin(std::string_view deflated, std::uint64_t mostBytes)
{
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        throw std::bad_alloc();
    std::array<Bytef, 1U << 16U> unpacked{};
    std::uint64_t bytes = 0;
    int state = Z_OK;
    while (state == Z_OK && bytes <= mostBytes) {
        if (stream.avail_in == 0 && !deflated.empty()) {
            const auto next = std::min<std::size_t>(deflated.size(), std::numeric_limits<uInt>::max());
            stream.next_in = reinterpret_cast<const Bytef*>(deflated.data());
            stream.avail_in = static_cast<uInt>(next);
            deflated.remove_prefix(next);
        }
        stream.next_out = unpacked.data();
        stream.avail_out = unpacked.size();
        state = inflate(&stream, Z_NO_FLUSH); // without progress not Z_OK
        bytes += unpacked.size() - stream.avail_out;
    }
    inflateEnd(&stream);
    return bytes <= mostBytes;
}

} // namespace tetra
