// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/half_light.h"

namespace tetra {

Status HalfLight::prepare(int width, int height)
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
    if (Status status = checkComplete(gl_); !status)
        return status;
    width_ = width;
    height_ = height;
    return {};
}

void HalfLight::bindStep(const GlProgram& program, const SampleTargets& targets, bool first) const
{
    gl_.bindFramebuffer(gl::framebuffer, framebuffers_[1 - current_].name());
    program.use();
    program.setTexture("range", 0, ranges_[current_].name());
    program.setTexture("accumulated", 1, targets.accumulated.name());
    program.setTexture("opaqueDepth", 2, targets.opaqueDepth.name());
    program.set("first", first ? 1 : 0);
}

std::vector<float> HalfLight::read() const
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

} // namespace tetra
