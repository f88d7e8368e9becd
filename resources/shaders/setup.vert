// SPDX-License-Identifier: GPL-3.0-or-later
// As volume.vert, of cells that setup.comp has made ready. After image.glsl, cell.glsl and faces.glsl.
uniform usamplerBuffer cells;
uniform samplerBuffer projected;

const uint isShown = 1u, isInverted = 2u;

vec4 numbers(int word)
{
    return uintBitsToFloat(texelFetch(cells, word));
}

void main()
{
    int at = gl_VertexID / 12 * 8;
    uvec4 kind = texelFetch(cells, at + 1);
    if ((kind.x & isShown) == 0u) {
        gl_Position = nowhere;
        return;
    }
    CellInView inView;
    for (int face = 0; face < 4; ++face)
        inView.faceBounds[face] = numbers(at + 4 + face);
    vec4 values = numbers(at + 3);
    inView.slope = numbers(at + 2);
    inView.valueRange = values.xyz;
    inView.perGradient = values.w;
    inView.reference = uintBitsToFloat(kind.zw);
    inView.inverted = (kind.x & isInverted) != 0u;
    uint corner = texelFetch(cells, at)[cornerOf(gl_VertexID % 12, inView.inverted)];
    gl_Position = clipPositionOf(texelFetch(projected, int(corner)).xyz);
    handOn(inView, ivec2(kind.y & 0xffffu, kind.y >> 16));
}
