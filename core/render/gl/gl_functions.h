// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
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

/// The constants of OpenGL that are used here, under the names of the specification; checked against its header when
/// gl_functions.cpp is compiled.
namespace gl {
inline constexpr unsigned none = 0;
inline constexpr unsigned triangles = 0x0004;
inline constexpr unsigned less = 0x0201;
inline constexpr unsigned lessOrEqual = 0x0203;
inline constexpr unsigned one = 1;
inline constexpr unsigned oneMinusDestinationAlpha = 0x0305;
inline constexpr unsigned sum = 0x8006; // of blendEquation, like the next two
inline constexpr unsigned smallest = 0x8007;
inline constexpr unsigned largest = 0x8008;
inline constexpr unsigned depthTest = 0x0B71;
inline constexpr unsigned blend = 0x0BE2;
inline constexpr unsigned cullFace = 0x0B44;
inline constexpr unsigned front = 0x0404;
inline constexpr unsigned counterclockwise = 0x0901;
inline constexpr unsigned scissorTest = 0x0C11;
inline constexpr unsigned stencilTest = 0x0B90;
inline constexpr unsigned dither = 0x0BD0;
inline constexpr unsigned framebufferSrgb = 0x8DB9;
inline constexpr unsigned packAlignment = 0x0D05;
inline constexpr unsigned maximumTextureSize = 0x0D33;
inline constexpr unsigned texture2D = 0x0DE1;
inline constexpr unsigned textureBuffer = 0x8C2A;
inline constexpr unsigned maximumTextureBufferSize = 0x8C2B;
inline constexpr unsigned texture0 = 0x84C0;
inline constexpr unsigned textureMinFilter = 0x2801;
inline constexpr unsigned textureMagFilter = 0x2800;
inline constexpr unsigned nearest = 0x2600;
inline constexpr unsigned unsignedByte = 0x1401;
inline constexpr unsigned unsignedInt = 0x1405;
inline constexpr unsigned floatType = 0x1406;
inline constexpr unsigned depthComponent = 0x1902;
inline constexpr unsigned rgba = 0x1908;
inline constexpr unsigned red = 0x1903;
inline constexpr unsigned rg = 0x8227;
inline constexpr unsigned rgInteger = 0x8228;
inline constexpr unsigned rgba8 = 0x8058;
inline constexpr unsigned rgba16f = 0x881A;
inline constexpr unsigned r32f = 0x822E;
inline constexpr unsigned rg32f = 0x8230;
inline constexpr unsigned rgba32f = 0x8814;
inline constexpr unsigned rgba32ui = 0x8D70;
inline constexpr unsigned rg16ui = 0x823A;
inline constexpr unsigned rg32ui = 0x823C;
inline constexpr unsigned depthComponent32f = 0x8CAC;
inline constexpr unsigned majorVersion = 0x821B;
inline constexpr unsigned minorVersion = 0x821C;
inline constexpr unsigned renderer = 0x1F01;
inline constexpr unsigned outOfMemory = 0x0505;
inline constexpr unsigned vertexShader = 0x8B31;
inline constexpr unsigned fragmentShader = 0x8B30;
inline constexpr unsigned compileStatus = 0x8B81;
inline constexpr unsigned linkStatus = 0x8B82;
inline constexpr unsigned infoLogLength = 0x8B84;
inline constexpr unsigned arrayBuffer = 0x8892;
inline constexpr unsigned elementArrayBuffer = 0x8893;
inline constexpr unsigned staticDraw = 0x88E4;
inline constexpr unsigned streamDraw = 0x88E0;
inline constexpr unsigned framebuffer = 0x8D40;
inline constexpr unsigned colourAttachment0 = 0x8CE0;
inline constexpr unsigned depthAttachment = 0x8D00;
inline constexpr unsigned framebufferComplete = 0x8CD5;
inline constexpr unsigned colour = 0x1800;
inline constexpr unsigned depth = 0x1801;
inline constexpr unsigned anySamplesPassed = 0x8C2F;
inline constexpr unsigned samplesPassed = 0x8914;
inline constexpr unsigned queryResult = 0x8866;
} // namespace gl

/// The functions of OpenGL 3.3 that are used here, for the context that is current when it is made. One type serves
/// every platform: on those of 64 bits OpenGL's calling convention is C++'s own.
struct GlFunctions {
    explicit GlFunctions(GetProcAddress getProcAddress) : find(std::move(getProcAddress)) {}

    FunctionFinder find;

    template <class Signature> using Function = std::add_pointer_t<Signature>;
    using Names = void(int count, unsigned* names);
    using ConstantNames = void(int count, const unsigned* names);
    using NameFunction = void(unsigned name);
    using TwoNames = void(unsigned first, unsigned second);
    using GetInteger = void(unsigned name, unsigned parameter, int* value);
    using GetLog = void(unsigned name, int size, int* length, char* text);

    Function<unsigned(unsigned)> createShader = find("glCreateShader");
    Function<void(unsigned, int, const char* const*, const int*)> shaderSource = find("glShaderSource");
    Function<NameFunction> compileShader = find("glCompileShader");
    Function<GetInteger> getShaderiv = find("glGetShaderiv");
    Function<GetLog> getShaderInfoLog = find("glGetShaderInfoLog");
    Function<NameFunction> deleteShader = find("glDeleteShader");
    Function<unsigned()> createProgram = find("glCreateProgram");
    Function<TwoNames> attachShader = find("glAttachShader");
    Function<NameFunction> linkProgram = find("glLinkProgram");
    Function<GetInteger> getProgramiv = find("glGetProgramiv");
    Function<GetLog> getProgramInfoLog = find("glGetProgramInfoLog");
    Function<NameFunction> deleteProgram = find("glDeleteProgram");
    Function<NameFunction> useProgram = find("glUseProgram");
    Function<int(unsigned, const char*)> getUniformLocation = find("glGetUniformLocation");
    Function<void(int, int)> uniform1i = find("glUniform1i");
    Function<void(int, unsigned)> uniform1ui = find("glUniform1ui");
    Function<void(int, float)> uniform1f = find("glUniform1f");
    Function<void(int, float, float)> uniform2f = find("glUniform2f");
    Function<void(int, float, float, float)> uniform3f = find("glUniform3f");
    Function<void(int, float, float, float, float)> uniform4f = find("glUniform4f");
    Function<void(int, int, const float*)> uniform4fv = find("glUniform4fv");
    Function<void(int, int, unsigned char, const float*)> uniformMatrix3fv = find("glUniformMatrix3fv");
    Function<void(int, int, unsigned char, const float*)> uniformMatrix4fv = find("glUniformMatrix4fv");

    Function<Names> genBuffers = find("glGenBuffers");
    Function<ConstantNames> deleteBuffers = find("glDeleteBuffers");
    Function<TwoNames> bindBuffer = find("glBindBuffer");
    Function<void(unsigned, std::ptrdiff_t, const void*, unsigned)> bufferData = find("glBufferData");
    Function<Names> genVertexArrays = find("glGenVertexArrays");
    Function<ConstantNames> deleteVertexArrays = find("glDeleteVertexArrays");
    Function<NameFunction> bindVertexArray = find("glBindVertexArray");
    Function<NameFunction> enableVertexAttribArray = find("glEnableVertexAttribArray");
    Function<void(unsigned, int, unsigned, unsigned char, int, const void*)> vertexAttribPointer =
        find("glVertexAttribPointer");

    Function<Names> genTextures = find("glGenTextures");
    Function<ConstantNames> deleteTextures = find("glDeleteTextures");
    Function<TwoNames> bindTexture = find("glBindTexture");
    Function<NameFunction> activeTexture = find("glActiveTexture");
    Function<void(unsigned, int, int, int, int, int, unsigned, unsigned, const void*)> texImage2D =
        find("glTexImage2D");
    Function<void(unsigned, unsigned, int)> texParameteri = find("glTexParameteri");
    Function<void(unsigned, unsigned, unsigned)> texBuffer = find("glTexBuffer");

    Function<Names> genFramebuffers = find("glGenFramebuffers");
    Function<ConstantNames> deleteFramebuffers = find("glDeleteFramebuffers");
    Function<TwoNames> bindFramebuffer = find("glBindFramebuffer");
    Function<void(unsigned, unsigned, unsigned, unsigned, int)> framebufferTexture2D = find("glFramebufferTexture2D");
    Function<unsigned(unsigned)> checkFramebufferStatus = find("glCheckFramebufferStatus");
    Function<void(int, const unsigned*)> drawBuffers = find("glDrawBuffers");
    Function<NameFunction> readBuffer = find("glReadBuffer");

    Function<NameFunction> enable = find("glEnable");
    Function<NameFunction> disable = find("glDisable");
    Function<NameFunction> cullFace = find("glCullFace");
    Function<NameFunction> frontFace = find("glFrontFace");
    Function<NameFunction> depthFunc = find("glDepthFunc");
    Function<void(unsigned char)> depthMask = find("glDepthMask");
    Function<void(unsigned char, unsigned char, unsigned char, unsigned char)> colorMask = find("glColorMask");
    Function<TwoNames> blendFunc = find("glBlendFunc");
    Function<NameFunction> blendEquation = find("glBlendEquation");
    Function<void(int, int, int, int)> viewport = find("glViewport");
    Function<void(unsigned, int, const float*)> clearBufferfv = find("glClearBufferfv");
    Function<void(unsigned, int, const unsigned*)> clearBufferuiv = find("glClearBufferuiv");
    Function<void(unsigned, int, int)> drawArrays = find("glDrawArrays");
    Function<void(unsigned, int, unsigned, const void*)> drawElements = find("glDrawElements");
    Function<void(unsigned, int)> pixelStorei = find("glPixelStorei");
    Function<void(int, int, int, int, unsigned, unsigned, void*)> readPixels = find("glReadPixels");

    Function<Names> genQueries = find("glGenQueries");
    Function<ConstantNames> deleteQueries = find("glDeleteQueries");
    Function<TwoNames> beginQuery = find("glBeginQuery");
    Function<NameFunction> endQuery = find("glEndQuery");
    Function<void(unsigned, unsigned, unsigned*)> getQueryObjectuiv = find("glGetQueryObjectuiv");

    Function<void(unsigned, int*)> getIntegerv = find("glGetIntegerv");
    Function<const unsigned char*(unsigned)> getString = find("glGetString");
    Function<unsigned()> getError = find("glGetError");
};

} // namespace tetra
