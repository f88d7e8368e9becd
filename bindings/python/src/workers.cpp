// SPDX-License-Identifier: GPL-3.0-or-later
#include "workers.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

namespace tetra::python {

namespace {

/// A thread and what it is to do next.
struct Worker {
    std::mutex mutex;
    std::condition_variable called;
    std::function<void()> work;
};

/// The workers of a process that have nothing to do.
struct Idle {
    pid_t process = getpid();
    std::mutex mutex;
    std::vector<Worker*> workers;
};

/// Those of this process. None of them is ever freed, as threads wait in them until the program has ended; in a child
/// of fork() those threads are not there, and what they locked may stay so.
Idle& idle()
{
    static Idle* ofProcess = new Idle; // the GIL is held
    if (ofProcess->process != getpid())
        ofProcess = new Idle;
    return *ofProcess;
}

void workForever(Worker& worker, Idle& others)
{
    for (;;) {
        std::function<void()> work;
        {
            std::unique_lock lock(worker.mutex);
            worker.called.wait(lock, [&] { return static_cast<bool>(worker.work); });
            work = std::exchange(worker.work, nullptr);
        }
        work();
        work = nullptr; // and what it holds
        const std::lock_guard lock(others.mutex);
        others.workers.push_back(&worker);
    }
}

Worker& anyWorker(Idle& from)
{
    {
        const std::lock_guard lock(from.mutex);
        if (!from.workers.empty()) {
            Worker* const worker = from.workers.back();
            from.workers.pop_back();
            return *worker;
        }
    }
    auto made = std::make_unique<Worker>();
    std::thread([worker = made.get(), &from] { workForever(*worker, from); }).detach();
    return *made.release();
}

} // namespace

void runOnWorker(std::function<void()> work)
{
    Worker& worker = anyWorker(idle());
    const std::lock_guard lock(worker.mutex);
    worker.work = std::move(work);
    worker.called.notify_one();
}

} // namespace tetra::python
