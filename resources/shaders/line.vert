#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec4 clipPosition;

void main()
{
    gl_Position = clipPosition;
}
