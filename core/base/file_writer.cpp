// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_writer.h"

#include "core/base/system_error.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

std::string remedy(int systemError, const std::filesystem::path& folder)
{
    switch (systemError) {
    case ENOENT: return "The folder '" + folder.string() + "' does not exist: create it or choose another.";
    case ENOTDIR: return "'" + folder.string() + "' is not a folder: choose another.";
    case EISDIR: return "It is a folder: name a file in it.";
    case EACCES:
    case EPERM: return "Choose another folder, or change the permissions of this one.";
    case EROFS: return "Choose a folder on a disk that can be written.";
    case ENOSPC:
    case EDQUOT: return "Free some space or choose another disk.";
    case EFBIG: return "Choose a disk that allows larger files, or raise the limit (ulimit -f).";
    case ENAMETOOLONG: return "Choose a shorter name.";
    default: return "Choose another folder or disk.";
    }
}

Error cannotWrite(const std::filesystem::path& target, const std::string& reason, const std::string& whatToDo)
{
    return {ErrorKind::CannotWrite, "Cannot write '" + target.string() + "': " + reason + ". " + whatToDo};
}

Error cannotWrite(const std::filesystem::path& target, int systemError)
{
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    return cannotWrite(target, systemErrorText(systemError), remedy(systemError, folder));
}

/// Calls a system function again for as long as a signal interrupts it.
template <class Function> auto uninterrupted(Function&& function)
{
    auto result = function();
    while (result == -1 && errno == EINTR)
        result = function();
    return result;
}

/// What `target` is now: nothing, or a regular file that may be replaced. Its mode goes to `mode`.
Status checkTarget(const std::filesystem::path& target, std::optional<mode_t>& mode)
{
    struct stat existing {};
    if (::stat(target.c_str(), &existing) != 0) {
        if (errno == ENOENT)
            return {};
        return cannotWrite(target, errno);
    }
    if (S_ISDIR(existing.st_mode))
        return cannotWrite(target, EISDIR);
    if (!S_ISREG(existing.st_mode))
        return cannotWrite(target, "it is not a regular file", "Choose another name.");
    // A rename would replace a read-only file, and the superuser may write any: neither is what its owner meant.
    if ((existing.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(target.c_str(), W_OK) != 0)
        return cannotWrite(target, "the file is read-only", "Choose another name, or make it writable.");
    mode = existing.st_mode & 07777;
    return {};
}

std::filesystem::path temporaryName(const std::filesystem::path& target, const std::filesystem::path& workFolder)
{
    constexpr std::size_t longestKept = 200; // leaves room for the rest within the usual limit of 255
    std::random_device random;
    char digits[8];
    const auto end = std::to_chars(digits, digits + sizeof digits, random(), 16).ptr;
    const std::string name = target.filename().string().substr(0, longestKept);
    return (workFolder.empty() ? target.parent_path() : workFolder) /
           ("." + name + "." + std::string(digits, end) + ".partial");
}

/// Makes the rename survive a power failure. File systems that cannot sync a folder say so and are believed.
int syncFolder(const std::filesystem::path& folder)
{
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return errno == EACCES ? 0 : errno; // a folder that may be written but not read
    const int result = uninterrupted([&] { return ::fsync(descriptor); }) == 0 ? 0 : errno;
    ::close(descriptor);
    return result == EINVAL || result == EROFS ? 0 : result;
}

} // namespace

Result<FileWriter> FileWriter::create(const std::filesystem::path& target, std::size_t bufferBytes,
                                      const std::filesystem::path& workFolder)
{
    FileWriter writer;
    std::error_code ignored;
    const bool isLink = std::filesystem::is_symlink(target, ignored);
    writer.target_ = isLink ? std::filesystem::weakly_canonical(target, ignored) : target;
    if (writer.target_.empty() || !writer.target_.has_filename())
        return cannotWrite(target, "it does not name a file", "Name a file.");
    std::optional<mode_t> mode;
    if (const Status possible = checkTarget(writer.target_, mode); !possible)
        return possible.error();
    do {
        writer.temporary_ = temporaryName(writer.target_, workFolder);
        writer.descriptor_ = uninterrupted(
            [&] { return ::open(writer.temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
    } while (writer.descriptor_ < 0 && errno == EEXIST);
    if (writer.descriptor_ < 0) {
        writer.temporary_.clear();
        return cannotWrite(writer.target_, errno);
    }
    // Some file systems have no permissions to keep: then what they give is all there is.
    if (mode && ::fchmod(writer.descriptor_, *mode) != 0 && errno != EPERM && errno != ENOTSUP)
        return cannotWrite(writer.target_, errno);
    try {
        writer.buffer_.reserve(std::max<std::size_t>(bufferBytes, 1));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to write '" + target.string() + "'."};
    }
    return writer;
}

FileWriter::~FileWriter()
{
    discard();
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_), buffer_(std::move(other.buffer_)),
      failure_(std::move(other.failure_))
{
}

FileWriter& FileWriter::operator=(FileWriter&& other) noexcept
{
    if (this != &other) {
        discard();
        target_ = std::move(other.target_);
        temporary_ = std::exchange(other.temporary_, {});
        descriptor_ = std::exchange(other.descriptor_, -1);
        size_ = other.size_;
        buffer_ = std::move(other.buffer_);
        failure_ = std::move(other.failure_);
    }
    return *this;
}

Status FileWriter::write(std::span<const std::byte> bytes)
{
    if (failure_)
        return *failure_;
    if (bytes.size() > buffer_.capacity() - buffer_.size()) {
        if (const Status flushed = flush(); !flushed)
            return flushed;
    }
    if (bytes.size() < buffer_.capacity())
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    else if (const Status written = put(bytes, size_); !written)
        return written;
    size_ += bytes.size();
    return {};
}

Status FileWriter::overwrite(std::uint64_t offset, std::span<const std::byte> bytes)
{
    assert(offset <= size_ && bytes.size() <= size_ - offset);
    if (const Status flushed = flush(); !flushed)
        return flushed;
    return put(bytes, offset);
}

Status FileWriter::extend(std::uint64_t size)
{
    assert(size >= size_);
    if (const Status flushed = flush(); !flushed)
        return flushed;
    const auto length = static_cast<off_t>(size);
    if (uninterrupted([&] { return ::fallocate(descriptor_, 0, 0, length); }) != 0 &&
        (errno != EOPNOTSUPP || uninterrupted([&] { return ::ftruncate(descriptor_, length); }) != 0))
        return fail(errno);
    size_ = size;
    return {};
}

Status FileWriter::commit(Durability durability)
{
    if (const Status flushed = flush(); !flushed)
        return flushed;
    const bool sync = durability == Durability::Power;
    if (sync && uninterrupted([&] { return ::fsync(descriptor_); }) != 0)
        return fail(errno);
    // Network file systems may report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR)
        return fail(errno);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0)
        return fail(errno);
    temporary_.clear();
    if (const int systemError = sync ? syncFolder(target_.parent_path()) : 0; systemError != 0)
        return fail(systemError);
    return {};
}

Status FileWriter::flush()
{
    if (failure_)
        return *failure_;
    const Status written = put(buffer_, size_ - buffer_.size());
    if (written)
        buffer_.clear();
    return written;
}

Status FileWriter::put(std::span<const std::byte> bytes, std::uint64_t offset)
{
    while (!bytes.empty()) {
        const ssize_t written = uninterrupted(
            [&] { return ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset)); });
        if (written < 0)
            return fail(errno);
        if (written == 0)
            return fail(ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
    return {};
}

Status FileWriter::fail(int systemError)
{
    failure_ = cannotWrite(target_, systemError);
    discard(); // a full disk gets its space back at once
    return *failure_;
}

void FileWriter::close() noexcept
{
    if (descriptor_ >= 0)
        ::close(std::exchange(descriptor_, -1));
}

void FileWriter::discard() noexcept
{
    close();
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
    temporary_.clear();
}

} // namespace tetra
