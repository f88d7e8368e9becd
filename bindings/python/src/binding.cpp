// SPDX-License-Identifier: GPL-3.0-or-later
#include "binding.h"
#include "workers.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace tetra::python {

namespace {

using namespace std::chrono_literals;

/// How often signals are looked at, and so how long Ctrl-C waits at most until work is asked to stop.
constexpr auto glance = 25ms;

/// Whether Python is ending: a thread that asks for the GIL then is ended by force, which C++ does not survive.
bool isEnding()
{
#if PY_VERSION_HEX >= 0x030d0000
    return Py_IsInitialized() == 0 || Py_IsFinalizing() != 0;
#else
    return Py_IsInitialized() == 0 || _Py_IsFinalizing() != 0;
#endif
}

/// Without the GIL for as long as it lives. A thread of the program that nobody waits for at its end stays in here.
class Unlocked {
public:
    Unlocked() : state_(PyEval_SaveThread()) {}
    ~Unlocked()
    {
        while (isEnding())
            std::this_thread::sleep_for(1h);
        PyEval_RestoreThread(state_);
    }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

private:
    PyThreadState* state_;
};

/// What the two threads tell each other.
struct Shared {
    std::mutex mutex;
    std::condition_variable ended;
    bool done = false;
    bool reported = false; ///< since somebody looked
    double fraction = 0;
    std::string activity;
};

/// What was reported since the last time, if anything.
std::optional<std::pair<double, std::string>> news(Shared& shared)
{
    const std::lock_guard lock(shared.mutex);
    if (!std::exchange(shared.reported, false))
        return {};
    return {{shared.fraction, shared.activity}};
}

void tell(const py::object& callback, Shared& shared)
{
    if (const auto report = news(shared); report && !callback.is_none())
        callback(report->first, report->second);
}

/// Whether the work has ended, after at most a glance. Without the GIL.
bool waited(Shared& shared)
{
    const Unlocked unlocked;
    std::unique_lock lock(shared.mutex);
    return shared.ended.wait_for(lock, glance, [&] { return shared.done; });
}

/// Until the work has ended; asks it to stop if Python raises.
void watch(const py::object& callback, Shared& shared, std::stop_source& stop)
{
    try {
        while (!waited(shared)) {
            if (PyErr_CheckSignals() != 0)
                throw py::error_already_set();
            tell(callback, shared);
        }
    } catch (...) {
        stop.request_stop();
        throw;
    }
}

/// Work on another thread. Its end is waited for without the GIL, which it may need for a last time.
class Joined {
public:
    explicit Joined(std::function<void()> work)
    {
        std::promise<void> promise;
        ended_ = promise.get_future();
        runOnWorker([work = std::move(work), ended = std::make_shared<std::promise<void>>(std::move(promise))] {
            work();
            ended->set_value();
        });
    }
    ~Joined()
    {
        const Unlocked unlocked;
        ended_.wait();
    }
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;

private:
    std::future<void> ended_;
};

const char* exceptionName(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::WrongUsage: return "WrongUsage";
    case ErrorKind::BadInput: return "BadInput";
    case ErrorKind::CannotWrite: return "CannotWrite";
    case ErrorKind::OutOfResource: return "OutOfResource";
    case ErrorKind::NotYet: return "NotYet";
    case ErrorKind::Cancelled: break;
    }
    return "Cancelled";
}

} // namespace

py::str attributeName(const char* name)
{
    return py::reinterpret_steal<py::str>(PyUnicode_InternFromString(name));
}

void raise(const Error& error)
{
    const py::object type = py::module_::import("tan._errors").attr(attributeName(exceptionName(error.kind)));
    const py::object exception = type(visibleText(error.message));
    exception.attr("file") = error.file.empty() ? py::object(py::none()) : py::object(py::str(error.file.string()));
    PyErr_SetObject(type.ptr(), exception.ptr());
    throw py::error_already_set();
}

void runInterruptibly(const py::object& callback, const std::function<void(const Progress& progress)>& work)
{
    Shared shared;
    std::stop_source stop;
    std::exception_ptr failure;
    {
        const auto run = [&] {
            const Progress progress(stop.get_token(), [&](double fraction, const Message& activity) {
                const std::lock_guard lock(shared.mutex);
                shared.fraction = fraction;
                shared.activity = visibleText(activity);
                shared.reported = true;
            });
            try {
                work(progress);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(shared.mutex);
            shared.done = true;
            shared.ended.notify_one();
        };
        const Joined worker(run);
        watch(callback, shared, stop);
    }
    if (failure)
        std::rethrow_exception(failure);
    tell(callback, shared);
}

std::unique_lock<std::timed_mutex> locked(std::timed_mutex& mutex, const Progress& progress)
{
    std::unique_lock lock(mutex, std::defer_lock);
    while (!progress.cancelled() && !lock.try_lock_for(glance)) {
    }
    return lock;
}

std::shared_ptr<const std::byte> memoryOf(const py::array& array)
{
    const auto* bytes = static_cast<const std::byte*>(array.data());
    PyObject* const held = array.ptr();
    Py_INCREF(held);
    return {bytes, [held](const std::byte*) {
                if (isEnding())
                    return;
                const py::gil_scoped_acquire gil;
                Py_DECREF(held);
            }};
}

} // namespace tetra::python

PYBIND11_MODULE(_tan, module)
{
    module.doc() = "The compiled half of tan: its functions are called by the package, not by users.";
    tetra::python::bindModels(module);
    tetra::python::bindMeshes(module);
    tetra::python::bindData(module);
    tetra::python::bindBuilding(module);
    tetra::python::bindPictures(module);
}
