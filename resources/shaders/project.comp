// SPDX-License-Identifier: GPL-3.0-or-later
// Each vertex in the picture, and the segments of the transfer function that its value lies in, as classifyVertices() in
// core/graphics/volume/cell_classes.cpp finds them. After compute.glsl and image.glsl.
layout(std430, binding = 0) readonly buffer Vertices { vec4 vertices[]; };
layout(std430, binding = 1) writeonly buffer Projected { vec4 projected[]; };
layout(std430, binding = 2) writeonly buffer VertexSegments { uint vertexSegments[]; }; // upwards, and downwards << 16
layout(std430, binding = 3) readonly buffer Knots { vec2 knots[]; }; // the least float from it on, the largest up to it
uniform uint count;
uniform uint knotCount;

const uint nothing = 0xffffffffu;

bool isFinite(float number)
{
    return (floatBitsToUint(number) & 0x7f800000u) != 0x7f800000u;
}

// How many knots a value has reached, or with `passed` left behind.
uint knotsBelow(float value, bool passed)
{
    uint first = 0u, last = knotCount;
    while (first < last) {
        uint middle = (first + last) / 2u;
        if (passed ? value > knots[middle].y : value >= knots[middle].x)
            first = middle + 1u;
        else
            last = middle;
    }
    return first;
}

void main()
{
    uint item = thisItem();
    if (item >= count)
        return;
    vec4 vertex = vertices[item];
    projected[item] = imageOf(vertex);
    bool finite = isFinite(vertex.x) && isFinite(vertex.y) && isFinite(vertex.z) && isFinite(vertex.w);
    vertexSegments[item] = finite ? knotsBelow(vertex.w, false) | knotsBelow(vertex.w, true) << 16 : nothing;
}
