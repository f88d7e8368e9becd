#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a ray before a focus, in layers of its border, in it and behind it: core/render/volume/border_fragments.cpp.
// Lengths are in units of w, places count from the middle of the region.
uniform bool perspective;
uniform int focusPart;          // VolumePart in core/render/gl/volume_painter.h
uniform int focusInterval;
uniform bool fine;              // the volume that is drawn now is the one in the focus
uniform vec2 borderShares;      // where a layer of the border begins and ends, of its way on one side
uniform int regionCount;
uniform vec4 regionShapes[16];  // half of a box; of a ball the radius, in each coordinate; 1 if it is a ball
uniform vec4 regionPlaces[16];  // where the image (0, 0, 0) is, and the border
uniform mat3 worldFromImage;

const int whole = 0, before = 1, frontBorder = 2, within = 3, backBorder = 4;
const float endless = 1e30;

struct Ray {
    vec3 start, direction; // of w
};

Ray rayOf(int region, vec2 fromCentre)
{
    vec3 place = regionPlaces[region].xyz;
    if (perspective)
        return Ray(place, worldFromImage * vec3(fromCentre, 1.0));
    return Ray(place + worldFromImage * vec3(fromCentre, 0.0), worldFromImage[2]);
}

// Where the ray is in the region grown by `margin`, or in something somewhat larger; empty if y <= x.
vec2 rangeWithin(vec4 shape, Ray ray, float margin)
{
    if (shape.w > 0.0) {
        float squared = dot(ray.direction, ray.direction);
        float nearest = -dot(ray.start, ray.direction) / squared;
        vec3 offset = ray.start + nearest * ray.direction;
        float radius = shape.x + margin;
        float rest = radius * radius - dot(offset, offset);
        float halfWay = rest > 0.0 ? sqrt(rest / squared) : 0.0;
        return nearest + vec2(-halfWay, halfWay);
    }
    vec2 range = vec2(-endless, endless);
    for (int axis = 0; axis < 3; ++axis) {
        float size = shape[axis] + margin;
        if (ray.direction[axis] == 0.0) {
            if (abs(ray.start[axis]) > size)
                return vec2(0.0);
            continue;
        }
        float one = (-size - ray.start[axis]) / ray.direction[axis];
        float other = (size - ray.start[axis]) / ray.direction[axis];
        range = vec2(max(range.x, min(one, other)), min(range.y, max(one, other)));
    }
    return range;
}

// Where the ray enters a region's border and the region, and leaves them; all 0 if it stays out of both.
vec4 passageOf(int region, vec2 fromCentre)
{
    Ray ray = rayOf(region, fromCentre);
    vec4 shape = regionShapes[region];
    float border = regionPlaces[region].w;
    vec2 outer = rangeWithin(shape, ray, border);
    if (!(outer.y > outer.x) || (perspective && !(outer.y > 0.0)))
        return vec4(0.0);
    vec2 inner = border > 0.0 ? rangeWithin(shape, ray, 0.0) : outer;
    if (!(inner.y > inner.x))
        inner = vec2(0.5 * (outer.x + outer.y));
    return vec4(outer.x, inner.x, inner.y, outer.y);
}

// Of the ray's passages through all regions together (FocusRays::intervalsAt()) that of this number, and where the one
// before ends. Returns how many there are, counted no farther than this one.
int intervalOf(vec2 fromCentre, int number, out vec4 interval, out float endBefore)
{
    vec4 passages[16];
    int count = 0;
    for (int region = 0; region < regionCount; ++region) {
        vec4 passage = passageOf(region, fromCentre);
        if (passage.w > passage.x)
            passages[count++] = passage;
    }
    interval = vec4(0.0);
    endBefore = -endless;
    float done = -endless;
    for (int found = 0; found <= number; ++found) {
        float enters = endless;
        for (int i = 0; i < count; ++i)
            if (passages[i].y > done)
                enters = min(enters, passages[i].y);
        if (enters >= endless)
            return found;
        float leaves = enters;
        for (int pass = 0; pass < count; ++pass)
            for (int i = 0; i < count; ++i)
                if (passages[i].y <= leaves)
                    leaves = max(leaves, passages[i].z);
        vec2 outer = vec2(enters, leaves);
        float next = endless;
        for (int pass = 0; pass < count; ++pass)
            for (int i = 0; i < count; ++i) {
                if (passages[i].x < outer.x && passages[i].w >= outer.x)
                    outer.x = passages[i].x;
                if (passages[i].x <= outer.y && passages[i].w > outer.y)
                    outer.y = passages[i].w;
                if (passages[i].y > leaves)
                    next = min(next, passages[i].y);
            }
        if (outer.x <= done)
            outer.x = 0.5 * (done + enters);
        if (next <= outer.y)
            outer.y = 0.5 * (leaves + next);
        if (found < number)
            endBefore = outer.y;
        interval = vec4(outer.x, enters, leaves, outer.y);
        done = leaves;
    }
    return number + 1;
}

// The part that is drawn now of what is shown of the ray, as w; nothing if y <= x.
vec2 rangeOfPart(vec2 fromCentre, vec2 shown)
{
    if (focusPart == whole)
        return shown;
    vec4 interval;
    float endBefore;
    int count = intervalOf(fromCentre, focusInterval, interval, endBefore);
    bool meets = count > focusInterval;
    float end = max(shown.x, shown.y);
    interval = clamp(interval, shown.x, end);
    if (focusPart == before) {
        if (count < focusInterval)
            return vec2(0.0);
        return vec2(focusInterval > 0 ? clamp(endBefore, shown.x, end) : shown.x, meets ? interval.x : shown.y);
    }
    if (!meets)
        return vec2(0.0);
    if (focusPart == within)
        return interval.yz;
    vec2 side = focusPart == frontBorder ? interval.xy : interval.zw;
    return side.x + (side.y - side.x) * borderShares;
}

// How much of the optical depth at w counts.
float weightAt(vec2 fromCentre, float w)
{
    if (focusPart != frontBorder && focusPart != backBorder)
        return 1.0;
    float ofFine = 0.0;
    for (int region = 0; region < regionCount; ++region) {
        Ray ray = rayOf(region, fromCentre);
        vec3 place = ray.start + w * ray.direction;
        vec4 shape = regionShapes[region];
        float away = shape.w > 0.0 ? max(0.0, length(place) - shape.x) : length(max(abs(place) - shape.xyz, 0.0));
        float border = regionPlaces[region].w;
        ofFine = max(ofFine, away <= 0.0 ? 1.0 : border > 0.0 ? 1.0 - away / border : 0.0);
    }
    return fine ? ofFine : 1.0 - ofFine;
}
