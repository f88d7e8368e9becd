// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored/stored_volume.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// A format of files: how to know it, and what describes a volume of it.
struct VolumeFormat {
    using Path = std::filesystem::path;

    std::string_view filter; ///< "Text (*.one *.two)", marked
    /// As Reader::score().
    double (*score)(const Path& path, std::span<const std::byte> beginning);
    /// Of the reader's parameters those that say something of such files, besides where they lie.
    std::array<std::string_view, 4> choices;
    /// Without a look at the samples, and placed where the file says. Errors: sentences about "it", or about another
    /// file that they name (Error::file).
    Result<StoredVolume> (*describe)(const VolumeRequest& request);
    /// As Reader::companions(); may be null.
    std::vector<Path> (*companions)(const VolumeRequest& request) = nullptr;
    /// The file with the header, of one that holds samples alone; empty if it is the same. May be null.
    Path (*header)(const Path& path, std::span<const std::byte> beginning) = nullptr;
};

/// All that are read; raw files come last.
std::span<const VolumeFormat> volumeFormats();

/// The one with the highest score, which is told in `score`; null if it is 0 for all.
const VolumeFormat* volumeFormatOf(const std::filesystem::path& path, std::span<const std::byte> beginning,
                                   double& score);

} // namespace tetra
