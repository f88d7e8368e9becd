#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A pixel is the mean of its samples, with straight alpha.
uniform sampler2D opaqueColour;
uniform sampler2D accumulated; // translucent layers; ignored without any
uniform bool layered;
uniform int samplesPerAxis;

layout(location = 0) out vec4 result;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samplesPerAxis;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < samplesPerAxis; ++y)
        for (int x = 0; x < samplesPerAxis; ++x) {
            ivec2 place = first + ivec2(x, y);
            vec4 front = layered ? texelFetch(accumulated, place, 0) : vec4(0.0);
            sum += front + (1.0 - front.a) * texelFetch(opaqueColour, place, 0);
        }
    sum /= float(samplesPerAxis * samplesPerAxis);
    result = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a) : vec4(0.0);
}
