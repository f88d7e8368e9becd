// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tetra {

/// Whether a file of this name says what the folder is in which it lies: an array or a group of Zarr.
bool isZarrMetadataName(const std::filesystem::path& path);

/// Whether it is a folder with such a file.
bool isZarrFolder(const std::filesystem::path& path);

/// The folder of an array or a group that is opened by its folder or by its metadata: absolute, without a slash at the
/// end; empty if it is neither.
std::filesystem::path zarrRootOf(const std::filesystem::path& path);

} // namespace tetra
