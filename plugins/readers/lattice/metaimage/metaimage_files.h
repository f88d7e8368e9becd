// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/metaimage/metaimage_header.h"
#include "plugins/readers/lattice/stored/stored_volume.h"

#include <tan/base.h>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// Whether the samples stand behind the header.
bool isLocalMetaImage(const MetaHeader& header);

/// The names of the data files as the header of a MetaImage has them, in the order of the samples: one; or several of
/// equally many samples, 'LIST' with a name in each line below, or a pattern, 'slice%03d.raw 1 100 1'. None if it is
/// local. `text` is the file that begins with the header, `sizes` those of its dimensions. Errors: other numbers of
/// files than the sizes ask for; names that cannot be.
Result<std::vector<std::string>> metaDataFileNames(const MetaHeader& header, std::string_view text,
                                                   std::span<const std::uint64_t> sizes);

/// The same as files beside `path`, the header, or behind it, each of this packing. One that is missing may be there
/// with ".gz" or ".Z", and is packed then. Errors: besides, a file is missing.
Result<std::vector<StoredFile>> metaDataFiles(const MetaHeader& header, std::string_view text,
                                              std::span<const std::uint64_t> sizes, const std::filesystem::path& path,
                                              StoredPacking packing);

} // namespace tetra
