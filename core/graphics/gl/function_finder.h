// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>

namespace tetra {

/// Gives the address of an OpenGL (or EGL) function by name, null if there is none: QOpenGLContext::getProcAddress,
/// eglGetProcAddress, dlsym ...
using GetProcAddress = std::function<void*(const char* name)>;

/// Fills tables of functions, and remembers the first name that was not found.
class FunctionFinder {
public:
    explicit FunctionFinder(GetProcAddress getProcAddress) : getProcAddress_(std::move(getProcAddress)) {}

    /// Becomes a pointer of the type that it initialises.
    class Found {
    public:
        explicit Found(void* address) : address_(address) {}
        template <class Function> operator Function*() const { return reinterpret_cast<Function*>(address_); }

    private:
        void* address_;
    };

    Found operator()(const char* name)
    {
        void* address = getProcAddress_(name);
        if (address == nullptr && missing_.empty())
            missing_ = name;
        return Found(address);
    }

    const std::string& missing() const noexcept { return missing_; } ///< empty if all were found

private:
    GetProcAddress getProcAddress_;
    std::string missing_;
};

} // namespace tetra
