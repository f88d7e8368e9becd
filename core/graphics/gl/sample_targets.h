// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_object.h"

#include <array>

namespace tetra {

/// The textures that a picture's samples are drawn into. Colours are half floats, since many layers of 8 bits would add
/// up their rounding.
struct SampleTargets {
    int width = 0;
    int height = 0;

    GlObject opaqueColour;
    GlObject opaqueDepth;
    GlObject opaqueFramebuffer;

    /// For translucency only; empty until makeLayers. Two layers, since each is compared with the one before.
    GlObject accumulated;
    GlObject accumulatedFramebuffer;
    GlObject layerColour;
    GlObject layerDepth;
    std::array<GlObject, 2> layerKeys;
    std::array<GlObject, 2> layerFramebuffers;

    bool hasLayers() const noexcept { return accumulated.name() != 0; }
};

/// 12 bytes a sample. Errors: larger than the driver allows, out of memory.
Result<SampleTargets> makeSampleTargets(const GlFunctions& gl, int width, int height);
/// Adds what translucency needs: 36 bytes a sample more.
Status makeLayers(const GlFunctions& gl, SampleTargets& targets);

} // namespace tetra
