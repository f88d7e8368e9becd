// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces of each cell the eye sees, as core/graphics/volume/facing.cpp finds it, but not where double precision
// cannot tell: the eye then lies within some 1e-12 of a face's plane, and the face orders nothing. And the key
// that sorting begins with, the power of the eye with respect to the cell's circumsphere (S14), rounded to what 32 bits
// hold. It need not be exact: relax.comp makes it so. After compute.glsl.
layout(std430, binding = 0) readonly buffer Vertices { vec4 vertices[]; };
layout(std430, binding = 1) readonly buffer Corners { uvec4 corners[]; };
layout(std430, binding = 2) writeonly buffer Facing { uint facing[]; }; // bit f: face f from outside; 4 + f: from inside
layout(std430, binding = 3) writeonly buffer Keys { uint keys[]; };
uniform uint count;
uniform bool perspective;
uniform vec3 eyeHigh; // these three together in double precision; in orthographic views the direction towards the eye
uniform vec3 eyeMiddle;
uniform vec3 eyeLow;
uniform vec3 middle;    // of the mesh
uniform float keyScale; // the keys of most cells lie in [-1, 1] with it

// In single precision, then in double: `rounding` is many times what one operation errs.
#define FACING(name, real, real3)                                                                                      \
    uint name(real3 places[4], real3 eye, real scale, real rounding)                                                   \
    {                                                                                                                  \
        real3 edges[3], normals[3];                                                                                    \
        real lengths = real(0);                                                                                        \
        for (int i = 0; i < 3; ++i) {                                                                                  \
            edges[i] = places[i + 1] - places[0];                                                                      \
            lengths += abs(edges[i].x) + abs(edges[i].y) + abs(edges[i].z);                                            \
        }                                                                                                              \
        real3 toEye = eye - scale * places[0];                                                                         \
        real distance = abs(toEye.x) + abs(toEye.y) + abs(toEye.z) + abs(eye.x) + abs(eye.y) + abs(eye.z) + lengths;   \
        normals[0] = cross(edges[2], edges[1]);                                                                        \
        normals[1] = cross(edges[0], edges[2]);                                                                        \
        normals[2] = cross(edges[1], edges[0]);                                                                        \
        real heights[4];                                                                                               \
        for (int i = 0; i < 3; ++i)                                                                                    \
            heights[i + 1] = dot(normals[i], toEye);                                                                   \
        heights[0] = scale * dot(normals[0], edges[0]) - (heights[1] + heights[2] + heights[3]);                       \
        real tolerance = lengths * lengths * distance * rounding;                                                      \
        uint bits = 0u;                                                                                                \
        for (int face = 0; face < 4; ++face) {                                                                         \
            if (heights[face] > tolerance)                                                                             \
                bits |= 1u << face;                                                                                    \
            if (heights[face] < -tolerance)                                                                            \
                bits |= 16u << face;                                                                                   \
        }                                                                                                              \
        return bits;                                                                                                   \
    }
FACING(quickFacing, float, vec3)
FACING(sureFacing, double, dvec3)

uint facingOf(vec3 places[4])
{
    uint bits = quickFacing(places, eyeHigh, perspective ? 1.0 : 0.0, 1e-6);
    if (((bits | bits >> 4) & 15u) == 15u)
        return bits;
    dvec3 sure[4];
    for (int i = 0; i < 4; ++i)
        sure[i] = dvec3(places[i]);
    dvec3 eye = dvec3(eyeHigh) + dvec3(eyeMiddle) + dvec3(eyeLow);
    return sureFacing(sure, eye, perspective ? 1.0lf : 0.0lf, 1e-14lf);
}

// From the middle, and less what all cells have in common.
float powerOf(vec3 places[4])
{
    vec3 a = places[1] - places[0], b = places[2] - places[0], c = places[3] - places[0];
    vec3 toCentre = (dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a) + dot(c, c) * cross(a, b)) /
                    (2.0 * dot(a, cross(b, c)));
    vec3 toMiddle = middle - places[0];
    if (!perspective)
        return dot(eyeHigh, toMiddle - toCentre);
    vec3 toEye = eyeHigh - places[0];
    return dot(toMiddle, toEye + (eyeHigh - middle)) - 2.0 * dot(toEye, toCentre);
}

void main()
{
    uint cell = thisItem();
    if (cell >= count)
        return;
    uvec4 ofCell = corners[cell];
    vec3 places[4];
    for (int i = 0; i < 4; ++i)
        places[i] = vertices[ofCell[i]].xyz;
    facing[cell] = facingOf(places);
    float key = powerOf(places) * keyScale;
    bool known = key > -1.0 && key < 1.0; // false of no number
    keys[cell] = known ? uint(int(key * 1073741824.0) + 1073741824) : key >= 1.0 ? 2147483648u : 0u;
}
