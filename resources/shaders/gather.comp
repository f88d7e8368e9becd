// SPDX-License-Identifier: GPL-3.0-or-later
// The cells that show something with their keys, close together. After compute.glsl.
layout(std430, binding = 0) readonly buffer SegmentsOfCell { uint segmentsOfCell[]; };
layout(std430, binding = 1) readonly buffer ShownBefore { uint shownBefore[]; };
layout(std430, binding = 2) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 3) writeonly buffer Sorted { uvec2 sorted[]; }; // key and cell
uniform uint count;

const uint nothing = 0xffffffffu;

void main()
{
    uint cell = thisItem();
    if (cell < count && segmentsOfCell[cell] != nothing)
        sorted[shownBefore[cell]] = uvec2(keys[cell], cell);
}
