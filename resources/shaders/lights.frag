#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The formula of core/render/shading.h. Directions are in the camera's axes: right, up, back.
uniform vec2 ownLight;  // ambient, headlight
uniform float twoSided;
uniform vec4 lights[3]; // where from, and how strong
uniform vec4 highlight;

// The factor of a colour and the highlight added to it, of a normal of length 1 towards the eye and its cosine with the
// direction to the eye.
vec2 lightOn(vec3 normal, float cosine)
{
    float front = min(1.0, 0.5 + cosine * 0.5 / twoSided);
    float factor = ownLight.x + ownLight.y * cosine;
    for (int i = 0; i < 3; ++i) {
        float falling = dot(normal, lights[i].xyz);
        factor += lights[i].w * falling * (falling > 0.0 ? front : front - 1.0);
    }
    float power = max(0.0, dot(normal, highlight.xyz));
    for (int doubled = 0; doubled < 5; ++doubled)
        power *= power;
    return vec2(factor, highlight.w * power);
}
