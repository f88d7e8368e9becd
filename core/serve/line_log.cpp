// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/line_log.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <new>
#include <string_view>

#include <poll.h>
#include <unistd.h>

namespace tetra {
namespace {

/// A pipe that is ready takes so many bytes at once (PIPE_BUF), so that a line neither blocks nor is torn.
constexpr std::size_t longestLine = 4096;

bool isReady(int descriptor, int milliseconds)
{
    pollfd place{.fd = descriptor, .events = POLLOUT, .revents = 0};
    return ::poll(&place, 1, milliseconds) > 0;
}

} // namespace

bool takesText(int descriptor)
{
    return isReady(descriptor, 0);
}

LineLog::LineLog(int descriptor, std::size_t mostWaiting)
    : descriptor_(descriptor), mostWaiting_(mostWaiting), writer_([this] { writeAll(); })
{
}

LineLog::~LineLog()
{
    const std::lock_guard lock(mutex_);
    try {
        tellDropped();
    } catch (const std::bad_alloc&) {
        dropped_ = 0; // nor is there memory to say so
    }
    ends_ = true;
    changed_.notify_one();
}

void LineLog::push(std::string line)
{
    line.resize(std::min(line.size(), longestLine - 1));
    waiting_.push_back(std::move(line) + '\n');
    changed_.notify_one();
}

/// With mutex_ held, as push().
void LineLog::tellDropped()
{
    if (dropped_ > 0)
        push(std::to_string(dropped_) + " lines are missing here: they were not read in time.");
    dropped_ = 0;
}

void LineLog::add(std::string line)
{
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= mostWaiting_) {
        ++dropped_;
        return;
    }
    tellDropped();
    push(std::move(line));
}

void LineLog::writeAll()
{
    for (;;) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return ends_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        const std::string line = std::move(waiting_.front());
        waiting_.pop_front();
        lock.unlock();
        if (!write(line))
            return;
    }
}

/// Waits until it is taken. False if the log ends before.
bool LineLog::write(const std::string& line)
{
    constexpr int lookUpEvery = 20, lastTime = 200;
    for (int waitedAtEnd = 0; !isReady(descriptor_, lookUpEvery);) {
        const std::lock_guard lock(mutex_);
        waitedAtEnd += ends_ ? lookUpEvery : 0;
        if (waitedAtEnd > lastTime)
            return false;
    }
    // What cannot be written, such as to a pipe that nobody reads any more, is nobody's loss.
    for (std::string_view rest = line; !rest.empty();) {
        const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

} // namespace tetra
