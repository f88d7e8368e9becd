// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/gl_functions.h"

namespace tetra {

/// Errors that somebody else left would be taken for ours.
void forgetErrors(const GlFunctions& gl);

/// What drawing starts from, whatever somebody else left: depth test on, blending and everything else off.
void setDrawingState(const GlFunctions& gl);
/// Blending with what is in front, without depth test; and back.
void startBlendingUnder(const GlFunctions& gl);
void endBlending(const GlFunctions& gl);
/// Binds no program, no vertex array and no texture; no depth test.
void leaveDrawingState(const GlFunctions& gl);

} // namespace tetra
