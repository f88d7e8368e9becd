// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/graphics/gl/gl_program.h"

#include <memory>

namespace tetra {

/// The programs of ScenePainter; their texts are in resources/shaders.
struct PainterPrograms {
    std::unique_ptr<GlProgram> opaque;
    std::unique_ptr<GlProgram> peel;
    std::unique_ptr<GlProgram> line;
    std::unique_ptr<GlProgram> under;
    std::unique_ptr<GlProgram> resolve;
    std::unique_ptr<GlProgram> volume;
    std::unique_ptr<GlProgram> saturated;
    std::unique_ptr<GlProgram> bisect;
};

Result<PainterPrograms> makePainterPrograms(const GlFunctions& gl);

} // namespace tetra
