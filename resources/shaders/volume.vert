// SPDX-License-Identifier: GPL-3.0-or-later
// The four faces of each cell, to be drawn where they look away from the eye: there every ray through the cell leaves it,
// also if the eye or the near plane is inside. After image.glsl, cell.glsl and faces.glsl.
uniform samplerBuffer vertices;  // place and value
uniform samplerBuffer gradients; // for light
uniform bool shaded;
uniform mat3 viewAxes;           // right, down and away from the eye, of unit length, as rows
uniform usamplerBuffer corners;  // of the cells, front to back
uniform usamplerBuffer segmentsOfCell; // first and last
uniform samplerBuffer segments;

void main()
{
    int cell = gl_VertexID / 12;
    uvec4 cornersOfCell = texelFetch(corners, cell);
    ivec2 range = ivec2(texelFetch(segmentsOfCell, cell).xy);
    vec4 images[4];
    vec3 gradientsOfCell[4];
    for (int i = 0; i < 4; ++i) {
        images[i] = imageOf(texelFetch(vertices, int(cornersOfCell[i])));
        gradientsOfCell[i] = shaded ? viewAxes * texelFetch(gradients, int(cornersOfCell[i])).xyz : vec3(0.0);
    }
    CellInView inView;
    if (!setUpCell(images, gradientsOfCell, range.x == range.y, texelFetch(segments, 3 * range.x).z, inView)) {
        gl_Position = nowhere;
        return;
    }
    gl_Position = clipPositionOf(images[cornerOf(gl_VertexID % 12, inView.inverted)].xyz);
    handOn(inView, range);
}
