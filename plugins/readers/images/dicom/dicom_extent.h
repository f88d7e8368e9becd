// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tetra {

/// How far the elements of a DICOM file reach, up to its pixels.
struct DicomExtent {
    /// All of them lie in the file: GDCM, as Debian builds it, ends the program where one does not. What is no DICOM
    /// file has none; of deflated ones only those before them are looked at.
    bool isWhole = true;
    std::optional<std::size_t> deflatedAt; ///< where the deflated ones begin
};

DicomExtent dicomExtent(std::string_view bytes);

/// Whether what zlib has deflated, without a head, unpacks to at most so many bytes, or is damaged before. Takes the
/// time of unpacking, and no memory.
bool unpacksWithin(std::string_view deflated, std::uint64_t mostBytes);

} // namespace tetra
