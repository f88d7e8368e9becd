// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_buffers.h"
#include "core/render/gl/gl_program.h"
#include "core/render/view_transform.h"

#include <tan/base.h>
#include <tan/render.h>

#include <array>
#include <span>
#include <vector>

namespace tetra {

/// From where, which samples of a picture, and what box near and far enclose.
struct SampleView {
    Camera camera;
    int width = 1; ///< of the whole picture
    int height = 1;
    SampleRectangle part; ///< that is drawn
    Eigen::AlignedBox3d bounds;
    bool amongRays = false; ///< samples lie where the CPU back end has the rays of a volume, else in the middle
};

/// The textures that a picture's samples are drawn into. Colours are half floats, since many layers of 8 bits would add
/// up their rounding.
struct SampleTargets {
    int width = 0;
    int height = 0;

    GlObject opaqueColour;
    GlObject opaqueDepth;
    GlObject opaqueFramebuffer;

    /// For translucency only; empty until makeAccumulated.
    GlObject accumulated;
    GlObject accumulatedFramebuffer;
    bool fine = false; ///< whole floats
    /// The nearest depth where nothing behind can be seen any more, else the farthest; also of accumulatedFramebuffer.
    /// Only if fine.
    GlObject saturatedDepth;
    GlObject saturatedFramebuffer;

    /// What the pieces of rays make together, in whole floats, where that is not yet their light; empty until
    /// makeGathered. The depth is saturatedDepth.
    GlObject gathered;
    GlObject gatheredFramebuffer;

    /// Empty until makeLayers. Two layers, since each is compared with the one before.
    GlObject layerColour;
    GlObject layerDepth;
    std::array<GlObject, 2> layerKeys;
    std::array<GlObject, 2> layerFramebuffers;
};

/// 12 bytes a sample. Errors: larger than the driver allows, out of memory.
Status makeSampleTargets(const GlFunctions& gl, int width, int height, SampleTargets& targets);
/// Adds, if it is not there, what translucent things are gathered in: 8 bytes a sample; if `fine`, 20, as the light of
/// many faint cells is lost in the rounding of half floats.
Status makeAccumulated(const GlFunctions& gl, bool fine, SampleTargets& targets);
/// Adds, if it is not there, what the pieces of rays are gathered in for OpticalModel::lightOfRay: 16 bytes a sample.
/// After makeAccumulated, which has made fine ones.
Status makeGathered(const GlFunctions& gl, SampleTargets& targets);
/// Adds, if it is not there, what translucent surfaces need: 28 bytes a sample.
Status makeLayers(const GlFunctions& gl, SampleTargets& targets);

/// The longest side that the driver allows.
int largestTargetSide(const GlFunctions& gl);

/// Finds the depth at which half of the light from behind is lost, for each sample by bisection: translucent things are
/// drawn again and again, each time only up to the middle of the range that is left. Blending cannot tell a fragment
/// how much light is left, so there is no way in one pass. The context must be current for everything; `gl` must
/// outlive it.
class MedianDepth {
public:
    explicit MedianDepth(const GlFunctions& gl) : gl_(gl) {}

    /// So often a range is halved: depths are exact to what floats tell apart.
    static constexpr int steps = 24;

    /// 20 bytes a sample. Error: out of memory.
    Status prepare(int width, int height);
    /// Binds all for a step, which is one drawing over the whole screen; then callers call stepDone(). In the first
    /// step targets.accumulated has all that is translucent, in others what lies before nearest().
    void bindStep(const GlProgram& program, const SampleTargets& targets, bool first) const;
    void stepDone() noexcept { current_ = 1 - current_; }
    /// The texture of depths up to which the next step wants things drawn.
    unsigned nearest() const noexcept { return middle_.name(); }
    /// The depths in [0, 1] as OpenGL has them, rows upwards; 1 where half is never lost. May throw std::bad_alloc.
    std::vector<float> read() const;

private:
    const GlFunctions& gl_;
    int width_ = 0;
    int height_ = 0;
    GlObject middle_;
    std::array<GlObject, 2> ranges_;
    std::array<GlObject, 2> framebuffers_;
    std::size_t current_ = 0; ///< the range found last
};

/// Picture::depth from the depths of samples as OpenGL has them: in [0, 1], rows upwards, 1 for nothing. Changes them.
std::vector<float> pixelDepths(std::span<float> samples, const SampleView& view, int samplesPerAxis);

} // namespace tetra
