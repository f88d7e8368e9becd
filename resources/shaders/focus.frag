#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a ray before a focus, in layers of its border, in it and behind it: core/render/volume/border_fragments.cpp.
// Lengths are in units of w, places count from the middle of the region.
uniform bool perspective;
uniform int focusPart;          // VolumePart in core/render/gl/volume_painter.h
uniform bool fine;              // the volume that is drawn now is the one in the focus
uniform vec2 borderShares;      // where a layer of the border begins and ends, of its way on one side
uniform bool ball;
uniform vec3 regionSize;        // half of a box; of a ball the radius, in each coordinate
uniform float border;
uniform vec3 regionFromImage;   // where the image (0, 0, 0) is
uniform mat3 worldFromImage;

const int whole = 0, before = 1, frontBorder = 2, within = 3, backBorder = 4, behind = 5;
const float endless = 1e30;

struct Ray {
    vec3 start, direction; // of w
};

Ray rayOf(vec2 fromCentre)
{
    if (perspective)
        return Ray(regionFromImage, worldFromImage * vec3(fromCentre, 1.0));
    return Ray(regionFromImage + worldFromImage * vec3(fromCentre, 0.0), worldFromImage[2]);
}

// Where the ray is in the region grown by `margin`, or in something somewhat larger; empty if y <= x.
vec2 rangeWithin(Ray ray, float margin)
{
    if (ball) {
        float squared = dot(ray.direction, ray.direction);
        float nearest = -dot(ray.start, ray.direction) / squared;
        vec3 offset = ray.start + nearest * ray.direction;
        float radius = regionSize.x + margin;
        float rest = radius * radius - dot(offset, offset);
        float halfWay = rest > 0.0 ? sqrt(rest / squared) : 0.0;
        return nearest + vec2(-halfWay, halfWay);
    }
    vec2 range = vec2(-endless, endless);
    for (int axis = 0; axis < 3; ++axis) {
        float size = regionSize[axis] + margin;
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

// Where the ray enters the border and the region, and leaves them; all 0 if it stays out of both.
vec4 passageOf(Ray ray)
{
    vec2 outer = rangeWithin(ray, border);
    if (!(outer.y > outer.x))
        return vec4(0.0);
    vec2 inner = border > 0.0 ? rangeWithin(ray, 0.0) : outer;
    if (!(inner.y > inner.x))
        inner = vec2(0.5 * (outer.x + outer.y));
    return vec4(outer.x, inner.x, inner.y, outer.y);
}

// The part that is drawn now of what is shown of the ray, as w; nothing if y <= x.
vec2 rangeOfPart(vec2 fromCentre, vec2 shown)
{
    if (focusPart == whole)
        return shown;
    vec4 passage = clamp(passageOf(rayOf(fromCentre)), shown.x, max(shown.x, shown.y));
    bool meets = passage.w > passage.x;
    if (focusPart == before)
        return meets ? vec2(shown.x, passage.x) : shown;
    if (!meets)
        return vec2(0.0);
    if (focusPart == within)
        return passage.yz;
    if (focusPart == behind)
        return vec2(passage.w, shown.y);
    vec2 side = focusPart == frontBorder ? passage.xy : passage.zw;
    return side.x + (side.y - side.x) * borderShares;
}

// How much of the optical depth at w counts.
float weightAt(vec2 fromCentre, float w)
{
    if (focusPart != frontBorder && focusPart != backBorder)
        return 1.0;
    Ray ray = rayOf(fromCentre);
    vec3 place = ray.start + w * ray.direction;
    float away = ball ? max(0.0, length(place) - regionSize.x) : length(max(abs(place) - regionSize, 0.0));
    float ofFine = clamp(1.0 - away / border, 0.0, 1.0);
    return fine ? ofFine : 1.0 - ofFine;
}
