#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The light of a piece of a ray by an optical model of somebody's own (OpticalModel), in place of slab.frag.
uniform samplerBuffer segments; // as in slab.frag
uniform vec2 smallestValue;     // as in image.glsl
uniform float perValue;
uniform float unit;             // of w, in the units of the dataset

flat in float perGradient;

vec4 lightOfPiece(float entry, float exit, float way, float gradient);

vec4 lightOfSlabs(ivec2 range, bool fromOrigin, float valueIn, float valueOut, float way, vec4 lightAlong, vec2 partAlong)
{
    float origin = fromOrigin ? texelFetch(segments, 3 * range.x).z : 0.0;
    float entry = (valueIn + origin) / perValue + smallestValue.y + smallestValue.x;
    float exit = (valueOut + origin) / perValue + smallestValue.y + smallestValue.x;
    float gradient = perGradient > 0.0 ? 1.0 / (perGradient * perValue * unit) : 0.0;
    vec4 light = lightOfPiece(entry, exit, way * unit, gradient);
    // What is no number is 0.
    float opacity = light.a > 0.0 ? min(light.a, 1.0) : 0.0;
    vec3 colour = mix(vec3(0.0), min(light.rgb, vec3(opacity)), greaterThan(light.rgb, vec3(0.0)));
    return vec4(colour, opacity);
}
