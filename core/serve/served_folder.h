// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// An opened file of a served folder. Copies share it.
struct ServedFile {
    std::string name; ///< from the folder on, with '/' between
    std::uint64_t size = 0;
    std::int64_t changed = 0; ///< seconds since 1970
    std::string tag;          ///< of this state of this file: an entity tag, with its quotes
    std::shared_ptr<const int> descriptor;

    /// False if the file has become shorter, or cannot be read.
    bool read(std::uint64_t offset, std::span<char> to) const;
    /// Where it lies now, for what opens files by their path; nothing if another one lies there by now.
    std::optional<std::filesystem::path> path() const;
};

/// A folder whose models others may read: files ending in .tan, in it and in the folders within. What is hidden (a
/// leading dot), what a link leads to outside, and what is no regular file is not there. Safe from any number of
/// threads.
class ServedFolder {
public:
    /// Errors: no folder, or none that may be read.
    static Result<ServedFolder> open(const std::filesystem::path& folder);

    /// A file by its name as decoded from a URL. Nothing for any name that is not one of its files: that it does not
    /// exist, or may not be named. Errors: ErrorKind::OutOfResource, if it cannot be known now.
    Result<std::optional<ServedFile>> find(std::string_view name) const;
    /// The names of its files, sorted; at most so many. Errors as those of find().
    Result<std::vector<std::string>> names(std::size_t most) const;

private:
    std::filesystem::path path_;
    std::shared_ptr<const int> descriptor_;
};

} // namespace tetra
