// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What all parts of the Python module share: errors as exceptions, work that can be interrupted, arrays and datasets.

#include <tan/base.h>
#include <tan/data.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra::python {

namespace py = pybind11;

/// A dataset that was made of arrays. Values of a lattice or a grid may lie in the memory of the array that they came
/// in, which the dataset keeps.
struct HeldDataset {
    Dataset dataset;
};

/// The name of an attribute as Python keeps names: a new string for each call would stay in the caches of its lookups.
/// Needs the GIL.
py::str attributeName(const char* name);

/// The error as an exception of tan._errors, with its sentence. Needs the GIL.
[[noreturn]] void raise(const Error& error);

/// Runs `work` on a thread of its own, while the calling one, without the GIL, waits for it: every few hundredths of a
/// second it takes the GIL, lets Python handle its signals, and calls `callback(fraction, activity)`, if that is not
/// None and something was reported. If either raises, the work is asked to stop, and once it has ended the exception
/// goes on. Needs the GIL; `work` runs without.
void runInterruptibly(const py::object& callback, const std::function<void(const Progress& progress)>& work);

/// The value of a Result, or its error as an exception. Needs the GIL.
template <class Value> Value valueOf(Result<Value> result)
{
    if (!result.ok())
        raise(result.error());
    return std::move(result).value();
}
inline void valueOf(const Status& status)
{
    if (!status.ok())
        raise(status.error());
}

/// The value of work(progress), which gives a Result and runs as runInterruptibly() does it.
template <class Work> auto finished(const py::object& callback, Work work)
{
    using Outcome = decltype(work(std::declval<const Progress&>()));
    std::optional<Outcome> outcome;
    runInterruptibly(callback, [&](const Progress& progress) { outcome.emplace(work(progress)); });
    return valueOf(*std::move(outcome));
}

/// A lock that is waited for only as long as the work is wanted; it is not held if that was cancelled.
std::unique_lock<std::timed_mutex> locked(std::timed_mutex& mutex, const Progress& progress);

/// A read-only array of `Scalar` over memory that `owner` keeps, for as long as the array, or a view of it, lives.
template <class Scalar>
py::array viewOf(const void* data, std::vector<py::ssize_t> shape, std::shared_ptr<const void> owner)
{
    auto kept = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
    const py::capsule base(kept.get(), [](void* held) { delete static_cast<std::shared_ptr<const void>*>(held); });
    kept.release(); // NOLINT(bugprone-unused-return-value): the capsule has it
    const py::array_t<Scalar> array(std::move(shape), static_cast<const Scalar*>(data), base);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// The array's memory, which is contiguous, and which lives for as long as the pointer does, wherever that is given up.
std::shared_ptr<const std::byte> memoryOf(const py::array& array);

/// One of several words of an option; WrongUsage as an exception if it is none of them.
template <class Value, std::size_t count>
Value choice(std::string_view option, const std::string& word,
             const std::array<std::pair<std::string_view, Value>, count>& choices)
{
    std::string known;
    for (const auto& [name, value] : choices) {
        if (name == word)
            return value;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    raise({ErrorKind::WrongUsage, Message::say("%1 can be %2, not '%3'.", option, known, printable(word))});
}

// Each part of the module.
void bindModels(py::module_& module);
void bindMeshes(py::module_& module);
void bindData(py::module_& module);
void bindBuilding(py::module_& module);
void bindPictures(py::module_& module);

} // namespace tetra::python
