#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// What sums are bounded by: the blending takes the smaller.
layout(location = 0) out vec4 result;

void main()
{
    result = vec4(1.0);
}
