// SPDX-License-Identifier: GPL-3.0-or-later
// One round of making keys exact: each cell's becomes greater than those of the neighbours across the faces that the eye
// sees from outside. When a round changes nothing, the keys order every two cells with a face between them rightly,
// whatever they began with; equal keys are left to cells that no face orders. Then they are the least such keys, so that
// it does not matter in which order they rose. After compute.glsl.
layout(std430, binding = 0) readonly buffer Neighbours { uvec4 neighbours[]; }; // cell * 4 + face, or none
layout(std430, binding = 1) readonly buffer Facing { uint facing[]; };
layout(std430, binding = 2) buffer Keys { uint keys[]; };
layout(std430, binding = 3) buffer Changes { uint changes[]; }; // for each round, whether there was one
uniform uint count;
uniform uint thisRound;

const uint none = 0xffffffffu;
const uint largestKey = 0xfffffff0u; // only cells in a circle come up to it: it never ends

void main()
{
    uint cell = thisItem();
    if (cell >= count)
        return;
    uint own = facing[cell];
    uvec4 across = neighbours[cell];
    uint key = keys[cell];
    uint least = 0u;
    for (int face = 0; face < 4; ++face) {
        uint neighbour = across[face];
        if (neighbour == none)
            continue;
        // Where the eye lies in the plane of a face, but for rounding, its other cell may know more.
        bool known = (own >> face & 0x11u) != 0u;
        bool isBehind = known ? (own >> face & 1u) != 0u : (facing[neighbour >> 2] >> (neighbour & 3u) & 16u) != 0u;
        if (isBehind)
            least = max(least, keys[neighbour >> 2] + 1u);
    }
    if (least > key) {
        keys[cell] = min(least, largestKey);
        changes[thisRound] = 1u;
    }
}
