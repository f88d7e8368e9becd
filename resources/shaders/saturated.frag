#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Marks by the nearest depth the samples that let so little through that nothing behind can be seen.
uniform sampler2D accumulated;
uniform float saturated;

void main()
{
    if (texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0).a < saturated)
        discard;
    gl_FragDepth = 0.0;
}
