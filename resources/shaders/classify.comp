// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells show something: those with values in a segment that is not transparent, as classifyCells() in
// core/graphics/volume/cell_classes.cpp finds them, unless they are beside the picture or behind the near plane. After
// compute.glsl.
layout(std430, binding = 0) readonly buffer Corners { uvec4 corners[]; };
layout(std430, binding = 1) readonly buffer Projected { vec4 projected[]; };
layout(std430, binding = 2) readonly buffer VertexSegments { uint vertexSegments[]; };
layout(std430, binding = 3) readonly buffer VisibleBefore { uint visibleBefore[]; }; // segments, for each and the end
layout(std430, binding = 4) writeonly buffer SegmentsOfCell { uint segmentsOfCell[]; }; // first, and last << 16
layout(std430, binding = 5) writeonly buffer Shown { uint shown[]; }; // 1 for those; one more, 0, for the sum
uniform uint count;
uniform bool perspective;
uniform vec2 pictureSize;
uniform float nearest;

const uint nothing = 0xffffffffu;
const float samplesAside = 3.0; // what sampleShift and rounding may do
const float roundingShare = 1e-5;

bool allAbove(vec4 places, vec4 limits)
{
    return all(greaterThan(places - abs(places) * roundingShare, limits + abs(limits) * roundingShare));
}

bool isAside(uvec4 cell)
{
    vec4 a = projected[cell.x], b = projected[cell.y], c = projected[cell.z], d = projected[cell.w];
    vec4 u = vec4(a.x, b.x, c.x, d.x);
    vec4 v = vec4(a.y, b.y, c.y, d.y);
    vec4 w = vec4(a.z, b.z, c.z, d.z);
    vec4 along = perspective ? w : vec4(1.0);
    vec2 halfSize = 0.5 * pictureSize + samplesAside;
    return allAbove(u, halfSize.x * along) || allAbove(-u, halfSize.x * along) || allAbove(v, halfSize.y * along) ||
           allAbove(-v, halfSize.y * along) || (perspective && allAbove(vec4(nearest), w));
}

uint segmentsOf(uvec4 cell)
{
    uvec4 both = uvec4(vertexSegments[cell.x], vertexSegments[cell.y], vertexSegments[cell.z], vertexSegments[cell.w]);
    if (any(equal(both, uvec4(nothing))))
        return nothing;
    uvec4 up = both & 0xffffu, down = both >> 16;
    uint first = min(min(up.x, up.y), min(up.z, up.w));
    uint last = max(first, max(max(down.x, down.y), max(down.z, down.w)));
    return visibleBefore[last + 1u] > visibleBefore[first] ? first | last << 16 : nothing;
}

void main()
{
    uint cell = thisItem();
    if (cell == count)
        shown[cell] = 0u;
    if (cell >= count)
        return;
    uint segments = segmentsOf(corners[cell]);
    if (segments != nothing && isAside(corners[cell]))
        segments = nothing;
    segmentsOfCell[cell] = segments;
    shown[cell] = segments != nothing ? 1u : 0u;
}
