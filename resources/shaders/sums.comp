// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers become the sums of those before them, in blocks of eight for each invocation of a group; then, with `adding`,
// the sums of the blocks before are added. After compute.glsl.
layout(std430, binding = 0) buffer Numbers { uint numbers[]; };
layout(std430, binding = 1) buffer Blocks { uint blocks[]; };
uniform uint count;
uniform bool adding;

const uint perInvocation = 8u;
shared uint sums[gl_WorkGroupSize.x];

// Of all invocations before this one; `all` is the sum of the group.
uint sumBefore(uint own, out uint all)
{
    uint here = gl_LocalInvocationID.x;
    sums[here] = own;
    barrier();
    for (uint distance = 1u; distance < gl_WorkGroupSize.x; distance *= 2u) {
        uint before = here >= distance ? sums[here - distance] : 0u;
        barrier();
        sums[here] += before;
        barrier();
    }
    all = sums[gl_WorkGroupSize.x - 1u];
    return sums[here] - own;
}

void main()
{
    uint first = thisItem() * perInvocation;
    uint last = min(first + perInvocation, count);
    uint own = 0u;
    if (adding)
        own = first < count ? blocks[thisGroup()] : 0u;
    else
        for (uint i = first; i < last; ++i)
            own += numbers[i];
    uint before = own;
    if (!adding) {
        uint all;
        before = sumBefore(own, all);
        if (gl_LocalInvocationID.x == 0u && first < count)
            blocks[thisGroup()] = all;
    }
    for (uint i = first; i < last; ++i) {
        uint number = numbers[i];
        numbers[i] = adding ? number + before : before;
        before += adding ? 0u : number;
    }
}
