#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
in vec3 surfaceColour;
in vec3 surfaceNormal;
in vec3 towardsEye;
in vec3 placeInMesh;

layout(location = 0) out vec4 result;

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye);
bool isCutOff(vec3 place);

void main()
{
    if (isCutOff(placeInMesh))
        discard;
    result = vec4(lit(surfaceColour, surfaceNormal, towardsEye), 1.0);
}
