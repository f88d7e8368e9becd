// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/gl_functions.h"

#include <GL/glcorearb.h>

namespace tetra {

static_assert(gl::none == GL_NONE);
static_assert(gl::triangles == GL_TRIANGLES && gl::less == GL_LESS && gl::lessOrEqual == GL_LEQUAL &&
              gl::one == GL_ONE);
static_assert(gl::oneMinusDestinationAlpha == GL_ONE_MINUS_DST_ALPHA);
static_assert(gl::depthTest == GL_DEPTH_TEST && gl::blend == GL_BLEND && gl::cullFace == GL_CULL_FACE);
static_assert(gl::front == GL_FRONT && gl::counterclockwise == GL_CCW);
static_assert(gl::scissorTest == GL_SCISSOR_TEST && gl::stencilTest == GL_STENCIL_TEST);
static_assert(gl::dither == GL_DITHER && gl::framebufferSrgb == GL_FRAMEBUFFER_SRGB);
static_assert(gl::packAlignment == GL_PACK_ALIGNMENT && gl::maximumTextureSize == GL_MAX_TEXTURE_SIZE);
static_assert(gl::texture2D == GL_TEXTURE_2D && gl::texture0 == GL_TEXTURE0);
static_assert(gl::textureBuffer == GL_TEXTURE_BUFFER && gl::maximumTextureBufferSize == GL_MAX_TEXTURE_BUFFER_SIZE);
static_assert(gl::textureMinFilter == GL_TEXTURE_MIN_FILTER && gl::textureMagFilter == GL_TEXTURE_MAG_FILTER);
static_assert(gl::nearest == GL_NEAREST && gl::unsignedByte == GL_UNSIGNED_BYTE);
static_assert(gl::unsignedInt == GL_UNSIGNED_INT && gl::floatType == GL_FLOAT);
static_assert(gl::depthComponent == GL_DEPTH_COMPONENT && gl::rgba == GL_RGBA && gl::rgInteger == GL_RG_INTEGER);
static_assert(gl::rgba8 == GL_RGBA8 && gl::rgba16f == GL_RGBA16F && gl::rg32ui == GL_RG32UI);
static_assert(gl::red == GL_RED && gl::rg == GL_RG && gl::r32f == GL_R32F && gl::rg32f == GL_RG32F);
static_assert(gl::rgba32f == GL_RGBA32F && gl::rgba32ui == GL_RGBA32UI && gl::rg16ui == GL_RG16UI);
static_assert(gl::depthComponent32f == GL_DEPTH_COMPONENT32F);
static_assert(gl::majorVersion == GL_MAJOR_VERSION && gl::minorVersion == GL_MINOR_VERSION);
static_assert(gl::renderer == GL_RENDERER && gl::outOfMemory == GL_OUT_OF_MEMORY);
static_assert(gl::vertexShader == GL_VERTEX_SHADER && gl::fragmentShader == GL_FRAGMENT_SHADER);
static_assert(gl::compileStatus == GL_COMPILE_STATUS && gl::linkStatus == GL_LINK_STATUS);
static_assert(gl::infoLogLength == GL_INFO_LOG_LENGTH);
static_assert(gl::arrayBuffer == GL_ARRAY_BUFFER && gl::elementArrayBuffer == GL_ELEMENT_ARRAY_BUFFER);
static_assert(gl::staticDraw == GL_STATIC_DRAW && gl::streamDraw == GL_STREAM_DRAW);
static_assert(gl::framebuffer == GL_FRAMEBUFFER && gl::colourAttachment0 == GL_COLOR_ATTACHMENT0);
static_assert(gl::depthAttachment == GL_DEPTH_ATTACHMENT && gl::framebufferComplete == GL_FRAMEBUFFER_COMPLETE);
static_assert(gl::colour == GL_COLOR && gl::depth == GL_DEPTH);
static_assert(gl::anySamplesPassed == GL_ANY_SAMPLES_PASSED && gl::samplesPassed == GL_SAMPLES_PASSED);
static_assert(gl::queryResult == GL_QUERY_RESULT);

} // namespace tetra
