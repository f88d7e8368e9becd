// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_writer.h"

#include "core/base/finished_file.h"
#include "core/base/folder.h"
#include "core/base/guarded.h"
#include "core/base/positioned_io.h"
#include "core/base/system_error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

/// Between the name of the target and the rest of a temporary name stand so many random hexadecimal digits.
constexpr std::size_t randomDigits = 8;
constexpr std::string_view hexadecimalDigits = "0123456789abcdef";
constexpr std::string_view temporaryEnding = ".partial";

Message remedy(int systemError, const std::filesystem::path& folder)
{
    switch (systemError) {
    case ENOENT: return Message::say("The folder '%1' does not exist: create it or choose another.", folder.string());
    case ENOTDIR: return Message::say("'%1' is not a folder: choose another.", folder.string());
    case EISDIR: return Message::say("Name a file in it.");
    case EACCES:
    case EPERM: return Message::say("Choose another folder, or change the permissions of this one.");
    case EROFS: return Message::say("Choose a folder on a disk that can be written.");
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return diskRemedy(systemError);
    case ENAMETOOLONG: return Message::say("Choose a shorter name.");
    default: return isLackOfResources(systemError) ? resourceRemedy : Message::say("Choose another folder or disk.");
    }
}

Error cannotWrite(const std::filesystem::path& target, const Message& reason, const Message& whatToDo)
{
    return {ErrorKind::CannotWrite, Message::say("Cannot write '%1': %2. %3", target.string(), reason, whatToDo)};
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
Status checkTargetAndMode(const std::filesystem::path& target, std::optional<mode_t>& mode)
{
    struct stat existing {};
    if (::stat(target.c_str(), &existing) != 0) {
        if (errno == ENOENT)
            return {};
        return cannotWriteFile(target, errno);
    }
    if (S_ISDIR(existing.st_mode))
        return cannotWriteFile(target, EISDIR);
    if (!S_ISREG(existing.st_mode))
        return cannotWrite(target, Message::say("it is not a regular file"), Message::say("Choose another name."));
    // A rename would replace a read-only file, and the superuser may write any: neither is what its owner meant.
    if ((existing.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(target.c_str(), W_OK) != 0)
        return cannotWrite(target, Message::say("the file is read-only"),
                           Message::say("Choose another name, or make it writable."));
    mode = existing.st_mode & 07777;
    return {};
}

/// Some file systems have no permissions to keep: then what they give is all there is.
Status keepMode(int descriptor, const std::optional<mode_t>& mode, const std::filesystem::path& target)
{
    if (mode && ::fchmod(descriptor, *mode) != 0 && errno != EPERM && errno != ENOTSUP)
        return cannotWriteFile(target, errno);
    return {};
}

std::filesystem::path temporaryName(const std::filesystem::path& target, const std::filesystem::path& workFolder)
{
    constexpr std::size_t longestKept = 200; // leaves room for the rest within the usual limit of 255
    std::random_device random;
    std::string digits;
    for (std::uint32_t bits = random(); digits.size() < randomDigits; bits /= 16)
        digits += hexadecimalDigits[bits % 16];
    std::string name = ".";
    name.append(target.filename().string(), 0, longestKept).append(".").append(digits).append(temporaryEnding);
    return (workFolder.empty() ? target.parent_path() : workFolder) / name;
}

/// Whether temporaryName() could have made it, for any target.
bool isTemporaryName(std::string_view name)
{
    constexpr std::size_t rest = 1 + randomDigits + temporaryEnding.size(); // with the dot before the digits
    if (name.size() < rest + 2 || name.front() != '.' || !name.ends_with(temporaryEnding) ||
        name[name.size() - rest] != '.')
        return false;
    const std::string_view digits = name.substr(name.size() - rest + 1, randomDigits);
    return digits.find_first_not_of(hexadecimalDigits) == std::string_view::npos;
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

Error cannotWriteFile(const std::filesystem::path& target, int systemError)
{
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    Error error = cannotWrite(target, systemErrorText(systemError), remedy(systemError, folder));
    if (isLackOfResources(systemError))
        error.kind = ErrorKind::OutOfResource;
    return error;
}

Result<FileWriter> FileWriter::create(const std::filesystem::path& target, std::size_t bufferBytes,
                                      const std::filesystem::path& workFolder)
{
    FileWriter writer;
    writer.target_ = behindLinks(target);
    if (writer.target_.empty() || !writer.target_.has_filename())
        return cannotWrite(target, Message::say("it does not name a file"), Message::say("Name a file."));
    std::optional<mode_t> mode;
    if (const Status possible = checkTargetAndMode(writer.target_, mode); !possible)
        return possible.error();
    if (workFolder.empty())
        removeLeftFiles(writer.target_.parent_path(), isTemporaryName);
    if (const Status made = writer.makeTemporary(workFolder); !made)
        return made.error();
    if (const Status kept = keepMode(writer.descriptor_, mode, writer.target_); !kept)
        return kept.error();
    const auto takeBuffer = [&]() -> Status {
        writer.buffer_.reserve(std::max<std::size_t>(bufferBytes, 1));
        return {};
    };
    const Status buffered =
        guarded(Message::marked("Not enough memory to write '%1'. Close other programs."), takeBuffer, target.native());
    if (!buffered)
        return buffered.error();
    return writer;
}

/// The lock says for as long as it is held that this process lives: others leave the file alone.
Status FileWriter::makeTemporary(const std::filesystem::path& workFolder)
{
    for (;;) {
        temporary_ = temporaryName(target_, workFolder);
        descriptor_ =
            uninterrupted([&] { return ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
        if (descriptor_ < 0) {
            const int systemError = errno;
            temporary_.clear();
            if (systemError == EEXIST)
                continue;
            return cannotWriteFile(target_, systemError);
        }
        const FileLock lock = lockFile(descriptor_, temporary_);
        if (lock == FileLock::Taken || lock == FileLock::Impossible)
            return {};
        // Another process has found it before it was locked, takes it for left behind and removes it.
        temporary_.clear();
        close();
    }
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

Status FileWriter::read(std::uint64_t offset, std::span<std::byte> bytes)
{
    assert(offset <= size_ && bytes.size() <= size_ - offset);
    if (const Status flushed = flush(); !flushed)
        return flushed;
    const int problem = readFully(descriptor_, offset, bytes);
    return problem == 0 ? Status() : fail(problem);
}

Status FileWriter::commit(Durability durability)
{
    if (const Status flushed = flush(); !flushed)
        return flushed;
    const bool sync = durability == Durability::Power;
    if (sync && uninterrupted([&] { return ::fsync(descriptor_); }) != 0)
        return fail(errno);
    // Network file systems may report a full disk only when a file is closed. Its lock goes with the last descriptor,
    // and without the lock it would be taken for left behind.
    const int locked = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
    if (locked < 0)
        return fail(errno);
    const bool closed = ::close(std::exchange(descriptor_, locked)) == 0 || errno == EINTR;
    if (!closed || ::rename(temporary_.c_str(), target_.c_str()) != 0)
        return fail(errno);
    temporary_.clear();
    close();
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
    const int problem = writeFully(descriptor_, offset, bytes);
    return problem == 0 ? Status() : fail(problem);
}

Status FileWriter::fail(int systemError)
{
    failure_ = cannotWriteFile(target_, systemError);
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
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
    temporary_.clear();
    close();
}

Status writeWholeFile(const std::filesystem::path& target, std::span<const std::byte> content)
{
    Result<FileWriter> file = FileWriter::create(target);
    if (!file)
        return file.error();
    if (const Status written = file->write(content); !written)
        return written;
    return file->commit();
}

Status checkTarget(const std::filesystem::path& target)
{
    std::optional<mode_t> mode;
    return checkTargetAndMode(behindLinks(target), mode);
}

Status replaceFile(const std::filesystem::path& made, const std::filesystem::path& target)
{
    const std::filesystem::path behind = behindLinks(target);
    std::optional<mode_t> mode;
    if (const Status possible = checkTargetAndMode(behind, mode); !possible)
        return possible;
    const int descriptor = ::open(made.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0)
        return cannotWriteFile(behind, errno);
    Status done = keepMode(descriptor, mode, behind);
    if (done && uninterrupted([&] { return ::fsync(descriptor); }) != 0)
        done = cannotWriteFile(behind, errno);
    ::close(descriptor);
    if (done && ::rename(made.c_str(), behind.c_str()) != 0)
        done = cannotWriteFile(behind, errno);
    if (!done)
        return done;
    const int problem = syncFolder(behind.parent_path());
    return problem == 0 ? Status() : cannotWriteFile(behind, problem);
}

std::filesystem::path behindLinks(const std::filesystem::path& path)
{
    constexpr int mostLinks = 40; // as the system's own
    std::filesystem::path found = path;
    std::error_code problem;
    for (int link = 0; std::filesystem::is_symlink(found, problem); ++link) {
        if (link == mostLinks)
            return path;
        const std::filesystem::path leadsTo = std::filesystem::read_symlink(found, problem);
        if (problem)
            return path;
        found = found.parent_path() / leadsTo; // leadsTo alone if it is absolute
    }
    return found;
}

void reportFailedWrites() noexcept
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace tetra
