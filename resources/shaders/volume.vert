#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The four faces of each cell, to be drawn where they look away from the eye: there every ray through the cell leaves it,
// also if the eye or the near plane is inside. The rest is what core/graphics/volume/cell_setup.cpp does.
uniform samplerBuffer vertices;  // place and value
uniform usamplerBuffer corners;  // of the cells, front to back
uniform usamplerBuffer segmentsOfCell; // first and last
uniform samplerBuffer segments;
uniform bool perspective;
uniform vec3 originHigh;      // the eye, or what an orthographic camera looks at, in two floats a coordinate
uniform vec3 originLow;
uniform mat3 imageFromWorld;  // VolumeView, without the shift
uniform vec3 imageOfOrigin;
uniform vec2 smallestValue;   // high and low part
uniform float perValue;
uniform vec2 pictureSize;     // in samples
uniform vec2 sampleShift;     // of samples from the middle, right and down
uniform float nearest;
uniform int focusPart;        // these as in focus.frag
uniform vec3 regionSize;
uniform bool ball;
uniform float border;
uniform vec3 regionFromImage;
uniform mat3 worldFromImage;
uniform vec2 lengths;         // of u and v for one unit of length across the view, in units of w for one along it

// Of the plane of each face: a, b, c, and positive if the face is seen from outside (CellSetup).
flat out vec4 faceBounds[4];
flat out vec4 slope; // a, b, c, constant
flat out vec3 valueRange; // smallest, largest, and 1 if values count from 0, else from the segment's origin
flat out ivec2 segmentRange;
flat out vec2 reference; // the sample that a, b, c count from, as in gl_FragCoord
flat out float perGradient; // 1 / length of the gradient, in values for one unit of w; 0 without one

const int faceCorners[12] = int[](0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
const vec4 nowhere = vec4(0.0, 0.0, 2.0, 1.0);
const int whole = 0, before = 1, within = 3, behind = 5; // of focusPart
const float thinnestCell = 1e-5;
const float roundingShare = 2.5e-7;
const float steepestBound = 1e7;

vec4 imageOf(uint vertex)
{
    vec4 place = texelFetch(vertices, int(vertex));
    vec3 image = imageFromWorld * ((place.xyz - originHigh) - originLow) + imageOfOrigin;
    return vec4(image, clamp(((place.w - smallestValue.x) - smallestValue.y) * perValue, -1e25, 1e25));
}

vec4 clipPositionOf(vec3 image)
{
    float along = perspective ? image.z : 1.0;
    vec2 place = (image.xy - sampleShift * along) * 2.0 / pictureSize;
    return vec4(place.x, -place.y, perspective ? image.z - 2.0 * nearest : 0.0, along);
}

float extent(vec4 of)
{
    return max(max(of.x, of.y), max(of.z, of.w)) - min(min(of.x, of.y), min(of.z, of.w));
}

vec2 sampleNear(vec3 image)
{
    vec2 place = perspective ? (image.z > nearest ? image.xy / image.z : vec2(0.0)) : image.xy;
    vec2 fromCorner = clamp(floor(place + pictureSize * 0.5), vec2(0.0), pictureSize) + 0.5;
    return vec2(fromCorner.x, pictureSize.y - fromCorner.y);
}

vec4 boundOf(vec3 normal, float offset)
{
    // Inside is a x + b y + c >= outside * q.
    float outside = perspective ? offset : normal.z;
    float least = (abs(normal.x) + abs(normal.y)) / steepestBound;
    float steep = outside < 0.0 ? min(outside, -least) : max(outside, least);
    float safe = abs(steep) > 1e-36 ? steep : 1e-36;
    return vec4(vec3(normal.xy, perspective ? normal.z : -offset) / safe, safe);
}

// Nothing of the cell is in the part of rays that is drawn now.
bool isElsewhere(vec4 images[4])
{
    if (focusPart == whole)
        return false;
    bool outside = focusPart == before || focusPart == behind;
    float margin = focusPart == within ? 0.0 : border;
    bool inRegion = true, inBorder = true;
    vec3 least = vec3(1e30), largest = vec3(-1e30);
    for (int i = 0; i < 4; ++i) {
        vec3 place = regionFromImage + worldFromImage * images[i].xyz;
        float away = ball ? length(place) - regionSize.x : length(max(abs(place) - regionSize, 0.0));
        inRegion = inRegion && away <= 0.0;
        inBorder = inBorder && away <= border;
        least = min(least, place);
        largest = max(largest, place);
    }
    if (outside)
        return inBorder;
    return any(greaterThan(least, regionSize + margin)) || any(lessThan(largest, -regionSize - margin)) ||
           (focusPart != within && inRegion);
}

void main()
{
    int cell = gl_VertexID / 12;
    int place = gl_VertexID % 12;
    uvec4 cornersOfCell = texelFetch(corners, cell);
    vec4 images[4];
    for (int i = 0; i < 4; ++i)
        images[i] = imageOf(cornersOfCell[i]);
    if (isElsewhere(images)) {
        gl_Position = nowhere;
        return;
    }
    vec4 u = vec4(images[0].x, images[1].x, images[2].x, images[3].x);
    vec4 v = vec4(images[0].y, images[1].y, images[2].y, images[3].y);
    vec4 w = vec4(images[0].z, images[1].z, images[2].z, images[3].z);
    vec3 far = abs(images[0].xyz) + vec3(extent(u), extent(v), extent(w));

    reference = sampleNear(images[0].xyz);
    vec2 shift = vec2(reference.x - pictureSize.x * 0.5, pictureSize.y * 0.5 - reference.y) + sampleShift;
    vec3 c[4];
    for (int i = 0; i < 4; ++i)
        c[i] = vec3(images[i].xy - shift * (perspective ? images[i].z : 1.0), images[i].z);
    vec3 normals[4];
    normals[1] = cross(c[2] - c[0], c[3] - c[0]);
    normals[2] = cross(c[3] - c[0], c[1] - c[0]);
    normals[3] = cross(c[1] - c[0], c[2] - c[0]);
    normals[0] = -(normals[1] + normals[2] + normals[3]);
    float volume = dot(normals[1], c[1] - c[0]);

    vec3 width = vec3(extent(vec4(c[0].x, c[1].x, c[2].x, c[3].x)), extent(vec4(c[0].y, c[1].y, c[2].y, c[3].y)), extent(w));
    float rounding = roundingShare * dot(far, width.yxx * width.zzy);
    if (!(abs(volume) > max(rounding, 1e-35))) {
        gl_Position = nowhere; // a flat cell
        return;
    }
    int corner = volume < 0.0 ? place - place % 3 + (3 - place % 3) % 3 : place;
    gl_Position = clipPositionOf(images[faceCorners[corner]].xyz);

    float side = volume < 0.0 ? -1.0 : 1.0;
    for (int face = 0; face < 4; ++face)
        faceBounds[face] = boundOf(normals[face] * side, dot(normals[face], c[face == 0 ? 1 : 0]) * side);

    vec4 values = vec4(images[0].w, images[1].w, images[2].w, images[3].w);
    vec3 rises = (values.yzw - values.x) / volume;
    vec3 gradient = rises.x * normals[1] + rises.y * normals[2] + rises.z * normals[3];
    float atOrigin = values.x - dot(gradient, c[0]);
    slope = vec4(gradient.xy, perspective ? gradient.z : atOrigin, perspective ? atOrigin : -gradient.z);
    vec3 across = vec3(gradient.xy * lengths, perspective ? gradient.z - dot(gradient.xy, shift) : gradient.z);
    float squared = dot(across, across);
    perGradient = squared > 1e-30 ? inversesqrt(squared) : 0.0;
    valueRange = vec3(min(min(values.x, values.y), min(values.z, values.w)),
                      max(max(values.x, values.y), max(values.z, values.w)), 1.0);
    segmentRange = ivec2(texelFetch(segmentsOfCell, cell).xy);
    bool simple = segmentRange.x == segmentRange.y && abs(volume) > width.x * width.y * width.z * thinnestCell;
    if (simple) {
        float origin = texelFetch(segments, 3 * segmentRange.x).z;
        slope -= perspective ? vec4(0.0, 0.0, 0.0, origin) : vec4(0.0, 0.0, origin, 0.0);
        valueRange = vec3(valueRange.xy - origin, 0.0);
    }
}
