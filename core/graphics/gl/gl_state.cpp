// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/gl_state.h"

#include "core/graphics/gl/gl_program.h"

namespace tetra {

void forgetErrors(const GlFunctions& gl)
{
    // A lost context gives them without end.
    for (int i = 0; i < 16 && gl.getError() != 0; ++i) {
    }
}

void setDrawingState(const GlFunctions& gl)
{
    for (const unsigned state :
         {gl::blend, gl::cullFace, gl::scissorTest, gl::stencilTest, gl::dither, gl::framebufferSrgb})
        gl.disable(state);
    gl.enable(gl::depthTest);
    gl.depthFunc(gl::less);
    gl.depthMask(1);
    gl.colorMask(1, 1, 1, 1);
}

void startBlendingUnder(const GlFunctions& gl)
{
    gl.disable(gl::depthTest);
    gl.enable(gl::blend);
    gl.blendFunc(gl::oneMinusDestinationAlpha, gl::one);
}

void endBlending(const GlFunctions& gl)
{
    gl.disable(gl::blend);
    gl.enable(gl::depthTest);
}

void leaveDrawingState(const GlFunctions& gl)
{
    gl.disable(gl::depthTest);
    gl.useProgram(0);
    gl.bindVertexArray(0);
    for (unsigned unit = textureUnits; unit-- > 0;) {
        gl.activeTexture(gl::texture0 + unit);
        gl.bindTexture(gl::texture2D, 0);
        gl.bindTexture(gl::textureBuffer, 0);
    }
}

} // namespace tetra
