// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

namespace tetra {

/// Lines for a descriptor that may block for ever, such as a pipe whose reader sleeps or a terminal that is stopped:
/// whoever adds a line goes on at once. Lines wait in a queue; those that find it full are dropped, and how many there
/// were is a line of its own. Safe from any number of threads.
class LineLog {
public:
    explicit LineLog(int descriptor, std::size_t mostWaiting = 1000);
    /// Writes what waits, as far as it is taken within a fifth of a second.
    ~LineLog();
    LineLog(const LineLog&) = delete;
    LineLog& operator=(const LineLog&) = delete;

    /// `line` without its end; at most some 4000 bytes of it are written.
    void add(std::string line);

private:
    void push(std::string line);
    void tellDropped();
    void writeAll();
    bool write(const std::string& line);

    const int descriptor_;
    const std::size_t mostWaiting_;
    std::mutex mutex_; ///< of what follows
    std::condition_variable changed_;
    std::deque<std::string> waiting_;
    std::uint64_t dropped_ = 0;
    bool ends_ = false;
    std::jthread writer_;
};

/// Whether a descriptor takes a few words now, without waiting for anybody.
bool takesText(int descriptor);

} // namespace tetra
