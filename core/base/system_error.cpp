// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/system_error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

namespace tetra {
namespace {

Error lackOfThreads()
{
    return {ErrorKind::OutOfResource,
            Message::say(
                "This machine cannot start any more threads now. Close other programs, or raise the limit (ulimit).")};
}

Error lackOfMemory()
{
    return {
        ErrorKind::OutOfResource,
        Message::say(
            "This machine does not have enough memory for this. Close other programs, or raise the limit (ulimit).")};
}

} // namespace

Message systemErrorText(int error)
{
    switch (error) {
    case ENOENT: return Message::say("No such file or directory");
    case EACCES: return Message::say("Permission denied");
    case EPERM: return Message::say("Operation not permitted");
    case EIO: return Message::say("Input/output error");
    case ENOMEM: return Message::say("Cannot allocate memory");
    case EAGAIN: return Message::say("Resource temporarily unavailable");
    case EBUSY: return Message::say("Device or resource busy");
    case EXDEV: return Message::say("Invalid cross-device link");
    case ENOTDIR: return Message::say("Not a directory");
    case EISDIR: return Message::say("Is a directory");
    case EINVAL: return Message::say("Invalid argument");
    case EMFILE: return Message::say("Too many open files");
    case ENFILE: return Message::say("Too many open files in system");
    case EFBIG: return Message::say("File too large");
    case ENOSPC: return Message::say("No space left on device");
    case EROFS: return Message::say("Read-only file system");
    case ENAMETOOLONG: return Message::say("File name too long");
    case ELOOP: return Message::say("Too many levels of symbolic links");
    case EDQUOT: return Message::say("Disk quota exceeded");
    case ESTALE: return Message::say("Stale file handle");
    default: break;
    }
#if defined(__GLIBC__)
    const char* const text = ::strerrordesc_np(error);
    return text != nullptr ? Message(text) : Message::say("system error %1", error);
#else
    return std::generic_category().message(error);
#endif
}

bool isLackOfResources(int error) noexcept
{
    return error == ENOMEM || error == EAGAIN || error == EMFILE || error == ENFILE;
}

bool namesLackOfResources(std::string_view text) noexcept
{
    constexpr std::array<std::string_view, 6> lacks = {"annot allocate memory",     "failed to map segment",
                                                       "oo many open files",        "cannot create shared object",
                                                       "pthread_create has failed", "emporarily unavailable"};
    return std::ranges::any_of(lacks, [&](std::string_view lack) { return text.find(lack) != std::string_view::npos; });
}

Message diskRemedy(int error)
{
    if (isLackOfResources(error))
        return resourceRemedy;
    if (error == EFBIG)
        return Message::say("Choose a disk that allows larger files, or raise the limit (ulimit -f).");
    return Message::say("Free some space or choose another disk.");
}

std::optional<Error> lackOfResources(const std::exception& problem)
{
    if (dynamic_cast<const std::bad_alloc*>(&problem) != nullptr)
        return lackOfMemory();
    if (const auto* const system = dynamic_cast<const std::system_error*>(&problem)) {
        const int number = system->code().value();
        if (!isLackOfResources(number))
            return std::nullopt;
        if (number == EAGAIN)
            return lackOfThreads();
        if (number == ENOMEM)
            return lackOfMemory();
        return Error{ErrorKind::OutOfResource, Message::say("%1. %2", systemErrorText(number), resourceRemedy)};
    }
    // TBB throws a std::runtime_error with the text of pthread_create().
    if (namesLackOfResources(problem.what()))
        return lackOfThreads();
    return std::nullopt;
}

} // namespace tetra
