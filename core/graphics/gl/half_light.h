// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_program.h"
#include "core/graphics/gl/sample_targets.h"

#include <array>
#include <vector>

namespace tetra {

/// Finds the depth at which half of the light from behind is lost, for each sample by bisection: translucent things are
/// drawn again and again, each time only up to the middle of the range that is left. Blending cannot tell a fragment
/// how much light is left, so there is no way in one pass. The context must be current for everything; `gl` must
/// outlive it.
class HalfLight {
public:
    explicit HalfLight(const GlFunctions& gl) : gl_(gl) {}

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

} // namespace tetra
