#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Halves the range of depths in which half of the light from behind is lost. `accumulated` is what lies before the middle
// of the range; at first, before what is opaque.
uniform sampler2D range;
uniform sampler2D accumulated;
uniform sampler2D opaqueDepth;
uniform bool first;

layout(location = 0) out vec2 narrowed;
layout(location = 1) out float middle;

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    bool lost = texelFetch(accumulated, place, 0).a >= 0.5;
    float opaque = texelFetch(opaqueDepth, place, 0).x;
    vec2 before = texelFetch(range, place, 0).xy;
    float halfway = 0.5 * (before.x + before.y);
    if (first)
        narrowed = vec2(lost ? 0.0 : opaque, opaque);
    else
        narrowed = lost ? vec2(before.x, halfway) : vec2(halfway, before.y);
    middle = 0.5 * (narrowed.x + narrowed.y);
}
