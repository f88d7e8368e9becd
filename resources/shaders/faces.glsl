// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of a cell's faces and what volume.frag reads of the cell; after image.glsl and cell.glsl.
flat out vec4 faceBounds[4];
flat out vec4 slope;
flat out vec3 valueRange;
flat out ivec2 segmentRange;
flat out vec2 reference;
flat out float perGradient;
flat out vec4 gradientAlong[3];

const int faceCorners[12] = int[](0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
const vec4 nowhere = vec4(0.0, 0.0, 2.0, 1.0);

// Which corner is the one of twelve vertices.
int cornerOf(int place, bool inverted)
{
    return faceCorners[inverted ? place - place % 3 + (3 - place % 3) % 3 : place];
}

void handOn(CellInView cell, ivec2 segmentsOfIt)
{
    faceBounds = cell.faceBounds;
    slope = cell.slope;
    valueRange = cell.valueRange;
    segmentRange = segmentsOfIt;
    reference = cell.reference;
    perGradient = cell.perGradient;
    gradientAlong = cell.light;
}
