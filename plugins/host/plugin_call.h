// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/system_error.h"

#include <tan/base.h>

#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

namespace tetra {

inline Error outOfMemoryInPlugin(const std::string& id)
{
    return {
        ErrorKind::OutOfResource,
        Message::say(
            "This machine does not have enough memory for '%1' here. Close other programs, or give it smaller data.",
            id)};
}

inline Error brokenPlugin(const std::string& id, const Message& problem)
{
    return {ErrorKind::BadInput,
            Message::say("The plugin '%1' failed: %2. This is a fault of the plugin; tell its author.", id, problem)};
}

/// What a plugin threw that the C++ library's texts explain. A machine that can start no more threads is not the
/// plugin's fault.
inline Error thrownByPlugin(const std::string& id, const std::exception& problem)
{
    if (auto lack = lackOfResources(problem))
        return *std::move(lack);
    return brokenPlugin(id, problem.what());
}

/// Calls `work`, which gives a Result and belongs to the plugin `id`. Plugins should not throw; what one throws all the
/// same becomes an error here, and too little memory the error `outOfMemory`.
template <class Work> auto callPlugin(const std::string& id, Work&& work, const Error& outOfMemory) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return outOfMemory;
    } catch (const std::length_error&) { // more than any vector can hold
        return outOfMemory;
    } catch (const std::exception& problem) {
        return thrownByPlugin(id, problem);
    } catch (...) {
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "The plugin '%1' failed without giving a reason. This is a fault of the plugin; tell its author.", id)};
    }
}
template <class Work> auto callPlugin(const std::string& id, Work&& work) -> decltype(work())
{
    return callPlugin(id, std::forward<Work>(work), outOfMemoryInPlugin(id));
}

/// The same for work that gives a value and no Result: what it throws goes to `tell`, and `fallback` is given instead.
template <class Value, class Work>
Value callPluginOr(Value fallback, const std::string& id, const std::function<void(const Error&)>& tell, Work&& work)
{
    auto result = callPlugin(id, [&]() -> Result<Value> { return work(); });
    if (result)
        return *std::move(result);
    tell(result.error());
    return fallback;
}

} // namespace tetra
