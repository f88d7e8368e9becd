// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/gl_object.h"

#include <cstddef>
#include <span>

namespace tetra {

/// An array that shaders read as a texture.
struct TextureBuffer {
    GlObject buffer;
    GlObject texture;
};

/// Sends `data` into `target`, which is made if it is empty; `format` is that of a texel and stays the same.
void fillTextureBuffer(const GlFunctions& gl, TextureBuffer& target, unsigned format, std::span<const std::byte> data,
                       unsigned usage = gl::staticDraw);

} // namespace tetra
