#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of a ray whose pieces are gathered, by an optical model of somebody's own (OpticalModel::lightOfRay).
uniform sampler2D gathered;

layout(location = 0) out vec4 result;

vec4 lightOfRay(float opacity);

void main()
{
    float opacity = min(texelFetch(gathered, ivec2(gl_FragCoord.xy), 0).a, 1.0);
    vec4 light = opacity > 0.0 ? lightOfRay(opacity) : vec4(0.0);
    // What is no number is 0.
    float seen = light.a > 0.0 ? min(light.a, 1.0) : 0.0;
    result = vec4(mix(vec3(0.0), min(light.rgb, vec3(seen)), greaterThan(light.rgb, vec3(0.0))), seen);
}
