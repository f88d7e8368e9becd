// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace tetra {

/// A file that appears whole or not at all: written beside its target under a temporary name, synced, and renamed over
/// the target by commit(). An existing target keeps its content until then, and its permissions beyond. A writer that
/// is destroyed before commit() removes what it wrote; what a killed process could not remove, the next writer in that
/// folder does. One thread at a time.
///
/// Every failure is an ErrorKind::CannotWrite that names the target, the system's reason and a remedy, or an
/// OutOfResource if that reason is a lack of memory or descriptors. After the first one every further call gives it
/// again, and commit() changes nothing. A limit of the file size (ulimit -f) is such a failure only in
/// programs that call reportFailedWrites(); it ends others.
class TAN_INTERNAL FileWriter {
public:
    /// What a committed file survives: the end of this program, or a power failure, too.
    enum class Durability { Process, Power };

    /// Refuses a target that is a folder, a device or a read-only file, and a folder that cannot be written in. A
    /// target that is a symbolic link is followed, to a file that is yet to be made, too. The file grows in
    /// `workFolder`, which must be on the target's disk and which its owner clears; without one beside the target.
    static Result<FileWriter> create(const std::filesystem::path& target, std::size_t bufferBytes = 1 << 20,
                                     const std::filesystem::path& workFolder = {});
    ~FileWriter();
    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&& other) noexcept;

    /// Appends.
    Status write(std::span<const std::byte> bytes);
    /// Makes the file `size` bytes long, not less than size(), with zeros, and takes the room on the disk at once if
    /// the file system can.
    Status extend(std::uint64_t size);
    /// Replaces bytes that were written before: [offset, offset + bytes.size()) lies within size().
    Status overwrite(std::uint64_t offset, std::span<const std::byte> bytes);
    /// What was written there: [offset, offset + bytes.size()) lies within size().
    Status read(std::uint64_t offset, std::span<std::byte> bytes);
    /// Syncs the content, renames and syncs the folder. The writer is of no further use.
    Status commit(Durability durability = Durability::Power);

    const std::filesystem::path& target() const noexcept { return target_; }
    /// Bytes appended so far.
    std::uint64_t size() const noexcept { return size_; }

private:
    FileWriter() = default;
    Status flush();
    Status put(std::span<const std::byte> bytes, std::uint64_t offset);
    Status fail(int systemError);
    void close() noexcept;
    void discard() noexcept;

    Status makeTemporary(const std::filesystem::path& workFolder);

    std::filesystem::path target_;
    std::filesystem::path temporary_; ///< empty once renamed or moved from
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    Buffer<std::byte> buffer_; ///< appended, not yet on its way; ends at size_
    std::optional<Error> failure_;
};

/// Writes a file that is in memory already.
TAN_INTERNAL Status writeWholeFile(const std::filesystem::path& target, std::span<const std::byte> content);

/// "Cannot write 'FILE': REASON. REMEDY" of an errno.
Error cannotWriteFile(const std::filesystem::path& target, int systemError);

/// The file that writing to `path` would make or replace: what its symbolic links lead to, whether that exists or not;
/// `path` itself if it is no link, or if its links go round in a circle.
TAN_INTERNAL std::filesystem::path behindLinks(const std::filesystem::path& path);

/// Lets writes into a pipe that nobody reads any more, and beyond a limit of the file size, fail with an error. By
/// default the system ends the process for them (SIGPIPE, SIGXFSZ), and unfinished files stay behind. Process-wide:
/// programs call it first of all.
TAN_INTERNAL void reportFailedWrites() noexcept;

} // namespace tetra
