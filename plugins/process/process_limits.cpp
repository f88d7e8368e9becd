// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/process/process_limits.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

// Whether a sanitizer watches this process; GCC and clang say it in different ways.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAN_IS_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAN_IS_WATCHED 1
#endif
#endif

namespace tetra {
namespace {

/// What is said when a limit is met, a word and a number that limitMessage() knows: made before, because then there is
/// no memory or no time to make it.
struct LastWords {
    int descriptor = STDERR_FILENO;
    std::array<char, 128> memory{};
    std::array<char, 128> time{};
};

LastWords& lastWords()
{
    static LastWords words; // signal handlers have no other way to their data
    return words;
}

constexpr std::string_view addressSpaceWord = "space ", machineWord = "half ", memoryWord = "memory ",
                           timeWord = "seconds ";

void keep(std::array<char, 128>& place, std::string_view word, std::uint64_t number)
{
    const std::string text = std::string(limitNote) + std::string(word) + std::to_string(number);
    place.fill(0);
    std::ranges::copy_n(text.begin(), static_cast<std::ptrdiff_t>(std::min(text.size(), place.size() - 1)),
                        place.begin());
}

void say(const std::array<char, 128>& words)
{
    const std::size_t length = std::string_view(words.data()).size();
    [[maybe_unused]] const ssize_t written = write(lastWords().descriptor, words.data(), length);
}

void endOfTime(int)
{
    say(lastWords().time);
    _exit(EXIT_FAILURE);
}

void endOfMemory()
{
    std::set_new_handler(nullptr);
    say(lastWords().memory);
    throw std::bad_alloc();
}

void setLimit(int resource, std::uint64_t soft, std::uint64_t hard)
{
    const auto kind = static_cast<__rlimit_resource_t>(resource);
    rlimit limit{};
    if (getrlimit(kind, &limit) != 0)
        return;
    limit.rlim_max = std::min<rlim_t>(limit.rlim_max, hard); // it may have been started with lower ones
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, soft);
    setrlimit(kind, &limit);
}

std::uint64_t usedSeconds()
{
    timespec time{};
    return clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) == 0 ? static_cast<std::uint64_t>(time.tv_sec) : 0;
}

/// The address space that this process was started with, if it was limited.
std::uint64_t addressSpace()
{
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : ~std::uint64_t(0);
}

} // namespace

Message limitMessage(std::string_view words, std::string_view library)
{
    const auto numberBehind = [&](std::string_view word) {
        return words.starts_with(word) ? parseNumber<std::uint64_t>(words.substr(word.size())) : std::nullopt;
    };
    if (const auto space = numberBehind(addressSpaceWord))
        return Message::say(
            "%1 needs more memory for it than the %2 that programs may use here. Raise the limit (ulimit -v).", library,
            neededBytesText(*space));
    if (const auto half = numberBehind(machineWord))
        return Message::say("%1 needs more than %2 of memory for it, half of what this machine has. It may be damaged, "
                            "or too large for this machine: take a part of it.",
                            library, neededBytesText(*half));
    if (const auto memory = numberBehind(memoryWord))
        return Message::say("%1 needs more than %2 of memory for it, which files of its size do not need. It "
                            "may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).",
                            library, neededBytesText(*memory));
    return Message::say("%1 needs more than %2 seconds of processor time for it, which files of its size do not need. "
                        "It may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).",
                        library, numberBehind(timeWord).value_or(0));
}

WorkLimits limitsFor(std::uint64_t bytes, std::uint64_t unpackedBytes, std::uint64_t machineBytes)
{
    constexpr double least = 2. * (1ULL << 30U), timesPacked = 30, timesUnpacked = 8;
    constexpr double leastSeconds = 60, secondsPerByte = 3e-6, mostSeconds = 1e6;
    const auto packed = static_cast<double>(bytes);
    const auto unpacked = static_cast<double>(std::max(bytes, unpackedBytes));
    const double wanted = std::max({least, timesPacked * packed, timesUnpacked * unpacked});
    const double half = machineBytes == 0 ? wanted : static_cast<double>(machineBytes) / 2;
    WorkLimits limits;
    limits.isHalfOfMachine = machineBytes != 0 && wanted >= half;
    limits.memory = static_cast<std::uint64_t>(std::min(wanted, half));
    limits.seconds = static_cast<std::uint64_t>(std::min(leastSeconds + secondsPerByte * unpacked, mostSeconds));
    return limits;
}

void limitThisProcess()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::ofstream("/proc/self/oom_score_adj") << "1000";
    setLimit(RLIMIT_CORE, 0, 0);
    constexpr std::uint64_t anySize = 1ULL << 50U;
    limitWork(limitsFor(anySize, anySize, physicalBytes()));
}

void limitWork(const WorkLimits& limits)
{
    keep(lastWords().time, timeWord, limits.seconds);
    if (const std::uint64_t space = addressSpace(); space <= limits.memory)
        keep(lastWords().memory, addressSpaceWord, space);
    else
        keep(lastWords().memory, limits.isHalfOfMachine ? machineWord : memoryWord, limits.memory);
    struct sigaction action {};
    action.sa_handler = endOfTime;
    sigaction(SIGXCPU, &action, nullptr);
    std::set_new_handler(endOfMemory);
    const std::uint64_t seconds = usedSeconds() + limits.seconds + 1;
    setLimit(RLIMIT_CPU, seconds, RLIM_INFINITY);
#ifndef TAN_IS_WATCHED // its shadow is larger than any memory
    // What is written, not mapped files and libraries. Other programs' limits of address space stay as they are.
    setLimit(RLIMIT_DATA, limits.memory, RLIM_INFINITY);
#endif
}

void allowOneFile()
{
#ifndef TAN_IS_WATCHED // it looks at memory through pipes, and takes what it cannot look at for damaged
    rlim_t free = 0;
    while (fcntl(static_cast<int>(free), F_GETFD) != -1)
        ++free;
    setLimit(RLIMIT_NOFILE, free + 1, RLIM_INFINITY);
#endif
}

Error memoryLimitMet(std::string_view library)
{
    return {ErrorKind::OutOfResource, limitMessage(lastWords().memory.data() + limitNote.size(), library)};
}

int takeStandardOutput()
{
    lastWords().descriptor = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    const int output = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
#ifndef TAN_IS_WATCHED // what it finds must be heard
        dup2(nowhere, STDERR_FILENO);
#endif
        close(nowhere);
    }
    return output;
}

} // namespace tetra
