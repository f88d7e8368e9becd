// SPDX-License-Identifier: GPL-3.0-or-later
// What volume.frag needs of a cell, as core/render/volume/cell_setup.cpp makes it; after image.glsl.
uniform int focusPart;        // these as in focus.frag
uniform int regionCount;
uniform vec4 regionShapes[16];
uniform vec4 regionPlaces[16];
uniform mat3 worldFromImage;
uniform vec2 lengths;         // of u and v for one unit of length across the view, in units of w for one along it

struct CellInView {
    vec4 faceBounds[4];       // of the plane of each face: a, b, c, and positive if the face is seen from outside
    vec4 slope;               // a, b, c, constant
    vec3 valueRange;          // smallest, largest, and 1 if values count from 0, else from the segment's origin
    vec2 reference;           // the sample that a, b, c count from, as in gl_FragCoord
    float perGradient;        // 1 / length of the gradient, in values for one unit of w; 0 without one
    vec4 light[3];            // the gradient for light, right, down and away from the eye, each as the slope
    bool inverted;            // its corners run the other way round
};

const int whole = 0, before = 1, within = 3; // of focusPart
const float thinnestCell = 1e-5;
const float roundingShare = 2.5e-7;
const float steepestBound = 1e7;

float extent(vec4 of)
{
    return max(max(of.x, of.y), max(of.z, of.w)) - min(min(of.x, of.y), min(of.z, of.w));
}

vec2 sampleNear(vec3 image)
{
    vec2 place = perspective ? (image.z > nearest ? image.xy / image.z : vec2(0.0)) : image.xy;
    vec2 fromCorner = clamp(floor(place + pictureCentre), vec2(0.0), pictureSize) + 0.5;
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
    bool nearAny = false;
    for (int region = 0; region < regionCount; ++region) {
        vec4 shape = regionShapes[region];
        float border = regionPlaces[region].w;
        float margin = focusPart == within ? 0.0 : border;
        bool inRegion = true, inBorder = true;
        vec3 least = vec3(1e30), largest = vec3(-1e30);
        for (int i = 0; i < 4; ++i) {
            vec3 place = regionPlaces[region].xyz + worldFromImage * images[i].xyz;
            float away = shape.w > 0.0 ? length(place) - shape.x : length(max(abs(place) - shape.xyz, 0.0));
            inRegion = inRegion && away <= 0.0;
            inBorder = inBorder && away <= border;
            least = min(least, place);
            largest = max(largest, place);
        }
        if (focusPart == before ? inBorder : focusPart != within && inRegion)
            return true;
        nearAny = nearAny || !(any(greaterThan(least, shape.xyz + margin)) || any(lessThan(largest, -shape.xyz - margin)));
    }
    return focusPart != before && !nearAny;
}

// An affine function from its values at the corners, as the slope of CellInView; its gradient in u, v, w, too.
vec4 slopeOf(vec4 values, vec3 normals[4], float volume, vec3 corner, out vec3 gradient)
{
    vec3 rises = (values.yzw - values.x) / volume;
    gradient = rises.x * normals[1] + rises.y * normals[2] + rises.z * normals[3];
    float atOrigin = values.x - dot(gradient, corner);
    return vec4(gradient.xy, perspective ? gradient.z : atOrigin, perspective ? atOrigin : -gradient.z);
}

// False if nothing of the cell is drawn. `segmentOrigin`: of its segment, if it is the only one. `gradients`: for light.
bool setUpCell(vec4 images[4], vec3 gradients[4], bool oneSegment, float segmentOrigin, out CellInView cell)
{
    if (isElsewhere(images))
        return false;
    vec4 u = vec4(images[0].x, images[1].x, images[2].x, images[3].x);
    vec4 v = vec4(images[0].y, images[1].y, images[2].y, images[3].y);
    vec4 w = vec4(images[0].z, images[1].z, images[2].z, images[3].z);
    vec3 far = abs(images[0].xyz) + vec3(extent(u), extent(v), extent(w));

    cell.reference = sampleNear(images[0].xyz);
    vec2 shift = vec2(cell.reference.x - pictureCentre.x, pictureSize.y - pictureCentre.y - cell.reference.y) + sampleShift;
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
    if (!(abs(volume) > max(rounding, 1e-35)))
        return false; // a flat cell
    cell.inverted = volume < 0.0;
    float side = volume < 0.0 ? -1.0 : 1.0;
    for (int face = 0; face < 4; ++face)
        cell.faceBounds[face] = boundOf(normals[face] * side, dot(normals[face], c[face == 0 ? 1 : 0]) * side);

    vec4 values = vec4(images[0].w, images[1].w, images[2].w, images[3].w);
    vec3 gradient;
    cell.slope = slopeOf(values, normals, volume, c[0], gradient);
    vec3 across = vec3(gradient.xy * lengths, perspective ? gradient.z - dot(gradient.xy, shift) : gradient.z);
    float squared = dot(across, across);
    cell.perGradient = squared > 1e-30 ? inversesqrt(squared) : 0.0;
    cell.valueRange = vec3(min(min(values.x, values.y), min(values.z, values.w)),
                           max(max(values.x, values.y), max(values.z, values.w)), 1.0);
    // Of a thin cell how something changes across it is not trusted.
    bool thick = abs(volume) > width.x * width.y * width.z * thinnestCell;
    vec3 mean = 0.25 * (gradients[0] + gradients[1] + gradients[2] + gradients[3]);
    for (int axis = 0; axis < 3; ++axis) {
        vec4 components = thick ? vec4(gradients[0][axis], gradients[1][axis], gradients[2][axis], gradients[3][axis])
                                : vec4(mean[axis]);
        vec3 unused;
        cell.light[axis] = slopeOf(components, normals, volume, c[0], unused);
    }
    if (oneSegment && thick) {
        cell.slope -= perspective ? vec4(0.0, 0.0, 0.0, segmentOrigin) : vec4(0.0, 0.0, segmentOrigin, 0.0);
        cell.valueRange = vec3(cell.valueRange.xy - segmentOrigin, 0.0);
    }
    return true;
}
