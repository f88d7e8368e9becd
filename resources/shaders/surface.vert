#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A lit surface. Positions are relative to an origin of the mesh's own: far from zero, floats would be too coarse.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 vertexColour; // if coloured

uniform mat4 clipFromMesh;
uniform vec4 colour;
uniform bool coloured;
uniform bool overlay; // over everything: at the near plane
uniform vec4 eye; // its place (w = 1), or the direction towards it (w = 0)
uniform mat3 cameraFromWorld; // right, up, back

out vec3 surfaceColour;
out vec3 surfaceNormal;
out vec3 towardsEye;
out vec3 placeInMesh;

// Peeling draws the same triangles again and again and compares their depths.
invariant gl_Position;

void main()
{
    gl_Position = clipFromMesh * vec4(position, 1.0);
    if (overlay)
        gl_Position.z = -gl_Position.w;
    placeInMesh = position;
    surfaceColour = coloured ? vertexColour : colour.rgb;
    surfaceNormal = cameraFromWorld * normal;
    towardsEye = cameraFromWorld * (eye.xyz - eye.w * position);
}
