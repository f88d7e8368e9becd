// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace tetra {

/// A file of a cache folder that is in use: nobody removes it while this lives. Move-only.
class TAN_INTERNAL CachedFile {
public:
    ~CachedFile();
    CachedFile(CachedFile&& other) noexcept;
    CachedFile& operator=(CachedFile&& other) noexcept;

    const std::filesystem::path& path() const noexcept { return path_; }
    /// Open for reading and writing.
    int descriptor() const noexcept { return descriptor_; }

private:
    friend class CacheFolder;
    CachedFile(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_ = -1; ///< holds a shared lock
};

/// A folder of files that can be made again: parts of models that came over the network, models that were unpacked.
/// They take no more than a limit together; for a new one those go that were not used for longest, and never one that
/// is in use. Any number of programs and threads may use the same folder at once; copies are cheap.
///
/// In it lie files with names of 32 hexadecimal digits, and beside them `.making` and `.lock` while one is made.
/// Nothing else in the folder is touched. When a file was last used is its time of access; its time of modification
/// stays, so that a MappedFile of it is not taken for damaged.
///
/// What lies there is taken for what this user put there. So the folder has to be this user's, others may not write in
/// it, nor put another folder in its place, which who owns a folder above it can, and who can write in one that is not
/// sticky.
///
/// Errors are CannotWrite, or OutOfResource for a lack of memory or descriptors.
class TAN_INTERNAL CacheFolder {
public:
    static constexpr std::uint64_t defaultLimit = std::uint64_t(8) << 30;

    /// $XDG_CACHE_HOME/tan or ~/.cache/tan, with the limit that the environment gives in TAN_CACHE_MB (megabytes of
    /// 10^6 bytes), or else defaultLimit.
    static Result<CacheFolder> standard();
    /// That limit. Errors: WrongUsage for what is not a number of megabytes.
    static Result<std::uint64_t> standardLimit();
    /// Makes the folder, for this user alone, if it is not there. Errors: it cannot be made or written in, or others
    /// can.
    static Result<CacheFolder> open(const std::filesystem::path& path, std::uint64_t limitBytes = defaultLimit);

    /// Makes the file `path`, by any way of writing; removes nothing. What a failed one leaves is removed.
    using Maker = std::function<Status(const std::filesystem::path& path, const Progress& progress)>;

    /// The file that `key` stands for, any text: as it is, or made now. `make` runs in one program at a time for a key,
    /// others wait for it; and what it makes appears whole or not at all. `expectedBytes` is what a file claims of
    /// itself: nothing is removed for it. What would not fit even if all went that is not in use is refused; else room
    /// is made as the file grows, and on a full disk a part of what is missing at a time, `make` being called again.
    /// Keys are told apart by 128 bits of a sum that guards against chance, not against intent: where strangers choose
    /// the keys, the file itself says which one it is of. Errors: those of `make`, no room, cancelled (also while
    /// waiting).
    Result<CachedFile> take(std::string_view key, std::uint64_t expectedBytes, const Maker& make,
                            const Progress& progress = {}) const;
    /// The same if it is there.
    std::optional<CachedFile> find(std::string_view key) const;

    /// Removes what was unused for longest, until `bytes` more fit under the limit and on the disk. An error if they do
    /// not; for what would not fit into an empty folder nothing is removed. O(files of the folder).
    Status makeRoom(std::uint64_t bytes) const;
    /// An error if makeRoom() could not succeed. Removes nothing.
    Status checkRoom(std::uint64_t bytes) const;
    /// Removes all that is not in use.
    void clear() const;
    /// What its files take on the disk.
    std::uint64_t bytes() const;

    const std::filesystem::path& path() const noexcept { return path_; }
    std::uint64_t limit() const noexcept { return limit_; }

private:
    CacheFolder(std::filesystem::path path, std::uint64_t limit) : path_(std::move(path)), limit_(limit) {}
    Status makeAsItGrows(const std::filesystem::path& making, std::uint64_t expectedBytes, const Maker& make,
                         const Progress& progress) const;
    bool fitsDisk(std::uint64_t bytes, std::uint64_t removed) const;
    bool removeSome(std::uint64_t bytes) const;
    Error noRoom(std::uint64_t bytes) const;

    std::filesystem::path path_;
    std::uint64_t limit_ = defaultLimit;
};

} // namespace tetra
