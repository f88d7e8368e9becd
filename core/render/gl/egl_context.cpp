// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <type_traits>

namespace tetra {
namespace {

/// Of the file of a card, such as /dev/dri/card0.
bool showsScreen(const char* file)
{
    std::ifstream flag("/sys/class/drm/" + std::filesystem::path(file).filename().string() + "/device/boot_vga");
    return flag.get() == '1';
}

} // namespace

struct EglContext::Functions {
    explicit Functions(void* library) : find([library](const char* name) { return dlsym(library, name); }) {}

    FunctionFinder find;
    std::add_pointer_t<decltype(eglGetProcAddress)> getProcAddress = find("eglGetProcAddress");
    std::add_pointer_t<decltype(eglQueryString)> queryString = find("eglQueryString");
    std::add_pointer_t<decltype(eglGetDisplay)> getDisplay = find("eglGetDisplay");
    std::add_pointer_t<decltype(eglInitialize)> initialize = find("eglInitialize");
    std::add_pointer_t<decltype(eglBindAPI)> bindApi = find("eglBindAPI");
    std::add_pointer_t<decltype(eglChooseConfig)> chooseConfig = find("eglChooseConfig");
    std::add_pointer_t<decltype(eglCreateContext)> createContext = find("eglCreateContext");
    std::add_pointer_t<decltype(eglDestroyContext)> destroyContext = find("eglDestroyContext");
    std::add_pointer_t<decltype(eglMakeCurrent)> makeCurrent = find("eglMakeCurrent");

    /// A function of an extension, null if EGL does not have it.
    template <class Function> Function extension(const char* name) const
    {
        return reinterpret_cast<Function>(getProcAddress(name));
    }
    bool has(EGLDisplay display, const char* extensionName) const
    {
        const char* all = queryString(display, EGL_EXTENSIONS);
        return all != nullptr && std::strstr(all, extensionName) != nullptr;
    }
};

EglContext::EglContext() = default;

EglContext::~EglContext()
{
    // The display stays initialised: it is the process's one and only, and others may be using it.
    if (context_ != nullptr)
        egl_->destroyContext(display_, context_);
}

bool EglContext::tryDisplay(void* display)
{
    if (display == EGL_NO_DISPLAY || egl_->initialize(display, nullptr, nullptr) == EGL_FALSE ||
        !egl_->has(display, "EGL_KHR_surfaceless_context"))
        return false;
    constexpr std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array<EGLint, 7> version = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    egl_->bindApi(EGL_OPENGL_API);
    if (egl_->chooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    context_ = egl_->createContext(display, config, EGL_NO_CONTEXT, version.data());
    display_ = display;
    return context_ != EGL_NO_CONTEXT;
}

bool EglContext::tryPlatform(unsigned platform, void* nativeDisplay)
{
    const auto getDisplay = egl_->extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    return getDisplay != nullptr && tryDisplay(getDisplay(platform, nativeDisplay, nullptr));
}

std::vector<EglContext::ListedDevice> EglContext::listedDevices() const
{
    const auto queryDevices = egl_->extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto queryDevice = egl_->extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    std::array<EGLDeviceEXT, 32> handles{};
    EGLint count = 0;
    if (queryDevices == nullptr || queryDevice == nullptr ||
        queryDevices(static_cast<EGLint>(handles.size()), handles.data(), &count) == EGL_FALSE)
        return {};
    std::vector<ListedDevice> devices;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const char* extensions = queryDevice(handles[i], EGL_EXTENSIONS);
        const std::string_view has = extensions != nullptr ? extensions : "";
        const char* file = has.find("EGL_EXT_device_drm") != std::string_view::npos
                               ? queryDevice(handles[i], EGL_DRM_DEVICE_FILE_EXT)
                               : nullptr;
        const bool isSoftware = has.find("EGL_MESA_device_software") != std::string_view::npos;
        devices.push_back({handles[i], {isSoftware, file != nullptr && showsScreen(file)}});
    }
    return devices;
}

/// A card that is there, but whose driver draws in software, is of no use.
bool EglContext::tryCards()
{
    const auto listed = listedDevices();
    std::vector<EglDevice> devices;
    for (const ListedDevice& device : listed)
        devices.push_back(device.is);
    const char* prime = std::getenv("DRI_PRIME"); // NOLINT(concurrency-mt-unsafe): nobody sets it
    for (const std::size_t index : cardOrder(devices, prime != nullptr ? prime : "")) {
        if (!tryPlatform(EGL_PLATFORM_DEVICE_EXT, listed[index].handle))
            continue;
        if (!drawsInSoftware())
            return true;
        dropContext();
    }
    return false;
}

bool EglContext::trySoftwareDevices()
{
    return std::ranges::any_of(listedDevices(), [this](const ListedDevice& device) {
        return device.is.isSoftware && tryPlatform(EGL_PLATFORM_DEVICE_EXT, device.handle);
    });
}

bool EglContext::drawsInSoftware() const
{
    constexpr unsigned rendererName = 0x1F01; // GL_RENDERER
    using GetString = const unsigned char* (*)(unsigned);
    const Current current(*this);
    const auto getString = egl_->extension<GetString>("glGetString");
    if (!current.ok() || getString == nullptr)
        return false;
    const auto* name = reinterpret_cast<const char*>(getString(rendererName));
    const std::string_view renderer = name != nullptr ? name : "";
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast"},
                               [&](const char* software) { return renderer.find(software) != std::string_view::npos; });
}

void EglContext::dropContext()
{
    egl_->destroyContext(display_, context_);
    context_ = nullptr;
}

Result<std::unique_ptr<EglContext>> EglContext::make(const char* library)
{
    // Never closed: drivers leave threads and handlers behind that would run into nothing.
    void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
        return Error{ErrorKind::OutOfResource,
                     Message::say("OpenGL without a window needs EGL, and %1 cannot be loaded. Install it (Debian: "
                                  "libegl1), or use the CPU back end.",
                                  library)};
    std::unique_ptr<EglContext> context(new EglContext);
    context->egl_ = std::make_unique<Functions>(handle);
    if (const std::string& missing = context->egl_->find.missing(); !missing.empty())
        return Error{ErrorKind::OutOfResource,
                     Message::say("%1 has no %2. Install EGL 1.4, or use the CPU back end.", library, missing)};
    // A card first, that of the windows; then Mesa without a display, which finds a card, too, or draws in software;
    // then whatever is left.
    const bool found = context->tryCards() || context->tryPlatform(EGL_PLATFORM_SURFACELESS_MESA, nullptr) ||
                       context->trySoftwareDevices() ||
                       context->tryDisplay(context->egl_->getDisplay(EGL_DEFAULT_DISPLAY));
    if (!found)
        return Error{ErrorKind::OutOfResource,
                     Message::say("EGL provides no OpenGL 3.3 without a window on this machine. Install the driver of "
                                  "the graphics card or Mesa (Debian: libgl1-mesa-dri), or use the CPU back end.")};
    return context;
}

GetProcAddress EglContext::getProcAddress() const
{
    return [get = egl_->getProcAddress](const char* name) { return reinterpret_cast<void*>(get(name)); };
}

EglContext::Current::Current(const EglContext& context) : context_(context)
{
    context_.egl_->bindApi(EGL_OPENGL_API); // counts for this thread only
    ok_ = context_.egl_->makeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_.context_) == EGL_TRUE;
}

EglContext::Current::~Current()
{
    context_.egl_->makeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace tetra
