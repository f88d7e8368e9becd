// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/compute_programs.h"

#include "core/graphics/gl/volume_shaders.h"

#include <initializer_list>
#include <string>
#include <tan_shaders.h>

namespace tetra {

Result<ComputePrograms> makeComputePrograms(const GlFunctions& gl)
{
    ComputePrograms programs;
    Status status;
    const auto take = [&](std::unique_ptr<GlProgram>& program, Result<std::unique_ptr<GlProgram>> made) {
        if (made)
            program = std::move(*made);
        else
            status = made.error();
    };
    const auto make = [&](std::unique_ptr<GlProgram>& program, std::initializer_list<const char*> parts) {
        std::string text = shaders::computeGlsl;
        for (const char* part : parts)
            text += part;
        if (status)
            take(program, GlProgram::makeCompute(gl, text.c_str()));
    };
    make(programs.project, {shaders::imageGlsl, shaders::projectComp});
    make(programs.classify, {shaders::classifyComp});
    make(programs.face, {shaders::faceComp});
    make(programs.relax, {shaders::relaxComp});
    make(programs.sums, {shaders::sumsComp});
    make(programs.gather, {shaders::gatherComp});
    make(programs.digits, {shaders::digitsComp});
    make(programs.setUp, {shaders::imageGlsl, shaders::cellGlsl, shaders::setupComp});
    const std::string vertexShader = cellVertexShader(shaders::setupVert);
    if (status)
        take(programs.draw, GlProgram::make(gl, vertexShader.c_str(), volumeFragmentShaders()));
    if (!status)
        return status.error();
    return programs;
}

} // namespace tetra
