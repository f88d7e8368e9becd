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
    return {
        ErrorKind::OutOfResource,
        Message::say("This machine can start no more threads now. Close other programs, or raise the limit (ulimit).")};
}

Error lackOfMemory()
{
    return {
        ErrorKind::OutOfResource,
        Message::say(
            "The memory of this machine is not enough for this. Close other programs, or raise the limit (ulimit).")};
}

} // namespace

std::string systemErrorText(int error)
{
#if defined(__GLIBC__)
    const char* const text = ::strerrordesc_np(error);
    return text != nullptr ? text : "system error " + std::to_string(error);
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

std::string diskRemedy(int error)
{
    if (isLackOfResources(error))
        return std::string(resourceRemedy);
    if (error == EFBIG)
        return "Choose a disk that allows larger files, or raise the limit (ulimit -f).";
    return "Free some space or choose another disk.";
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
