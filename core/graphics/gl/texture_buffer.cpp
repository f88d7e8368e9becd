// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/texture_buffer.h"

namespace tetra {

void fillTextureBuffer(const GlFunctions& gl, TextureBuffer& target, unsigned format, std::span<const std::byte> data,
                       unsigned usage)
{
    const bool isNew = target.buffer.name() == 0;
    if (isNew)
        target = {{gl.genBuffers, gl.deleteBuffers}, {gl.genTextures, gl.deleteTextures}};
    gl.bindBuffer(gl::textureBuffer, target.buffer.name());
    gl.bufferData(gl::textureBuffer, static_cast<std::ptrdiff_t>(data.size()), data.data(), usage);
    gl.bindBuffer(gl::textureBuffer, 0);
    if (!isNew)
        return;
    gl.bindTexture(gl::textureBuffer, target.texture.name());
    gl.texBuffer(gl::textureBuffer, format, target.buffer.name());
    gl.bindTexture(gl::textureBuffer, 0);
}

} // namespace tetra
