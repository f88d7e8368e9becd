// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/file_state.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <sys/stat.h>

namespace tetra {

namespace {

constexpr std::int64_t aSecond = 1'000'000'000;

std::int64_t nanosecondsOf(const timespec& time)
{
    return std::int64_t(time.tv_sec) * aSecond + time.tv_nsec;
}

std::int64_t timeNow()
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

/// How long after its last change a file has to be left for the next one to have another time.
std::int64_t stepOf(const FileState& state)
{
    constexpr std::int64_t fine = aSecond / 50, coarse = 2 * aSecond;
    return state.changedAt % aSecond == 0 ? coarse : fine;
}

} // namespace

std::optional<FileState> stateOf(const std::filesystem::path& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return {};
    FileState state;
    for (const std::int64_t part :
         {std::int64_t(status.st_dev), std::int64_t(status.st_ino), std::int64_t(status.st_size),
          nanosecondsOf(status.st_mtim), nanosecondsOf(status.st_ctim)})
        state.text += std::to_string(part) + ' ';
    // The time of modification can be set to any; the other one is the system's.
    state.changedAt = nanosecondsOf(status.st_ctim);
    if (state.changedAt > timeNow())
        return {};
    return state;
}

Status waitUntilSettled(const FileState& state, const Progress& progress)
{
    constexpr std::int64_t atOnce = aSecond / 20;
    for (std::int64_t left = 0; (left = state.changedAt + stepOf(state) - timeNow()) > 0;) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading a packed model"));
        std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(left, atOnce)));
    }
    return {};
}

} // namespace tetra
