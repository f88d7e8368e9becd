// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_functions.h"

#include <cstddef>

namespace tetra {

/// As in gl_functions.h; checked when compute_functions.cpp is compiled.
namespace gl {
inline constexpr unsigned shaderStorageBuffer = 0x90D2;
inline constexpr unsigned maximumShaderStorageBlockSize = 0x90DE;
inline constexpr unsigned dynamicCopy = 0x88EA;
inline constexpr unsigned textureFetchBarrier = 0x00000008;
inline constexpr unsigned bufferUpdateBarrier = 0x00000200;
inline constexpr unsigned shaderStorageBarrier = 0x00002000;
} // namespace gl

/// The functions of OpenGL 4.3 that compute shaders need besides those of GlFunctions.
struct ComputeFunctions {
    explicit ComputeFunctions(GetProcAddress getProcAddress) : find(std::move(getProcAddress)) {}

    FunctionFinder find;

    template <class Signature> using Function = GlFunctions::Function<Signature>;

    Function<void(unsigned, unsigned, unsigned)> dispatchCompute = find("glDispatchCompute");
    Function<void(unsigned)> memoryBarrier = find("glMemoryBarrier");
    Function<void(unsigned, unsigned, unsigned)> bindBufferBase = find("glBindBufferBase");
    Function<void(unsigned, std::ptrdiff_t, std::ptrdiff_t, void*)> getBufferSubData = find("glGetBufferSubData");
};

/// Whether the context that is current can run TAn's compute shaders. The error says what it lacks.
Status checkCompute(const GlFunctions& gl, const ComputeFunctions& functions);

} // namespace tetra
