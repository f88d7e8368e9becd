// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/compute_functions.h"

#include <GL/glcorearb.h>

#include <string>

namespace tetra {

static_assert(gl::shaderStorageBuffer == GL_SHADER_STORAGE_BUFFER);
static_assert(gl::maximumShaderStorageBlockSize == GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
static_assert(gl::dynamicCopy == GL_DYNAMIC_COPY && gl::textureFetchBarrier == GL_TEXTURE_FETCH_BARRIER_BIT);
static_assert(gl::bufferUpdateBarrier == GL_BUFFER_UPDATE_BARRIER_BIT);
static_assert(gl::shaderStorageBarrier == GL_SHADER_STORAGE_BARRIER_BIT);

Status checkCompute(const GlFunctions& gl, const ComputeFunctions& functions)
{
    int major = 0;
    int minor = 0;
    gl.getIntegerv(gl::majorVersion, &major);
    gl.getIntegerv(gl::minorVersion, &minor);
    if (major * 10 + minor < 43)
        return Error{ErrorKind::OutOfResource, "The OpenGL driver has version " + std::to_string(major) + "." +
                                                   std::to_string(minor) + "; compute shaders need 4.3."};
    if (!functions.find.missing().empty())
        return Error{ErrorKind::OutOfResource, "The OpenGL driver has no function " + functions.find.missing() + "."};
    return {};
}

} // namespace tetra
