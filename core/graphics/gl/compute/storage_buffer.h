// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/compute/compute_functions.h"
#include "core/graphics/gl/gl_object.h"

#include <cstddef>
#include <initializer_list>
#include <span>

namespace tetra {

/// What compute shaders need of the context that is current: OpenGL's functions. Both must outlive all who hold it.
struct ComputeContext {
    const GlFunctions& gl;
    const ComputeFunctions& compute;
};

/// An array in the memory of the graphics card that compute shaders read and write. The context must be current for
/// everything, also when it goes.
class StorageBuffer {
public:
    /// Makes room for `bytes`, what was in it is lost; room that is large enough is kept.
    void reserve(const ComputeContext& context, std::size_t bytes);
    /// Makes it `data`; at least one word, so that it can be bound.
    void fill(const ComputeContext& context, std::span<const std::byte> data);
    /// Reads a part of it, when all that was asked for before is done.
    void read(const ComputeContext& context, std::size_t firstByte, std::span<std::byte> to) const;

    unsigned name() const noexcept { return buffer_.name(); }
    /// Makes a texture by which other shaders read it, if there is none of it as it is now; the format of a texel stays
    /// the same. Binds and unbinds it in the texture unit that is active.
    void makeTexture(const ComputeContext& context, unsigned format);
    unsigned texture() const noexcept { return texture_.name(); } ///< what makeTexture() made

private:
    GlObject buffer_;
    GlObject texture_;
    unsigned textured_ = 0; ///< the buffer that the texture is of
    std::size_t bytes_ = 0;
};

/// Binds buffers to the numbers from 0 on.
void bindStorage(const ComputeContext& context, std::initializer_list<const StorageBuffer*> buffers);

/// Runs the program in use, which begins with compute.glsl, for so many items; what ran before is seen, and what it
/// writes is seen by everything after.
void runFor(const ComputeContext& context, std::size_t items);

} // namespace tetra
