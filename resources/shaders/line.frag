#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 colour;

layout(location = 0) out vec4 result;

void main()
{
    result = vec4(colour.rgb, 1.0);
}
