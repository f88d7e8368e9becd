// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tetra {

enum class ImagesFormat : std::uint8_t { None, Dicom, Tiff };

/// What a file is taken for, and how surely (0 to 1): from its name, and from the signature in its first bytes.
struct ImagesGuess {
    ImagesFormat format = ImagesFormat::None;
    double score = 0;
};

ImagesGuess guessImagesFormat(const std::filesystem::path& path, std::span<const std::byte> firstBytes);

/// Name filters of the formats, for the open dialog.
std::vector<std::string> imagesNameFilters();

} // namespace tetra
