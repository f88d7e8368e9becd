// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mapped_file.h"

#include "core/base/memory.h"
#include "core/base/text.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

constexpr std::uintptr_t noAddress = std::numeric_limits<std::uintptr_t>::max();

/// One guarded mapping. `begin` is written last and taken back first, so that the handler never matches half an entry.
struct GuardedRange {
    std::atomic<bool> taken{false};
    std::atomic<std::uintptr_t> begin{noAddress};
    std::atomic<std::uintptr_t> end{0};
    std::atomic<bool> damaged{false};
};
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

constexpr int capacity = 1024;
constinit GuardedRange table[capacity];
struct sigaction previousAction {};
std::uintptr_t pageMask = 0; ///< set before the handler is installed

/// Puts zero pages where the file has gone. Only async-signal-safe things happen here (mmap is a bare system call).
bool replaceByZeros(std::uintptr_t address) noexcept
{
    for (GuardedRange& entry : table) {
        const std::uintptr_t begin = entry.begin.load(std::memory_order_acquire);
        const std::uintptr_t end = entry.end.load(std::memory_order_acquire);
        if (address < begin || address >= end || entry.begin.load(std::memory_order_acquire) != begin)
            continue;
        const std::uintptr_t page = address & pageMask;
        entry.damaged.store(true, std::memory_order_release);
        void* const zeros = ::mmap(reinterpret_cast<void*>(page), end - page, PROT_READ,
                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
        return zeros != MAP_FAILED;
    }
    return false;
}

void passOn(int signal, siginfo_t* information, void* context)
{
    if (previousAction.sa_flags & SA_RESETHAND) // it counts on being called once: a second error ends the program
        ::signal(signal, SIG_DFL);
    if (previousAction.sa_flags & SA_SIGINFO) {
        previousAction.sa_sigaction(signal, information, context);
        return;
    }
    const bool sentByAProcess = information->si_code <= 0;
    if (previousAction.sa_handler == SIG_IGN && sentByAProcess)
        return;
    if (previousAction.sa_handler != SIG_DFL && previousAction.sa_handler != SIG_IGN) {
        previousAction.sa_handler(signal);
        return;
    }
    // The default: returning repeats the access that failed, which now ends the program as it would have.
    ::signal(signal, SIG_DFL);
    if (sentByAProcess)
        ::raise(signal);
}

void handleBusError(int signal, siginfo_t* information, void* context)
{
    const int systemError = errno;
    if (information->si_code <= 0 || !replaceByZeros(reinterpret_cast<std::uintptr_t>(information->si_addr)))
        passOn(signal, information, context);
    errno = systemError;
}

void installHandler()
{
    static std::once_flag installed;
    std::call_once(installed, [] {
        pageMask = ~(static_cast<std::uintptr_t>(pageSize()) - 1);
        struct sigaction action {};
        action.sa_sigaction = handleBusError;
        action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(SIGBUS, &action, &previousAction);
    });
}

// Which mappings there are and which of them are damaged. The functions are thread-safe.

/// Guards `mapping`, page-aligned and not empty, until unguardMapping(). Returns its index, or -1 if the table is full.
int guardMapping(std::span<const std::byte> mapping)
{
    installHandler();
    for (int index = 0; index < capacity; ++index) {
        GuardedRange& entry = table[index];
        bool taken = false;
        if (!entry.taken.compare_exchange_strong(taken, true))
            continue;
        const auto begin = reinterpret_cast<std::uintptr_t>(mapping.data());
        entry.damaged.store(false, std::memory_order_relaxed);
        entry.end.store(begin + mapping.size(), std::memory_order_release);
        entry.begin.store(begin, std::memory_order_release);
        return index;
    }
    return -1;
}

/// No thread may still be reading the mapping. Comes before munmap.
void unguardMapping(int index) noexcept
{
    table[index].begin.store(noAddress, std::memory_order_release);
    table[index].end.store(0, std::memory_order_release);
    table[index].taken.store(false, std::memory_order_release);
}

/// True if a read in the mapping found no file behind it.
bool isMappingDamaged(int index) noexcept
{
    return table[index].damaged.load(std::memory_order_acquire);
}

} // namespace

Error cannotReadFile(const std::filesystem::path& path, const Message& reason)
{
    return {ErrorKind::BadInput, Message::say("Cannot read '%1': %2", visibleText(path.string()), reason), path};
}

Error cannotReadFile(const std::filesystem::path& path, int systemError)
{
    const Message reason = systemErrorText(systemError);
    if (isLackOfResources(systemError))
        return {ErrorKind::OutOfResource, cannotReadFile(path, Message::say("%1. %2", reason, resourceRemedy)).message,
                path};
    switch (systemError) {
    case ENOENT: return cannotReadFile(path, Message::say("%1. Check its name and folder.", reason));
    case EACCES: return cannotReadFile(path, Message::say("%1. Ask its owner for permission to read it.", reason));
    // A socket, and a device without a driver.
    case ENXIO:
    case ENODEV:
        return cannotReadFile(path, Message::say("it is not a regular file. Copy its content into one first."));
    default: return cannotReadFile(path, Message::say("%1.", reason));
    }
}

Result<RegularFile> RegularFile::open(const std::filesystem::path& path)
{
    // Without O_NONBLOCK a pipe would make open() wait for a writer; regular files do not know it.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0)
        return cannotReadFile(path, errno);
    RegularFile file(path, descriptor);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        return cannotReadFile(path, errno);
    if (S_ISDIR(status.st_mode))
        return cannotReadFile(path, Message::say("it is a folder. Name a file in it."));
    if (!S_ISREG(status.st_mode))
        return cannotReadFile(path, Message::say("it is not a regular file. Copy its content into one first."));
    file.size_ = static_cast<std::uint64_t>(status.st_size);
    file.modified_ = std::int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec;
    return file;
}

RegularFile::RegularFile(RegularFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(other.release()), size_(other.size_), modified_(other.modified_)
{
}

RegularFile::~RegularFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

int RegularFile::release() noexcept
{
    return std::exchange(descriptor_, -1);
}

Result<std::string> RegularFile::front(std::size_t most) const
{
    constexpr std::size_t step = 1 << 16; // a file may claim any size
    std::string text;
    while (text.size() < most) {
        const std::size_t had = text.size();
        text.resize(std::min(most, had + step));
        const ssize_t got = ::pread(descriptor_, text.data() + had, text.size() - had, static_cast<off_t>(had));
        const int problem = errno;
        text.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        if (got == 0)
            break;
        if (got < 0 && problem != EINTR)
            return cannotReadFile(path_, problem);
    }
    return text;
}

Result<std::shared_ptr<const MappedFile>> MappedFile::open(const std::filesystem::path& path)
{
    const std::shared_ptr<MappedFile> file(new MappedFile);
    file->path_ = path;
    auto regular = RegularFile::open(path);
    if (!regular)
        return regular.error();
    file->modified_ = regular->modified();
    const auto size = static_cast<std::size_t>(regular->size());
    file->descriptor_ = regular->release();
    if (size == 0)
        return std::shared_ptr<const MappedFile>(file);
    void* const start = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file->descriptor_, 0);
    if (start == MAP_FAILED)
        return cannotReadFile(path, errno);
    file->bytes_ = {static_cast<const std::byte*>(start), size};
    file->guard_ = guardMapping(file->bytes_);
    if (file->guard_ < 0)
        return Error{ErrorKind::OutOfResource,
                     Message::say("Cannot open '%1': too many files are open. Close some of them.", path.string()),
                     path};
    return std::shared_ptr<const MappedFile>(file);
}

MappedFile::~MappedFile()
{
    if (guard_ >= 0)
        unguardMapping(guard_);
    if (!bytes_.empty())
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

bool MappedFile::damaged() const noexcept
{
    if (guard_ >= 0 && isMappingDamaged(guard_))
        return true;
    // The last page of a file that was cut reads as zeros without any signal.
    struct stat status {};
    return ::fstat(descriptor_, &status) != 0 || static_cast<std::size_t>(status.st_size) != bytes_.size() ||
           std::int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec != modified_;
}

} // namespace tetra
