#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a ray that lies in a cell, behind one layer of surfaces and before the next. With q = 1 / w in perspective,
// else -w, the planes of faces and cuts bound q by functions that are affine in the picture (CellSetup).
uniform bool perspective;
uniform vec2 pictureSize;
uniform vec2 pictureCentre;
uniform vec2 sampleShift;
uniform vec2 samplesPerSlope;
uniform float nearestBound;      // q of the near plane
uniform int cutCount;
uniform vec4 cuts[16];           // inside is a x + b y + c + d q >= 0, x and y from the centre
uniform vec2 boundOfDepth;       // q is x + y * (1 - depth)
uniform sampler2D opaqueDepth;
uniform usampler2D layerBefore;  // depth as bits and a triangle's number plus one
uniform usampler2D layerBehind;
uniform bool layered;
uniform bool wholeCells;         // each cell goes behind all layers that it meets
uniform int focusPart;           // focus.frag; 0 without a focus
uniform bool shaded;
uniform float perFullGradient;   // 0: the optical depth does not depend on the gradient

flat in vec4 faceBounds[4];
flat in vec4 slope;
flat in vec3 valueRange;
flat in ivec2 segmentRange;
flat in vec2 reference;
flat in vec4 gradientAlong[3];

layout(location = 0) out vec4 result;

const uint noLayer = 0xffffffffu;
const float farBound = 1e30;

vec2 lightOn(vec3 normal, float cosine);
vec4 lightOfSlabs(ivec2 range, bool fromOrigin, float valueIn, float valueOut, float way, vec4 lightAlong, vec2 partAlong);
vec2 rangeOfPart(vec2 fromCentre, vec2 shown);
float weightAt(vec2 fromCentre, float w);

// The range of q, back to front, that lies in the cell; empty if y <= x.
vec2 rangeInCell(vec2 place)
{
    vec2 range = vec2(-farBound, farBound);
    for (int face = 0; face < 4; ++face) {
        float bound = dot(faceBounds[face].xy, place) + faceBounds[face].z;
        if (faceBounds[face].w > 0.0)
            range.y = min(range.y, bound);
        else
            range.x = max(range.x, bound);
    }
    return range;
}

void cutRange(vec2 fromCentre, inout vec2 range)
{
    for (int i = 0; i < cutCount; ++i) {
        float atZero = dot(cuts[i].xy, fromCentre) + cuts[i].z;
        if (cuts[i].w > 0.0)
            range.x = max(range.x, -atZero / cuts[i].w);
        else if (cuts[i].w < 0.0)
            range.y = min(range.y, -atZero / cuts[i].w);
        else if (atZero < 0.0)
            range.y = -farBound;
    }
}

// What lies in the part of the ray that is drawn now, of what the near plane and the cuts leave.
vec2 rangeShown(vec2 fromCentre)
{
    vec2 range = vec2(-farBound, perspective ? nearestBound : farBound);
    cutRange(fromCentre, range);
    if (focusPart == 0 || !(range.y > range.x) || (perspective && !(range.y > 0.0)))
        return range;
    vec2 part;
    if (perspective) {
        part = rangeOfPart(fromCentre, vec2(1.0 / range.y, range.x > 0.0 ? 1.0 / range.x : farBound));
        return part.y > part.x ? vec2(part.y < farBound ? 1.0 / part.y : range.x, 1.0 / part.x) : vec2(0.0);
    }
    part = rangeOfPart(fromCentre, -range.yx);
    return part.y > part.x ? -part.yx : vec2(0.0);
}

float boundAtDepth(float depth)
{
    return boundOfDepth.x + boundOfDepth.y * (1.0 - depth);
}

// What lies between the surfaces around the piece of the ray that is drawn now: as range, back to front.
vec2 rangeOfLayers()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec2 range = vec2(-farBound, farBound);
    float depth = texelFetch(opaqueDepth, place, 0).x;
    if (depth < 1.0)
        range.x = boundAtDepth(depth);
    if (!layered)
        return range;
    uvec2 before = texelFetch(layerBefore, place, 0).xy;
    uvec2 behind = texelFetch(layerBehind, place, 0).xy;
    if (before.x == noLayer)
        range.y = -farBound; // all was drawn
    else if (before.y != 0u)
        range.y = boundAtDepth(uintBitsToFloat(before.x));
    if (behind.x != noLayer)
        range.x = max(range.x, boundAtDepth(uintBitsToFloat(behind.x)));
    return range;
}

// The factor of a colour and the highlight added to it at a place w of the ray, as of a surface across the gradient
// (core/render/shading.h); what no gradient tells is left as it is. Third, the part of the optical depth. `ray`: where it
// goes for one unit of w.
vec3 lightAt(vec2 place, vec3 ray, float w)
{
    const float leastSquare = 1e-12;
    vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        float slope = dot(gradientAlong[axis].xy, place) + gradientAlong[axis].z;
        gradient[axis] = perspective ? slope * w + gradientAlong[axis].w : slope - gradientAlong[axis].w * w;
    }
    float square = dot(gradient, gradient);
    float part = perFullGradient > 0.0 ? min(1.0, sqrt(square) * perFullGradient) : 1.0;
    if (!(square > leastSquare))
        return vec3(1.0, 0.0, part);
    float along = dot(gradient, ray);
    float scale = inversesqrt(square);
    vec3 normal = gradient * (along > 0.0 ? -scale : scale);
    return vec3(lightOn(normal * vec3(1.0, -1.0, -1.0), min(1.0, abs(along) * scale * inversesqrt(dot(ray, ray)))), part);
}

void main()
{
    vec2 place = vec2(gl_FragCoord.x - reference.x, reference.y - gl_FragCoord.y);
    vec2 fromCentre = vec2(gl_FragCoord.x - pictureCentre.x, pictureSize.y - pictureCentre.y - gl_FragCoord.y) + sampleShift;
    vec2 range = rangeInCell(place);
    vec2 shown = rangeShown(fromCentre);
    range = vec2(max(range.x, shown.x), min(range.y, shown.y));
    vec2 layers = rangeOfLayers();
    if (!wholeCells)
        range = vec2(max(range.x, layers.x), min(range.y, layers.y));
    else if (!(range.x >= layers.x && range.x < layers.y))
        discard;
    if (!(range.y > range.x) || (perspective && !(range.x > 0.0)))
        discard;

    float enter = perspective ? 1.0 / range.y : -range.y;
    float leave = perspective ? 1.0 / range.x : -range.x;
    vec2 slopes = perspective ? fromCentre / samplesPerSlope : vec2(0.0);
    float ray = sqrt(1.0 + dot(slopes, slopes)); // its length for one unit of w
    float perPlace = dot(slope.xy, place) + slope.z;
    float valueIn = perspective ? perPlace * enter + slope.w : perPlace + slope.w * range.y;
    float valueOut = perspective ? perPlace * leave + slope.w : perPlace + slope.w * range.x;
    // A part of the optical depth is that of a part of the way.
    float way = (leave - enter) * ray * weightAt(fromCentre, 0.5 * (enter + leave));
    // At the ends of the ray's way, affine between them.
    vec3 first = vec3(1.0, 0.0, 1.0), last = first;
    if (shaded) {
        first = lightAt(place, vec3(slopes, 1.0), enter);
        last = lightAt(place, vec3(slopes, 1.0), leave);
    }
    vec3 rise = last - first;
    result = lightOfSlabs(segmentRange, valueRange.z == 0.0, clamp(valueIn, valueRange.x, valueRange.y),
                          clamp(valueOut, valueRange.x, valueRange.y), way, vec4(first.x, rise.x, first.y, rise.y),
                          vec2(first.z, rise.z));
}
