#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a layer to the blending, which puts it under what is accumulated.
uniform sampler2D layer;

layout(location = 0) out vec4 result;

void main()
{
    result = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
}
