#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The light on surfaces; `normal` and `towardsEye` in the camera's axes, of any length.
uniform bool isLit;

vec2 lightOn(vec3 normal, float cosine);

vec3 lit(vec3 colour, vec3 normal, vec3 towardsEye)
{
    if (!isLit)
        return colour;
    float dotProduct = dot(normal, towardsEye);
    float lengths = dot(normal, normal) * dot(towardsEye, towardsEye);
    vec2 light = lengths > 0.0 ? lightOn(normalize(dotProduct < 0.0 ? -normal : normal), min(1.0, abs(dotProduct) * inversesqrt(lengths)))
                               : lightOn(vec3(0.0, 0.0, 1.0), 1.0);
    return min(vec3(1.0), colour * light.x + light.y);
}
