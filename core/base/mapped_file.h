// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace tetra {

/// A file that is open for reading. Whatever somebody names is opened so: what is not a regular file is refused at
/// once, as opening or reading a pipe, a device or a socket may never end.
class RegularFile {
public:
    /// Errors name the file: one that is missing or not readable, a folder, and what is not a regular file (BadInput);
    /// too many open files (OutOfResource).
    static Result<RegularFile> open(const std::filesystem::path& path);
    ~RegularFile();
    RegularFile(RegularFile&& other) noexcept;
    RegularFile& operator=(RegularFile&&) = delete;

    int descriptor() const noexcept { return descriptor_; }
    std::uint64_t size() const noexcept { return size_; }
    /// Nanoseconds.
    std::int64_t modified() const noexcept { return modified_; }
    /// The descriptor, which the caller closes.
    int release() noexcept;

    /// Its first bytes: `most`, or all if it has fewer.
    Result<std::string> front(std::size_t most) const;

private:
    RegularFile(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_;
    std::uint64_t size_ = 0;
    std::int64_t modified_ = 0;
};

/// "Cannot read 'FILE': REASON".
Error cannotReadFile(const std::filesystem::path& path, const Message& reason);
/// The same of an errno, with what to do.
Error cannotReadFile(const std::filesystem::path& path, int systemError);

/// All of a small file. Errors: as RegularFile's; one of more than `most` bytes.
inline Result<std::string> wholeText(const std::filesystem::path& path, std::size_t most)
{
    const auto file = MappedFile::open(path); // which opens regular files alone, too
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    if (bytes.size() > most)
        return Error{
            ErrorKind::BadInput,
            Message::say("Cannot read '%1': it has more than %2 bytes, too many for such a file.", path.string(), most),
            path};
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

} // namespace tetra
