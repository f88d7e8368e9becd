#version 430 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The beginning of every compute shader: one invocation an item, in as many groups as it takes, of two dimensions where
// one would not allow so many.
layout(local_size_x = 256) in;

uint thisGroup()
{
    return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}

uint thisItem()
{
    return thisGroup() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
}
