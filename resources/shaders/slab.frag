#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The light of the slabs that a cell has between the knots of the transfer function: the formulas of
// core/render/volume/slab_integral.h and slab_shading.h.
uniform samplerBuffer segments; // begin, end, origin, 1 if transparent; half extinction and its rise, ...

struct Segment {
    float begin, end, origin;
    bool transparent;
    float halfExtinction, halfExtinctionPerValue;
    vec3 colour, colourPerValue;
};

const float deepestSlab = 24.0; // optical depth beyond which nothing is seen
const float levelRise = 1e-8;

Segment segmentAt(int index)
{
    vec4 a = texelFetch(segments, 3 * index);
    vec4 b = texelFetch(segments, 3 * index + 1);
    vec4 c = texelFetch(segments, 3 * index + 2);
    return Segment(a.x, a.y, a.z, a.w > 0.5, b.x, b.y, vec3(b.zw, c.x), c.yzw);
}

// Of optical depth up to 1. `seen` is light and opacity so far; `colourIn` and `colourRise` the colours along it.
void addThinSlab(inout vec4 seen, Segment segment, float valueIn, float valueOut, float way, vec3 colourIn, vec3 colourRise)
{
    float extinctionIn = segment.halfExtinction + segment.halfExtinctionPerValue * valueIn;
    float extinctionOut = segment.halfExtinction + segment.halfExtinctionPerValue * valueOut;
    float depth = max(way * (extinctionIn + extinctionOut), 0.0);
    float rise = way * (extinctionOut - extinctionIn);
    float p = 1.0 + depth * (-0.4999960023 + depth * (0.1666125576 + depth * (-0.0414223966 +
              depth * (0.0078387837 + depth * -0.00091243686))));
    float squared = depth * depth;
    float riseSquared = rise * rise;
    float ofDepth = squared * (-0.0833209005 + 0.00133735480 * squared);
    float ofRise = riseSquared * (0.0166636361 - 0.00031941871 * squared);
    float odd = 0.1666666667 - 0.00272286018 * squared + 0.00116581360 * riseSquared;
    float light = 1.0 - seen.a;
    float opacity = depth * p * light;
    float weight = p * (0.5 * depth + rise * odd + ofDepth + ofRise) * light;
    seen += vec4(colourIn * opacity + colourRise * weight, opacity);
}

// A colour under light at a share of the way (lightAlong of volume.frag).
vec3 lit(vec3 colour, vec4 lightAlong, float share)
{
    return min(vec3(1.0), colour * (lightAlong.x + lightAlong.y * share) + lightAlong.z + lightAlong.w * share);
}

// Of any optical depth; values count from the segment's origin. `shares`: of the ray's way through the cell, between
// which the slab lies. Its colours are lit at its ends; of its optical depth there is the part in its middle.
void addSlab(inout vec4 seen, Segment segment, float valueIn, float valueOut, float way, vec4 lightAlong, vec2 partAlong,
             vec2 shares)
{
    way *= partAlong.x + partAlong.y * 0.5 * (shares.x + shares.y);
    vec3 colourIn = lit(segment.colour + segment.colourPerValue * valueIn, lightAlong, shares.x);
    vec3 colourOut = lit(segment.colour + segment.colourPerValue * valueOut, lightAlong, shares.y);
    // With s from 0 to 1 along the slab the optical depth before s is s (atStart + s rise).
    float atStart = max(2.0 * way * (segment.halfExtinction + segment.halfExtinctionPerValue * valueIn), 0.0);
    float rise = way * segment.halfExtinctionPerValue * (valueOut - valueIn);
    float share = 1.0;
    if (atStart + rise > deepestSlab)
        share = min(1.0, 2.0 * deepestSlab / (atStart + sqrt(max(atStart * atStart + 4.0 * rise * deepestSlab, 0.0))));
    float count = ceil(max(1.0, max(share * atStart, share * (atStart + 2.0 * share * rise))));
    float perPart = share * (valueOut - valueIn) / count;
    float part = share * way / count;
    vec3 colourPerPart = share * (colourOut - colourIn) / count;
    for (float i = 0.0; i < count; i += 1.0)
        addThinSlab(seen, segment, valueIn + i * perPart, valueIn + (i + 1.0) * perPart, part,
                    colourIn + i * colourPerPart, colourPerPart);
}

// A ray through the segments `first` to `last`, a slab for each in the order in which the ray meets them. Values count
// from 0, or from the one segment's origin. `partAlong`: of the optical depth, where the ray comes in, and its rise.
vec4 lightOfSlabs(ivec2 range, bool fromOrigin, float valueIn, float valueOut, float way, vec4 lightAlong, vec2 partAlong)
{
    vec4 seen = vec4(0.0);
    if (range.x == range.y) {
        Segment segment = segmentAt(range.x);
        float origin = fromOrigin ? 0.0 : segment.origin;
        addSlab(seen, segment, valueIn - origin, valueOut - origin, way, lightAlong, partAlong, vec2(0.0, 1.0));
        return seen;
    }
    float rise = valueOut - valueIn;
    float perRise = 1.0 / (abs(rise) < levelRise ? levelRise : rise); // without a rise, all to where it starts
    bool upwards = perRise > 0.0;
    float shareBefore = 0.0;
    float from = valueIn;
    for (int i = 0; i <= range.y - range.x; ++i) {
        Segment segment = segmentAt(upwards ? range.x + i : range.y - i);
        float knot = upwards ? segment.end : segment.begin;
        float share = clamp((knot - valueIn) * perRise, 0.0, 1.0);
        float to = valueIn + share * rise;
        if (!segment.transparent && share > shareBefore)
            addSlab(seen, segment, from - segment.origin, to - segment.origin, way * (share - shareBefore), lightAlong,
                    partAlong, vec2(shareBefore, share));
        shareBefore = share;
        from = to;
    }
    return seen;
}
