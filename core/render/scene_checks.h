// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <optional>

namespace tetra {

/// An error if the mesh has not one normal a vertex, or as many values or colours if any, or a triangle has a corner
/// that does not exist. O(triangles).
Status checkMesh(const TriangleMesh& mesh);
/// An error if a segment has an end that does not exist. O(segments).
Status checkLines(const LineSet& lines);

/// Whether light changes the colours of a surface that has a mesh.
inline bool isLit(const Surface& surface)
{
    return surface.lit.value_or(surface.mesh->colours.empty());
}

/// The scene with what its custom drawables draw in a picture in their place; nothing if it has none. May throw what
/// they throw.
std::optional<Scene> withDrawn(const Scene& scene, const Camera& camera, int width, int height);

/// In pixels. Numbers of samples, the one after the last included, have 16 bits where a volume is drawn.
inline constexpr int largestPictureSide = 32767;

/// An error if no back end can make such a picture.
Status checkOptions(const PictureOptions& options);
/// What is drawn of the picture: the part, else all of it.
PixelRectangle drawnPart(const PictureOptions& options);

} // namespace tetra
