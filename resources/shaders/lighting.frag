#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The formula of core/render/scene.h.
uniform vec3 light; // ambient, diffuse, specular

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye)
{
    float dotProduct = dot(normal, towardsEye);
    float lengths = dot(normal, normal) * dot(towardsEye, towardsEye);
    float squared = lengths > 0.0 ? min(1.0, dotProduct * dotProduct / lengths) : 1.0;
    float power4 = squared * squared;
    float power8 = power4 * power4;
    float power16 = power8 * power8;
    return min(vec3(1.0), colour * (light.x + light.y * sqrt(squared)) + light.z * power16 * power16);
}
