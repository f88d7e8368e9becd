// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <memory>

namespace tetra {

/// A file of a volume, opened. Errors: as MappedFile::open(); it is empty.
Result<std::shared_ptr<const MappedFile>> openVolumeFile(const std::filesystem::path& path);

/// An error in the header or in a data file: which of the two is not known to the program.
Error inFile(const std::filesystem::path& path, const Error& error);

/// An error in a data file that was named, with the header whose description it does not fit.
Error withHeader(const std::filesystem::path& header, Error error);

/// An error in `dataFile`, a file of the volume that is opened as `path`; perhaps the same.
Error inVolume(const std::filesystem::path& path, const std::filesystem::path& dataFile, const Error& error);

} // namespace tetra
