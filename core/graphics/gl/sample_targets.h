// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_object.h"

#include <array>
#include <initializer_list>

namespace tetra {

/// Of glTexImage2D.
struct TextureFormat {
    unsigned internal;
    unsigned format;
    unsigned type;
};

/// A texture whose texels are read as they are.
GlObject makeTexture(const GlFunctions& gl, int width, int height, const TextureFormat& format);
/// Of textures; 0 is no depth. Stays bound.
GlObject makeFramebuffer(const GlFunctions& gl, std::initializer_list<unsigned> colours, unsigned depthTexture);
/// Of the framebuffer that was made last, and of the memory for all.
Status checkComplete(const GlFunctions& gl);

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
/// Adds, if it is not there, what translucent surfaces need: 28 bytes a sample.
Status makeLayers(const GlFunctions& gl, SampleTargets& targets);

} // namespace tetra
