// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_functions.h"

#include <tan/base.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

namespace tetra {

/// A device that EGL lists.
struct EglDevice {
    bool isSoftware = false;  ///< draws on the processor
    bool showsScreen = false; ///< the card that the machine started with: windows are drawn by it
};

/// In which order to try the cards, as indices: the screen's first, or with `prime` as in the environment variable
/// DRI_PRIME (a number above 0) the others first; else as EGL lists them. Software is left out.
inline std::vector<std::size_t> cardOrder(const std::vector<EglDevice>& devices, std::string_view prime)
{
    std::vector<std::size_t> order(devices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::erase_if(order, [&](std::size_t index) { return devices[index].isSoftware; });
    const bool wantsOther = !prime.empty() && prime.front() >= '1' && prime.front() <= '9';
    std::ranges::stable_partition(order, [&](std::size_t index) { return devices[index].showsScreen != wantsOther; });
    return order;
}

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
