#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Draws, of the translucent fragments behind the layer before, the nearest: the depth test picks it. Fragments of equal
// depth count as ordered by their triangle, so none is lost.
uniform vec4 colour;              // whose alpha is the opacity
uniform uint firstTriangle;       // number of the surface's first triangle in the scene
uniform float saturated;          // what lies behind this opacity cannot be seen
uniform sampler2D opaqueDepth;
uniform usampler2D previousLayer; // depth as bits, triangle number plus one
uniform sampler2D accumulated;    // all layers before

in vec3 surfaceColour;
in vec3 surfaceNormal;
in vec3 towardsEye;
in vec3 placeInMesh;

layout(location = 0) out vec4 layerColour;
layout(location = 1) out uvec2 layerKey;

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye);
bool isCutOff(vec3 place);

void main()
{
    if (isCutOff(placeInMesh))
        discard;
    ivec2 place = ivec2(gl_FragCoord.xy);
    uvec2 key = uvec2(floatBitsToUint(gl_FragCoord.z), firstTriangle + uint(gl_PrimitiveID) + 1u);
    uvec2 previous = texelFetch(previousLayer, place, 0).xy;
    bool peeled = key.x < previous.x || (key.x == previous.x && key.y <= previous.y);
    bool hidden = gl_FragCoord.z >= texelFetch(opaqueDepth, place, 0).x;
    if (peeled || hidden || texelFetch(accumulated, place, 0).w > saturated)
        discard;
    layerColour = vec4(lit(surfaceColour, surfaceNormal, towardsEye) * colour.a, colour.a);
    layerKey = key;
}
