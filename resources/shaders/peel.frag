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
uniform int shareCount;           // FocusShare of the surface; 0 regions if it has none
uniform bool shareOfFine;
uniform vec4 shareShapes[16];     // half of a box; of a ball the radius, in each coordinate; 1 if it is a ball
uniform vec4 sharePlaces[16];     // a region's middle, as placeInMesh, and its border

in vec3 surfaceColour;
in vec3 surfaceNormal;
in vec3 towardsEye;
in vec3 placeInMesh;

layout(location = 0) out vec4 layerColour;
layout(location = 1) out uvec2 layerKey;

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye);
bool isCutOff(vec3 place);

// Of what two resolutions show the part of this one, as opacityAt() in core/render/focus_weight.cpp.
float opacityHere()
{
    if (shareCount == 0)
        return colour.a;
    float ofFine = 0.0;
    for (int region = 0; region < shareCount; ++region) {
        vec4 shape = shareShapes[region];
        vec3 place = placeInMesh - sharePlaces[region].xyz;
        float away = shape.w > 0.0 ? max(0.0, length(place) - shape.x) : length(max(abs(place) - shape.xyz, 0.0));
        float border = sharePlaces[region].w;
        ofFine = max(ofFine, away <= 0.0 ? 1.0 : border > 0.0 ? 1.0 - away / border : 0.0);
    }
    return 1.0 - pow(1.0 - min(colour.a, 1.0 - 1.0 / 4096.0), shareOfFine ? ofFine : 1.0 - ofFine);
}

void main()
{
    float opacity = opacityHere();
    if (isCutOff(placeInMesh) || opacity <= 0.0)
        discard;
    ivec2 place = ivec2(gl_FragCoord.xy);
    uvec2 key = uvec2(floatBitsToUint(gl_FragCoord.z), firstTriangle + uint(gl_PrimitiveID) + 1u);
    uvec2 previous = texelFetch(previousLayer, place, 0).xy;
    bool peeled = key.x < previous.x || (key.x == previous.x && key.y <= previous.y);
    bool hidden = gl_FragCoord.z >= texelFetch(opaqueDepth, place, 0).x;
    if (peeled || hidden || texelFetch(accumulated, place, 0).w > saturated)
        discard;
    layerColour = vec4(lit(surfaceColour, surfaceNormal, towardsEye) * opacity, opacity);
    layerKey = key;
}
