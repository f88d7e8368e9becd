// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/egl_devices.h"
#include "core/render/gl/gl_functions.h"

#include <tan/base.h>

#include <memory>
#include <vector>

namespace tetra {

/// A context of OpenGL 3.3 core without a window and without a display, by EGL. The library is loaded when it is asked
/// for, so that a machine without it runs everything else.
class EglContext {
public:
    /// `library` is the file of EGL. Errors: the library is missing, no device gives such a context.
    static Result<std::unique_ptr<EglContext>> make(const char* library = "libEGL.so.1");
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Makes the context current in this thread while it lives. No other context may be current in the thread.
    class Current {
    public:
        explicit Current(const EglContext& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;
        bool ok() const noexcept { return ok_; }

    private:
        const EglContext& context_;
        bool ok_;
    };

    GetProcAddress getProcAddress() const;

private:
    struct Functions;
    struct ListedDevice {
        void* handle;
        EglDevice is;
    };
    std::vector<ListedDevice> listedDevices() const;
    EglContext();
    bool tryDisplay(void* display);
    bool tryCards();
    bool trySoftwareDevices();
    bool drawsInSoftware() const;
    void dropContext();
    bool tryPlatform(unsigned platform, void* nativeDisplay);

    std::unique_ptr<Functions> egl_;
    void* display_ = nullptr;
    void* context_ = nullptr;
};

} // namespace tetra
