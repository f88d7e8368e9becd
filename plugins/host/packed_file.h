// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace tetra {

/// Files that were packed as a whole, as "map.ccp4.gz". A reader knows the file that is in them, by its own name and
/// first bytes.

bool isPackedByGzip(std::span<const std::byte> firstBytes) noexcept;

/// The program that unpacks what begins so ("unxz"), of those whose files are not unpacked here; empty for all others.
std::string unpackingProgram(std::span<const std::byte> firstBytes);

/// The path without ".gz": what unpacking it by gzip would leave.
std::filesystem::path unpackedName(const std::filesystem::path& path);

/// The first bytes, as many as readers want to see (input_file.h), of what is in a file packed by gzip. Errors: it is
/// damaged.
Result<Buffer<std::byte>> firstUnpackedBytes(const std::filesystem::path& path);

/// A folder for what is in packed files, each under a name of its own, and for links to files that are not packed. It
/// goes with the last copy of this.
class UnpackedFiles {
public:
    /// An empty one in the system's folder for temporary files (TMPDIR). The errors name `path`, for which it is
    /// wanted.
    static Result<UnpackedFiles> make(const std::filesystem::path& path);

    /// Unpacks a file as long as half of the room there is left. Errors: it is damaged or cut short (the checksums at
    /// its ends are compared); no room. Linear, cancellable, in constant memory.
    Result<std::filesystem::path> unpack(const std::filesystem::path& packed, const std::filesystem::path& name,
                                         const Progress& progress) const;
    /// Makes the file reachable beside the others.
    Result<std::filesystem::path> link(const std::filesystem::path& file, const std::filesystem::path& name) const;

private:
    UnpackedFiles() = default;

    std::filesystem::path path_;
    std::shared_ptr<const void> folder_; ///< removed with the last copy
};

} // namespace tetra
