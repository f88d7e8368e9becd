// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/storage_buffer.h"

#include <algorithm>

namespace tetra {
namespace {

/// As in compute.glsl.
constexpr std::size_t itemsPerGroup = 256;
/// Every OpenGL 4.3 allows twice as many groups in each dimension.
constexpr std::size_t groupsPerRow = 1 << 15;
constexpr std::size_t leastBytes = 16;

} // namespace

void StorageBuffer::reserve(const ComputeContext& context, std::size_t bytes)
{
    bytes = std::max(bytes, leastBytes);
    if (bytes <= bytes_)
        return;
    const GlFunctions& gl = context.gl;
    buffer_ = {gl.genBuffers, gl.deleteBuffers}; // a new one: a texture of the old one would keep its size
    textured_ = 0;
    bytes_ = bytes;
    gl.bindBuffer(gl::shaderStorageBuffer, buffer_.name());
    gl.bufferData(gl::shaderStorageBuffer, static_cast<std::ptrdiff_t>(bytes), nullptr, gl::dynamicCopy);
    gl.bindBuffer(gl::shaderStorageBuffer, 0);
}

void StorageBuffer::fill(const ComputeContext& context, std::span<const std::byte> data)
{
    if (data.size() < leastBytes) {
        std::byte padded[leastBytes]{};
        std::ranges::copy(data, padded);
        fill(context, padded);
        return;
    }
    const GlFunctions& gl = context.gl;
    buffer_ = {gl.genBuffers, gl.deleteBuffers};
    textured_ = 0;
    bytes_ = data.size();
    gl.bindBuffer(gl::shaderStorageBuffer, buffer_.name());
    gl.bufferData(gl::shaderStorageBuffer, static_cast<std::ptrdiff_t>(bytes_), data.data(), gl::dynamicCopy);
    gl.bindBuffer(gl::shaderStorageBuffer, 0);
}

void StorageBuffer::read(const ComputeContext& context, std::size_t firstByte, std::span<std::byte> to) const
{
    context.compute.memoryBarrier(gl::bufferUpdateBarrier);
    context.gl.bindBuffer(gl::shaderStorageBuffer, buffer_.name());
    context.compute.getBufferSubData(gl::shaderStorageBuffer, static_cast<std::ptrdiff_t>(firstByte),
                                     static_cast<std::ptrdiff_t>(to.size()), to.data());
    context.gl.bindBuffer(gl::shaderStorageBuffer, 0);
}

void StorageBuffer::makeTexture(const ComputeContext& context, unsigned format)
{
    if (textured_ == buffer_.name())
        return;
    const GlFunctions& gl = context.gl;
    texture_ = {gl.genTextures, gl.deleteTextures};
    textured_ = buffer_.name();
    gl.bindTexture(gl::textureBuffer, texture_.name());
    gl.texBuffer(gl::textureBuffer, format, buffer_.name());
    gl.bindTexture(gl::textureBuffer, 0);
}

void bindStorage(const ComputeContext& context, std::initializer_list<const StorageBuffer*> buffers)
{
    unsigned binding = 0;
    for (const StorageBuffer* buffer : buffers)
        context.compute.bindBufferBase(gl::shaderStorageBuffer, binding++, buffer->name());
}

void runFor(const ComputeContext& context, std::size_t items)
{
    const std::size_t groups = (items + itemsPerGroup - 1) / itemsPerGroup;
    if (groups == 0)
        return;
    const std::size_t columns = std::min(groups, groupsPerRow);
    const std::size_t rows = (groups + columns - 1) / columns;
    context.compute.memoryBarrier(gl::shaderStorageBarrier | gl::textureFetchBarrier);
    context.compute.dispatchCompute(static_cast<unsigned>(columns), static_cast<unsigned>(rows), 1);
    context.compute.memoryBarrier(gl::shaderStorageBarrier | gl::textureFetchBarrier);
}

} // namespace tetra
