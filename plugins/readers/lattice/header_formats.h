// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/stored_volume.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The formats whose headers describe a StoredVolume.
enum class HeaderFormat : std::uint8_t { None, MetaImage, Nifti, Mrc };

/// What a file is by the bytes that it begins with; a header of Analyze has little to know it by but its name.
HeaderFormat formatBySignature(const std::filesystem::path& path, std::span<const std::byte> firstBytes);
HeaderFormat formatByName(const std::filesystem::path& path);

/// The header beside the samples "head.img" of a pair; empty if there is none.
std::filesystem::path pairedHeader(const std::filesystem::path& path);

/// The file with the header, open: the one that the user opened, or the header of a pair whose samples that is.
struct HeaderFile {
    HeaderFormat format = HeaderFormat::None;
    std::filesystem::path path;
    std::shared_ptr<const MappedFile> file;
};

/// Nothing if the file is of none of these formats, by its beginning, its name or the header beside it.
Result<std::optional<HeaderFile>> headerFileOf(const std::filesystem::path& path,
                                               const std::shared_ptr<const MappedFile>& file);

/// What it says. Errors: sentences about "it".
Result<StoredVolume> describedVolume(const HeaderFile& header, const VolumeChoice& choice);

/// Reader::companions() of these formats: the other file of a pair, or the data file of a MetaImage. Of samples
/// "head.img" the header may be packed, so that nothing is known of it yet.
std::vector<std::filesystem::path> headerCompanions(const std::filesystem::path& path, std::span<const std::byte> file);

} // namespace tetra
