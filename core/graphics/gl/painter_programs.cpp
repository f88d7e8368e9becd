// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/painter_programs.h"

#include <array>
#include <string>
#include <tan_shaders.h>

namespace tetra {

Result<PainterPrograms> makePainterPrograms(const GlFunctions& gl)
{
    PainterPrograms programs;
    Status status;
    const auto make = [&](std::unique_ptr<GlProgram>& program, const char* vertexShader,
                          std::span<const char* const> fragmentShaders) {
        if (!status)
            return;
        Result<std::unique_ptr<GlProgram>> made = GlProgram::make(gl, vertexShader, fragmentShaders);
        if (made)
            program = std::move(*made);
        else
            status = made.error();
    };
    make(programs.opaque, shaders::surfaceVert,
         std::array{shaders::opaqueFrag, shaders::lightingFrag, shaders::cutFrag});
    make(programs.peel, shaders::surfaceVert, std::array{shaders::peelFrag, shaders::lightingFrag, shaders::cutFrag});
    make(programs.line, shaders::lineVert, std::array{shaders::lineFrag});
    make(programs.under, shaders::screenVert, std::array{shaders::underFrag});
    make(programs.resolve, shaders::screenVert, std::array{shaders::resolveFrag});
    make(programs.saturated, shaders::screenVert, std::array{shaders::saturatedFrag});
    make(programs.bisect, shaders::screenVert, std::array{shaders::bisectFrag});
    const std::string volumeVertexShader = std::string("#version 330 core\n") + shaders::imageGlsl + shaders::cellGlsl +
                                           shaders::facesGlsl + shaders::volumeVert;
    make(programs.volume, volumeVertexShader.c_str(),
         std::array{shaders::volumeFrag, shaders::slabFrag, shaders::focusFrag});
    if (!status)
        return status.error();
    return programs;
}

} // namespace tetra
