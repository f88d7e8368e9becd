// SPDX-License-Identifier: GPL-3.0-or-later
// A library for LD_PRELOAD: of the calls that change what is below the folder TAN_FAILING_FOLDER, the one with the
// number TAN_FAILING_CALL (from 1) fails with ENOSPC, as on a full disk. At the end their number is written into
// TAN_FAILING_COUNT.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

template <class Function> Function* next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name)
{
    const char* found = std::getenv(name);
    return found != nullptr ? found : "";
}

bool isBelow(const char* path)
{
    const char* folder = setting("TAN_FAILING_FOLDER");
    return *folder != 0 && path != nullptr && (path[0] != '/' || std::strncmp(path, folder, std::strlen(folder)) == 0);
}

bool isOfFolder(int descriptor)
{
    char link[64];
    std::snprintf(link, sizeof(link), "/proc/self/fd/%d", descriptor);
    char path[PATH_MAX + 1];
    const ssize_t length = readlink(link, path, PATH_MAX);
    if (length <= 0)
        return false;
    path[length] = 0;
    return path[0] == '/' && isBelow(path);
}

class Count {
public:
    ~Count()
    {
        const char* file = setting("TAN_FAILING_COUNT");
        if (std::FILE* out = *file != 0 ? std::fopen(file, "w") : nullptr) {
            std::fprintf(out, "%ld\n", calls_.load());
            std::fclose(out);
        }
    }
    /// Whether this call is the one.
    bool fails() { return ++calls_ == asked_; }

private:
    std::atomic<long> calls_ = 0;
    const long asked_ = std::atol(setting("TAN_FAILING_CALL"));
};

Count count;

bool diskIsFull(bool concerned)
{
    if (!concerned || !count.fails())
        return false;
    errno = ENOSPC;
    return true;
}

} // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t size)
{
    return diskIsFull(isOfFolder(descriptor))
               ? -1
               : next<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, size);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset)
{
    return diskIsFull(isOfFolder(descriptor))
               ? -1
               : next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(descriptor, bytes, size, offset);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off_t offset)
{
    return pwrite(descriptor, bytes, size, offset);
}

int fsync(int descriptor)
{
    return diskIsFull(isOfFolder(descriptor)) ? -1 : next<int(int)>("fsync")(descriptor);
}

int ftruncate(int descriptor, off_t size) noexcept
{
    return diskIsFull(isOfFolder(descriptor)) ? -1 : next<int(int, off_t)>("ftruncate")(descriptor, size);
}

int fallocate(int descriptor, int mode, off_t offset, off_t size)
{
    return diskIsFull(isOfFolder(descriptor))
               ? -1
               : next<int(int, int, off_t, off_t)>("fallocate")(descriptor, mode, offset, size);
}

int posix_fallocate(int descriptor, off_t offset, off_t size)
{
    return diskIsFull(isOfFolder(descriptor))
               ? ENOSPC
               : next<int(int, off_t, off_t)>("posix_fallocate")(descriptor, offset, size);
}

int rename(const char* from, const char* to) noexcept
{
    return diskIsFull(isBelow(to)) ? -1 : next<int(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept
{
    return diskIsFull(isBelow(path)) ? -1 : next<int(const char*, mode_t)>("mkdir")(path, mode);
}

int open(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return diskIsFull((flags & O_CREAT) != 0 && isBelow(path))
               ? -1
               : next<int(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return open(path, flags, mode);
}
}
