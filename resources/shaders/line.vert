#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec4 clipPosition;

uniform bool overlay; // as in surface.vert

void main()
{
    gl_Position = overlay ? vec4(clipPosition.xy, -clipPosition.w, clipPosition.w) : clipPosition;
}
