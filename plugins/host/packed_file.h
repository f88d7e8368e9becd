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

/// What is in a file packed by gzip, under its own name in a new folder that goes with the last copy of this.
class UnpackedFile {
public:
    /// Unpacks it into the system's folder for temporary files (TMPDIR), as long as half of the room there is left.
    /// Errors: it is damaged or cut short (the checksums at its ends are compared); no room. Linear, cancellable, in
    /// constant memory.
    static Result<UnpackedFile> unpack(const std::filesystem::path& path, const Progress& progress);

    const std::filesystem::path& path() const noexcept { return path_; }

private:
    UnpackedFile() = default;

    std::filesystem::path path_;
    std::shared_ptr<const void> folder_; ///< removed with the last copy
};

} // namespace tetra
