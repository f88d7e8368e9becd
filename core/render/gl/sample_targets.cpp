// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/sample_targets.h"

#include "core/render/resolve.h"

#include <tan/render.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <string>

namespace tetra {

namespace {

/// Of glTexImage2D.
struct TextureFormat {
    unsigned internal;
    unsigned format;
    unsigned type;
};

constexpr TextureFormat colourFormat{gl::rgba16f, gl::rgba, gl::floatType};
constexpr TextureFormat fineColourFormat{gl::rgba32f, gl::rgba, gl::floatType};
constexpr TextureFormat depthFormat{gl::depthComponent32f, gl::depthComponent, gl::floatType};
constexpr TextureFormat keyFormat{gl::rg32ui, gl::rgInteger, gl::unsignedInt};

/// A texture whose texels are read as they are.
GlObject makeTexture(const GlFunctions& gl, int width, int height, const TextureFormat& format)
{
    GlObject texture(gl.genTextures, gl.deleteTextures);
    gl.bindTexture(gl::texture2D, texture.name());
    gl.texImage2D(gl::texture2D, 0, static_cast<int>(format.internal), width, height, 0, format.format, format.type,
                  nullptr);
    gl.texParameteri(gl::texture2D, gl::textureMinFilter, static_cast<int>(gl::nearest));
    gl.texParameteri(gl::texture2D, gl::textureMagFilter, static_cast<int>(gl::nearest));
    gl.bindTexture(gl::texture2D, 0);
    return texture;
}

/// Of textures; 0 is no depth. Stays bound.
GlObject makeFramebuffer(const GlFunctions& gl, std::initializer_list<unsigned> colours, unsigned depthTexture)
{
    GlObject object(gl.genFramebuffers, gl.deleteFramebuffers);
    gl.bindFramebuffer(gl::framebuffer, object.name());
    std::array<unsigned, 2> attachments{};
    unsigned count = 0;
    for (const unsigned texture : colours) {
        attachments[count] = gl::colourAttachment0 + count;
        gl.framebufferTexture2D(gl::framebuffer, attachments[count++], gl::texture2D, texture, 0);
    }
    if (depthTexture != 0)
        gl.framebufferTexture2D(gl::framebuffer, gl::depthAttachment, gl::texture2D, depthTexture, 0);
    gl.drawBuffers(static_cast<int>(count), attachments.data());
    if (count == 0)
        gl.readBuffer(gl::none); // OpenGL 3.3 does not take it for complete otherwise
    return object;
}

/// Of the framebuffer that was made last, and of the memory for all.
Status checkFramebuffer(const GlFunctions& gl)
{
    const bool complete = gl.checkFramebufferStatus(gl::framebuffer) == gl::framebufferComplete;
    if (gl.getError() == gl::outOfMemory)
        return Error{ErrorKind::OutOfResource,
                     Message::say("The graphics card does not have enough memory for a picture of this size. Make it "
                                  "smaller, or use the CPU back end.")};
    if (!complete)
        return Error{ErrorKind::OutOfResource,
                     Message::say("The OpenGL driver cannot draw into floating-point textures, which OpenGL 3.3 "
                                  "requires. Use the CPU back end.")};
    return {};
}

} // namespace

int largestTargetSide(const GlFunctions& gl)
{
    int limit = 0;
    gl.getIntegerv(gl::maximumTextureSize, &limit);
    return limit;
}

Status makeSampleTargets(const GlFunctions& gl, int width, int height, SampleTargets& targets)
{
    const int limit = largestTargetSide(gl);
    if (std::max(width, height) > limit)
        return Error{ErrorKind::OutOfResource,
                     Message::say("This OpenGL driver draws at most %1 samples per side. Make the picture smaller, use "
                                  "fewer samples, or use the CPU back end.",
                                  limit)};
    targets.width = width;
    targets.height = height;
    targets.opaqueColour = makeTexture(gl, targets.width, targets.height, colourFormat);
    targets.opaqueDepth = makeTexture(gl, targets.width, targets.height, depthFormat);
    targets.opaqueFramebuffer = makeFramebuffer(gl, {targets.opaqueColour.name()}, targets.opaqueDepth.name());
    return checkFramebuffer(gl);
}

Status makeAccumulated(const GlFunctions& gl, bool fine, SampleTargets& targets)
{
    if (targets.accumulated.name() != 0 && targets.fine == fine)
        return {};
    targets.accumulated = makeTexture(gl, targets.width, targets.height, fine ? fineColourFormat : colourFormat);
    targets.gathered = {}; // has the depth
    targets.gatheredFramebuffer = {};
    if (fine) {
        targets.saturatedDepth = makeTexture(gl, targets.width, targets.height, depthFormat);
        targets.saturatedFramebuffer = makeFramebuffer(gl, {}, targets.saturatedDepth.name());
    }
    targets.accumulatedFramebuffer =
        makeFramebuffer(gl, {targets.accumulated.name()}, fine ? targets.saturatedDepth.name() : 0);
    targets.fine = fine;
    return checkFramebuffer(gl);
}

Status makeGathered(const GlFunctions& gl, SampleTargets& targets)
{
    if (targets.gathered.name() != 0)
        return {};
    targets.gathered = makeTexture(gl, targets.width, targets.height, fineColourFormat);
    targets.gatheredFramebuffer = makeFramebuffer(gl, {targets.gathered.name()}, targets.saturatedDepth.name());
    return checkFramebuffer(gl);
}

Status makeLayers(const GlFunctions& gl, SampleTargets& targets)
{
    if (targets.layerColour.name() != 0)
        return {};
    targets.layerColour = makeTexture(gl, targets.width, targets.height, colourFormat);
    targets.layerDepth = makeTexture(gl, targets.width, targets.height, depthFormat);
    for (std::size_t i = 0; i < 2; ++i) {
        targets.layerKeys[i] = makeTexture(gl, targets.width, targets.height, keyFormat);
        targets.layerFramebuffers[i] =
            makeFramebuffer(gl, {targets.layerColour.name(), targets.layerKeys[i].name()}, targets.layerDepth.name());
    }
    return checkFramebuffer(gl);
}

Status MedianDepth::prepare(int width, int height)
{
    current_ = 0;
    if (width == width_ && height == height_)
        return {};
    width_ = height_ = 0;
    middle_ = makeTexture(gl_, width, height, {gl::r32f, gl::red, gl::floatType});
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        ranges_[i] = makeTexture(gl_, width, height, {gl::rg32f, gl::rg, gl::floatType});
        framebuffers_[i] = makeFramebuffer(gl_, {ranges_[i].name(), middle_.name()}, 0);
    }
    if (Status status = checkFramebuffer(gl_); !status)
        return status;
    width_ = width;
    height_ = height;
    return {};
}

void MedianDepth::bindStep(const GlProgram& program, const SampleTargets& targets, bool first) const
{
    gl_.bindFramebuffer(gl::framebuffer, framebuffers_[1 - current_].name());
    program.use();
    program.setTexture("range", 0, ranges_[current_].name());
    program.setTexture("accumulated", 1, targets.accumulated.name());
    program.setTexture("opaqueDepth", 2, targets.opaqueDepth.name());
    program.set("first", first ? 1 : 0);
}

std::vector<float> MedianDepth::read() const
{
    const std::size_t samples = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    std::vector<std::array<float, 2>> ranges(samples);
    gl_.bindFramebuffer(gl::framebuffer, framebuffers_[current_].name());
    gl_.pixelStorei(gl::packAlignment, 1);
    gl_.readPixels(0, 0, width_, height_, gl::rg, gl::floatType, ranges.data());
    std::vector<float> depths;
    depths.reserve(samples);
    for (const auto& [before, after] : ranges)
        depths.push_back(after);
    return depths;
}

namespace {

/// The distance from the eye along the view's axis.
float distanceOfDepth(float depth, const Eigen::Matrix4d& projection, bool perspective)
{
    if (!(depth < 1))
        return std::numeric_limits<float>::infinity();
    const double clip = 2.0 * depth - 1;
    const double a = projection(2, 2), b = projection(2, 3);
    return static_cast<float>(perspective ? b / (clip + a) : (b - clip) / a);
}

} // namespace

std::vector<float> pixelDepths(std::span<float> samples, const SampleView& view, int samplesPerAxis)
{
    const double aspectRatio = static_cast<double>(view.width) / view.height;
    const Eigen::Matrix4d projection = projectionMatrix(view.camera, aspectRatio, view.bounds);
    for (float& sample : samples)
        sample = distanceOfDepth(sample, projection, view.camera.perspective);
    const int width = view.part.width();
    for (auto first = samples.begin(), last = samples.end(); last - first > width; first += width) {
        last -= width;
        std::swap_ranges(first, first + width, last);
    }
    Picture picture{width / samplesPerAxis, view.part.height() / samplesPerAxis, {}};
    picture.depth.resize(samples.size() / static_cast<std::size_t>(samplesPerAxis * samplesPerAxis));
    resolveDepth(samples, width, samplesPerAxis, 0, 0, picture);
    return picture.depth;
}

} // namespace tetra
