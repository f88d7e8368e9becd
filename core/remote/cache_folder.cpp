// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/cache_folder.h"

#include "core/base/checksum.h"
#include "core/base/folder.h"
#include "core/base/guarded.h"
#include "core/base/system_error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

constexpr std::string_view makingEnding = ".making";
constexpr std::string_view lockEnding = ".lock";
constexpr std::size_t nameDigits = 32;

Error cannotUse(const std::filesystem::path& folder, int systemError)
{
    const bool isLack = isLackOfResources(systemError);
    const Message remedy = isLack ? Message(resourceRemedy)
                           : systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG
                               ? diskRemedy(systemError)
                               : Message::say("Set XDG_CACHE_HOME to a folder that can be written to.");
    return {isLack ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
            Message::say("Cannot use the cache folder '%1': %2. %3", folder.string(), systemErrorText(systemError),
                         remedy)};
}

/// Of `folder`, by what is wrong with `place`, which is that or above it.
Error cannotTrust(const std::filesystem::path& folder, const Message& what)
{
    return {ErrorKind::CannotWrite,
            Message::say("Cannot use the cache folder '%1': %2. Set XDG_CACHE_HOME to a folder that only you can use.",
                         folder.string(), what)};
}

/// Whether nobody but this user can put files into a folder or another one in its place. The system's own folders are
/// the superuser's, whom some containers show under another number.
Status checkTrust(const std::filesystem::path& folder)
{
    struct stat root {
    }, status{};
    const bool isKnown = ::stat("/", &root) == 0 && ::stat(folder.c_str(), &status) == 0;
    if (!isKnown)
        return cannotUse(folder, errno);
    const uid_t user = ::geteuid();
    if (status.st_uid != user)
        return cannotTrust(folder, Message::say("it belongs to another user"));
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
        return cannotTrust(folder, Message::say("others can write to it"));
    // As the path goes, and where its links lead.
    std::error_code problem;
    for (const std::filesystem::path& path :
         {std::filesystem::absolute(folder, problem), std::filesystem::canonical(folder, problem)})
        for (std::filesystem::path above = path.parent_path(); !above.empty(); above = above.parent_path()) {
            if (::stat(above.c_str(), &status) != 0)
                return cannotUse(folder, errno);
            if (status.st_uid != user && status.st_uid != 0 && status.st_uid != root.st_uid)
                return cannotTrust(folder, Message::say("'%1' belongs to another user", above.string()));
            if ((status.st_mode & S_IWOTH) != 0 && (status.st_mode & S_ISVTX) == 0)
                return cannotTrust(folder, Message::say("everybody can write to '%1'", above.string()));
            if (above == above.root_path())
                break;
        }
    return {};
}

std::string nameOf(std::string_view key)
{
    constexpr std::string_view digits = "0123456789abcdef";
    const auto half = [&](std::string_view salt) {
        Checksum sum;
        sum.add(std::as_bytes(std::span(salt)));
        sum.add(std::as_bytes(std::span(key)));
        return sum.value();
    };
    std::string name;
    for (std::uint64_t sum : {half("first"), half("second")})
        for (std::size_t digit = 0; digit < nameDigits / 2; ++digit, sum <<= 4)
            name += digits[sum >> 60];
    return name;
}

/// Whether it is the name of a file, or with one of the endings.
bool isOurName(std::string_view name, std::string_view ending = {})
{
    return name.size() == nameDigits + ending.size() && name.ends_with(ending) &&
           name.find_first_not_of("0123456789abcdef") >= nameDigits;
}

std::filesystem::path with(const std::filesystem::path& path, std::string_view ending)
{
    return std::filesystem::path(path).concat(ending);
}

/// An open file, closed at the end.
class OpenFile {
public:
    OpenFile(const std::filesystem::path& path, int flags)
        : descriptor_(::open(path.c_str(), flags | O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0600))
    {
    }
    ~OpenFile()
    {
        if (descriptor_ >= 0)
            ::close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    explicit operator bool() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }
    int release() { return std::exchange(descriptor_, -1); }

private:
    int descriptor_;
};

/// Marks the file as used now.
void touch(int descriptor)
{
    const std::array<timespec, 2> times = {timespec{0, UTIME_NOW}, timespec{0, UTIME_OMIT}};
    ::futimens(descriptor, times.data());
}

/// Whether it is a file of this user, and no more than a file.
bool isOwnFile(int descriptor)
{
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
}

/// Whether a program has it open that took it from the folder.
bool isInUse(const std::filesystem::path& path)
{
    const OpenFile file(path, 0);
    return file && lockFile(file.descriptor(), path) == FileLock::Busy;
}

/// Removes a file that nobody uses; one that cannot be locked may be in use.
bool removeUnused(const std::filesystem::path& path)
{
    const OpenFile file(path, 0);
    return file && lockFile(file.descriptor(), path) == FileLock::Taken && ::unlink(path.c_str()) == 0;
}

struct Entry {
    std::filesystem::path path;
    std::uint64_t bytes = 0;
    timespec used{};
    bool isFile = false; ///< not one that is being made
};

std::vector<Entry> entriesOf(const std::filesystem::path& folder)
{
    std::vector<Entry> entries;
    std::error_code ignored;
    for (std::filesystem::path& path : pathsIn(folder, ignored)) {
        const std::string name = path.filename().string();
        if (!isOurName(name.substr(0, nameDigits)))
            continue;
        struct stat status {};
        if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
            continue;
        entries.push_back({std::move(path), std::uint64_t(status.st_blocks) * 512, status.st_atim, isOurName(name)});
    }
    return entries;
}

std::uint64_t bytesOf(std::span<const Entry> entries)
{
    std::uint64_t bytes = 0;
    for (const Entry& entry : entries)
        bytes += entry.bytes;
    return bytes;
}

/// Removes what killed programs left of files that they were making; nothing of those that live.
void removeUnfinished(std::span<const Entry> entries)
{
    for (const Entry& entry : entries) {
        if (!entry.path.native().ends_with(lockEnding))
            continue;
        const OpenFile lock(entry.path, 0);
        if (!lock || lockFile(lock.descriptor(), entry.path) != FileLock::Taken)
            continue;
        std::filesystem::path making = entry.path;
        ::unlink(making.replace_extension(makingEnding).c_str());
        ::unlink(entry.path.c_str());
    }
}

/// Those that nobody makes any more, the ones first that were unused for longest.
std::vector<Entry> oldestFirst(const std::filesystem::path& folder)
{
    std::vector<Entry> entries = entriesOf(folder);
    removeUnfinished(entries);
    entries = entriesOf(folder);
    std::ranges::sort(entries, {}, [](const Entry& entry) { return std::pair(entry.used.tv_sec, entry.used.tv_nsec); });
    return entries;
}

constexpr MarkedText noMemoryToLook =
    Message::marked("Not enough memory to read the cache folder '%1'. Close other programs.");
constexpr auto beforeNextLook = std::chrono::milliseconds(20);

} // namespace

CachedFile::~CachedFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

CachedFile::CachedFile(CachedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1))
{
}

CachedFile& CachedFile::operator=(CachedFile&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

Result<std::uint64_t> CacheFolder::standardLimit()
{
    const char* const given = std::getenv("TAN_CACHE_MB");
    if (given == nullptr || *given == '\0')
        return defaultLimit;
    const std::optional<std::uint64_t> megabytes = parseNumber<std::uint64_t>(given);
    if (!megabytes || *megabytes > 1'000'000'000'000)
        return Error{ErrorKind::WrongUsage,
                     Message::say("TAN_CACHE_MB is '%1'. Give the maximum size of the cache folder in megabytes.",
                                  printable(given))};
    return *megabytes * 1'000'000;
}

Result<CacheFolder> CacheFolder::standard()
{
    const Result<std::uint64_t> standardBytes = standardLimit();
    if (!standardBytes)
        return standardBytes.error();
    const std::uint64_t limit = *standardBytes;
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && std::filesystem::path(cache).is_absolute()) // a relative one does not count
        return open(std::filesystem::path(cache) / "tan", limit);
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') {
        const passwd* const user = ::getpwuid(::geteuid());
        home = user == nullptr ? nullptr : user->pw_dir;
    }
    if (home == nullptr || *home == '\0')
        return Error{
            ErrorKind::CannotWrite,
            Message::say(
                "There is no cache folder, because this user has no home folder. Set XDG_CACHE_HOME to a folder.")};
    return open(std::filesystem::path(home) / ".cache" / "tan", limit);
}

Result<CacheFolder> CacheFolder::open(const std::filesystem::path& path, std::uint64_t limitBytes)
{
    std::error_code problem;
    std::filesystem::create_directories(path.parent_path(), problem);
    if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST)
        return cannotUse(path, errno);
    if (!std::filesystem::is_directory(path, problem))
        return cannotUse(path, ENOTDIR);
    if (::access(path.c_str(), R_OK | W_OK | X_OK) != 0)
        return cannotUse(path, errno);
    if (const Status trusted = checkTrust(path); !trusted)
        return trusted.error();
    return CacheFolder(path, limitBytes);
}

std::optional<CachedFile> CacheFolder::find(std::string_view key) const
{
    std::filesystem::path path = path_ / nameOf(key);
    OpenFile file(path, 0);
    if (!file || !isOwnFile(file.descriptor()))
        return {};
    const FileLock lock = lockFile(file.descriptor(), path, LockKind::Shared);
    if (lock == FileLock::Busy || lock == FileLock::Gone) // somebody removes it
        return {};
    touch(file.descriptor());
    return CachedFile(std::move(path), file.release());
}

Result<CachedFile> CacheFolder::take(std::string_view key, std::uint64_t expectedBytes, const Maker& make,
                                     const Progress& progress) const
{
    const std::filesystem::path path = path_ / nameOf(key);
    const std::filesystem::path making = with(path, makingEnding);
    const std::filesystem::path lockPath = with(path, lockEnding);
    for (;; std::this_thread::sleep_for(beforeNextLook)) {
        if (progress.cancelled())
            return cancelledError(Message::say("Waiting for a file of the cache folder"));
        if (std::optional<CachedFile> found = find(key))
            return std::move(*found);
        const OpenFile lock(lockPath, O_CREAT);
        if (!lock)
            return cannotUse(path_, errno);
        const FileLock locked = lockFile(lock.descriptor(), lockPath);
        if (locked == FileLock::Busy || locked == FileLock::Gone)
            continue; // another makes it, or has just made it
        // From here on only this call makes the file, wherever the file system can lock.
        const auto finish = [&] {
            ::unlink(making.c_str());
            ::unlink(lockPath.c_str());
        };
        if (const OpenFile file(path, 0); file || errno != ENOENT) { // made since it was looked for, or being removed
            int systemError = file ? 0 : errno;
            if (file && !isOwnFile(file.descriptor())) // a pipe, a device, another user's: the cache made none of these
                systemError = EEXIST;
            ::unlink(lockPath.c_str());
            if (systemError != 0)
                return cannotUse(path_, systemError);
            continue;
        }
        ::unlink(making.c_str()); // by a program that was killed
        Status made = checkRoom(expectedBytes);
        if (made)
            made = makeAsItGrows(making, expectedBytes, make, progress);
        if (made) // the file counts by now, whatever it was expected to take
            made = makeRoom(0);
        if (!made) {
            finish();
            return made.error();
        }
        OpenFile file(making, 0);
        int systemError = file ? 0 : errno;
        if (file) {
            // The lock that keeps it comes before the name by which others could find and remove it.
            lockFile(file.descriptor(), making, LockKind::Shared);
            touch(file.descriptor());
            systemError = ::rename(making.c_str(), path.c_str()) == 0 ? 0 : errno;
        }
        finish();
        if (systemError != 0)
            return cannotUse(path_, systemError);
        return CachedFile(path, file.release());
    }
}

/// Where the system does not tell how much the disk has, writing will.
bool CacheFolder::fitsDisk(std::uint64_t bytes, std::uint64_t removed) const
{
    std::error_code problem;
    const auto space = std::filesystem::space(path_, problem);
    return problem || space.available >= bytes || bytes - space.available <= removed;
}

Error CacheFolder::noRoom(std::uint64_t bytes) const
{
    return {ErrorKind::CannotWrite, Message::say("The cache folder '%1' has no room for %2 more: its limit is %3, and "
                                                 "files in use are kept. Set TAN_CACHE_MB to more megabytes.",
                                                 path_.string(), neededBytesText(bytes), neededBytesText(limit_))};
}

Status CacheFolder::checkRoom(std::uint64_t bytes) const
{
    const auto work = [&]() -> Status {
        if (bytes > limit_)
            return noRoom(bytes);
        const std::vector<Entry> entries = entriesOf(path_);
        const std::uint64_t taken = bytesOf(entries);
        if (!fitsDisk(bytes, taken))
            return cannotUse(path_, ENOSPC);
        if (taken <= limit_ - bytes)
            return {};
        std::uint64_t used = 0;
        for (const Entry& entry : entries)
            used += entry.isFile && isInUse(entry.path) ? entry.bytes : 0;
        return used <= limit_ - bytes ? Status() : noRoom(bytes);
    };
    return guarded(noMemoryToLook, work, path_.native());
}

/// As the file grows, others go for what it takes by then; on a disk that is full, for a bit more each time.
Status CacheFolder::makeAsItGrows(const std::filesystem::path& making, std::uint64_t expectedBytes, const Maker& make,
                                  const Progress& progress) const
{
    using Clock = std::chrono::steady_clock;
    constexpr auto betweenLooks = std::chrono::milliseconds(200);
    constexpr std::uint64_t firstStep = 16 << 20;
    std::mutex looking;
    // Guarded by it:
    Clock::time_point next = Clock::now() + betweenLooks;
    std::stop_source tooMuch;
    std::optional<Error> refusal;
    const auto watch = [&](double fraction, const Message& activity) {
        progress.report(fraction, activity);
        const std::unique_lock lock(looking, std::try_to_lock);
        if (!lock || Clock::now() < next)
            return;
        if (const Status fits = makeRoom(0); !fits) {
            refusal = fits.error();
            tooMuch.request_stop();
        }
        next = Clock::now() + betweenLooks;
    };
    for (std::uint64_t step = firstStep;; step *= 2) {
        Status made = make(making, progress.withCallback(watch).alsoCancelledBy(tooMuch.get_token()));
        if (!made && refusal)
            return *refusal;
        const bool mayBeFull = !made && made.error().kind == ErrorKind::CannotWrite && !fitsDisk(expectedBytes, 0);
        if (!mayBeFull || !removeSome(step))
            return made;
        ::unlink(making.c_str());
    }
}

/// False if nothing could be removed.
bool CacheFolder::removeSome(std::uint64_t bytes) const
{
    std::uint64_t removed = 0;
    const auto work = [&]() -> Status {
        for (const Entry& entry : oldestFirst(path_))
            if (removed < bytes && entry.isFile && removeUnused(entry.path))
                removed += std::max<std::uint64_t>(entry.bytes, 1);
        return {};
    };
    (void)guarded(noMemoryToLook, work, path_.native());
    return removed > 0;
}

Status CacheFolder::makeRoom(std::uint64_t bytes) const
{
    const auto work = [&]() -> Status {
        std::uint64_t taken = bytesOf(entriesOf(path_));
        const auto fits = [&] { return bytes <= limit_ && taken <= limit_ - bytes && fitsDisk(bytes, 0); };
        if (fits())
            return {};
        // For what would not fit into an empty folder nothing is removed.
        if (bytes > limit_)
            return noRoom(bytes);
        if (!fitsDisk(bytes, taken))
            return cannotUse(path_, ENOSPC);
        const std::vector<Entry> entries = oldestFirst(path_);
        taken = bytesOf(entries);
        std::uint64_t made = 0; // by programs that live, this one included: stays
        for (const Entry& entry : entries)
            made += entry.isFile ? 0 : entry.bytes;
        if (made > limit_ - bytes)
            return noRoom(std::max(bytes, made - std::min(made, limit_)));
        for (const Entry& entry : entries) {
            if (fits())
                return {};
            if (entry.isFile && removeUnused(entry.path))
                taken -= entry.bytes;
        }
        if (taken > limit_ - bytes)
            return noRoom(std::max(bytes, taken - std::min(taken, limit_)));
        return fitsDisk(bytes, 0) ? Status() : cannotUse(path_, ENOSPC);
    };
    return guarded(noMemoryToLook, work, path_.native());
}

void CacheFolder::clear() const
{
    const std::vector<Entry> entries = entriesOf(path_);
    removeUnfinished(entries);
    for (const Entry& entry : entries)
        if (entry.isFile)
            removeUnused(entry.path);
}

std::uint64_t CacheFolder::bytes() const
{
    return bytesOf(entriesOf(path_));
}

} // namespace tetra
