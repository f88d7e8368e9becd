#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec4 colour;

in vec3 surfaceNormal;
in vec3 towardsEye;

layout(location = 0) out vec4 result;

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye);

void main()
{
    result = vec4(lit(colour.rgb, surfaceNormal, towardsEye), 1.0);
}
