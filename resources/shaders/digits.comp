// SPDX-License-Identifier: GPL-3.0-or-later
// One digit of four bits of sorting by keys, stable. Each invocation counts its sixteen items by their digit; with
// `placing`, when all counts have become the sums of those before them, it puts the items where they belong. After
// compute.glsl.
layout(std430, binding = 0) readonly buffer From { uvec2 from[]; };
layout(std430, binding = 1) writeonly buffer To { uvec2 to[]; };
layout(std430, binding = 2) buffer Counts { uint counts[]; }; // for each digit those of all invocations
uniform uint count;
uniform uint shift;
uniform bool placing;

const uint perInvocation = 16u, digits = 16u;
shared uint own[digits * gl_WorkGroupSize.x];

void main()
{
    uint runs = (count + perInvocation - 1u) / perInvocation;
    uint run = thisItem();
    if (run >= runs)
        return;
    uint column = gl_LocalInvocationID.x;
    for (uint digit = 0u; digit < digits; ++digit)
        own[digit * gl_WorkGroupSize.x + column] = placing ? counts[digit * runs + run] : 0u;
    uint last = min((run + 1u) * perInvocation, count);
    for (uint i = run * perInvocation; i < last; ++i) {
        uvec2 item = from[i];
        uint place = (item.x >> shift & 15u) * gl_WorkGroupSize.x + column;
        if (placing)
            to[own[place]] = item;
        ++own[place];
    }
    if (!placing)
        for (uint digit = 0u; digit < digits; ++digit)
            counts[digit * runs + run] = own[digit * gl_WorkGroupSize.x + column];
}
