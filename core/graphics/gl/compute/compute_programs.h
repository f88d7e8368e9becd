// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_program.h"

#include <memory>

namespace tetra {

/// The programs that do on the graphics card what else the processor does for a volume's cells; their texts are in
/// resources/shaders, and say what they do.
struct ComputePrograms {
    std::unique_ptr<GlProgram> project;
    std::unique_ptr<GlProgram> classify;
    std::unique_ptr<GlProgram> face;
    std::unique_ptr<GlProgram> relax;
    std::unique_ptr<GlProgram> sums;
    std::unique_ptr<GlProgram> gather;
    std::unique_ptr<GlProgram> digits;
    std::unique_ptr<GlProgram> setUp;
    std::unique_ptr<GlProgram> draw; ///< of what setUp made, with the fragment shaders of PainterPrograms::volume
};

/// For a context that has passed checkCompute(). The error has the driver's own text.
Result<ComputePrograms> makeComputePrograms(const GlFunctions& gl);

} // namespace tetra
