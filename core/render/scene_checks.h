// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

namespace tetra {

/// An error if the mesh has not one normal a vertex, or as many values or colours if any, or a triangle has a corner
/// that does not exist. O(triangles).
Status checkMesh(const TriangleMesh& mesh);
/// An error if a segment has an end that does not exist. O(segments).
Status checkLines(const LineSet& lines);

/// In pixels. Numbers of samples, the one after the last included, have 16 bits where a volume is drawn.
inline constexpr int largestPictureSide = 32767;

/// An error if no back end can make such a picture.
Status checkOptions(const PictureOptions& options);

} // namespace tetra
