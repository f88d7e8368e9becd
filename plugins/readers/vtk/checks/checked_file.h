// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// What is known of a file before VTK reads it. VTK believes headers: where data are missing it gives zeros or what was
/// in memory, and takes as much of that as the header asks for. So the files are held against their own headers first.
struct CheckedFile {
    std::uint64_t bytes = 0;         ///< of all files that belong to it
    std::uint64_t unpackedBytes = 0; ///< what they unpack to, as far as headers tell; less than `bytes`: not packed
    std::vector<Message> remarks{};
};

/// How many times more packed data become where nothing tells, at most.
inline constexpr std::uint64_t usualPacking = 20;

/// A file, or a part of it that `what` names ("it", "its data file 'a.raw'"), that ends too early.
inline Error cutShort(const Message& what, std::uint64_t has, std::uint64_t needs)
{
    return {ErrorKind::BadInput,
            Message::say("%1 has %2 bytes, and its header requires %3. It is cut short: copy the file again.", what,
                         has, needs)};
}

/// A header that cannot be right; `what` is a sentence.
inline Error wrongHeader(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("%1 The file is damaged: copy or export it again.", what)};
}

/// A product that stays the largest number where it would be larger than any file: what headers ask for may overflow.
inline std::uint64_t boundedProduct(std::uint64_t a, std::uint64_t b)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 62;
    return b != 0 && a > most / b ? ~std::uint64_t(0) : a * b;
}

inline std::uint64_t boundedSum(std::uint64_t a, std::uint64_t b)
{
    return a > ~std::uint64_t(0) - b ? ~std::uint64_t(0) : a + b;
}

inline std::string nameOf(const std::filesystem::path& path)
{
    return "'" + printable(path.filename().string()) + "'";
}

} // namespace tetra
