// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of some of the sorted cells, as setup.vert reads it: eight words of four for each. After compute.glsl,
// image.glsl and cell.glsl.
layout(std430, binding = 0) readonly buffer Sorted { uvec2 sorted[]; };
layout(std430, binding = 1) readonly buffer Corners { uvec4 corners[]; };
layout(std430, binding = 2) readonly buffer Projected { vec4 projected[]; };
layout(std430, binding = 3) readonly buffer SegmentsOfCell { uint segmentsOfCell[]; };
layout(std430, binding = 4) writeonly buffer Cells { uvec4 cells[]; };
uniform samplerBuffer segments;
uniform uint first;
uniform uint count;

const uint words = 8u;
const uint isShown = 1u, isInverted = 2u;

void main()
{
    uint item = thisItem();
    if (item >= count)
        return;
    uint cell = sorted[first + item].y;
    uvec4 ofCell = corners[cell];
    uint range = segmentsOfCell[cell];
    vec4 images[4];
    for (int i = 0; i < 4; ++i)
        images[i] = projected[ofCell[i]];
    bool oneSegment = (range & 0xffffu) == range >> 16;
    CellInView inView;
    uint at = item * words;
    if (!setUpCell(images, oneSegment, texelFetch(segments, 3 * int(range & 0xffffu)).z, inView)) {
        cells[at + 1u] = uvec4(0u);
        return;
    }
    cells[at] = ofCell;
    cells[at + 1u] = uvec4(isShown | (inView.inverted ? isInverted : 0u), range, floatBitsToUint(inView.reference));
    cells[at + 2u] = floatBitsToUint(inView.slope);
    cells[at + 3u] = floatBitsToUint(vec4(inView.valueRange, inView.perGradient));
    for (uint face = 0u; face < 4u; ++face)
        cells[at + 4u + face] = floatBitsToUint(inView.faceBounds[face]);
}
