// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <string_view>

namespace tetra {

/// A folder of its own for the files of one long piece of work, locked while this object lives. It is removed with its
/// content at the end, unless it is kept for a later one to go on with; when the program is killed it stays.
class TAN_INTERNAL WorkFolder {
public:
    /// What to do with the content of a folder that was left behind.
    enum class Leftovers { Remove, Keep };

    /// Makes the folder or takes over the one that a killed program left. Errors (CannotWrite): another program works
    /// in it; it is a folder of something else, or a link; it cannot be made.
    static Result<WorkFolder> open(const std::filesystem::path& path, Leftovers leftovers);

    /// Removes the work folders in `parent` whose names begin with `start` and that killed programs of this user left.
    /// For those whose names are random, so that nobody ever opens them again.
    static void removeLeft(const std::filesystem::path& parent, std::string_view start);

    ~WorkFolder();
    WorkFolder(WorkFolder&& other) noexcept;
    WorkFolder& operator=(WorkFolder&&) = delete;

    const std::filesystem::path& path() const noexcept { return path_; }
    /// Leaves the folder behind.
    void keep() noexcept { keep_ = true; }

private:
    WorkFolder() = default;

    std::filesystem::path path_; ///< empty if moved from
    std::filesystem::path lockPath_;
    int lock_ = -1;
    bool keep_ = false;
};

/// Bytes that this user can still write on the disk of `path`, which must exist; 0 if the system does not tell.
TAN_INTERNAL std::uint64_t freeDiskBytes(const std::filesystem::path& path);

} // namespace tetra
