#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// What is not shown of a surface. The planes that cut it: shown is what lies at xyz . place + w >= 0 for all of them.
uniform bool backFacesOnly;
uniform int cutCount;
uniform vec4 cuts[16];

bool isCutOff(vec3 place)
{
    if (backFacesOnly && gl_FrontFacing)
        return true;
    for (int i = 0; i < cutCount; ++i)
        if (dot(cuts[i].xyz, place) + cuts[i].w < 0.0)
            return true;
    return false;
}
