// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/writers/mesh_file.h"

#include <cstddef>

namespace tetra {

/// One surface of several: an isosurface, or the boundary of a mesh. Points into arrays that outlive the writing.
struct SurfacePart {
    std::string name; ///< of the group or object, in the formats that have such
    std::span<const Eigen::Vector3f> positions;
    std::span<const Eigen::Vector3f> normals; ///< of length 1, one for each position; of all parts or of none
    std::span<const std::array<std::uint32_t, 3>> triangles; ///< numbers of the part's positions; counterclockwise
    /// One for each position, or one for all.
    std::variant<float, std::span<const float>> values = 0.0F;
    std::array<float, 4> colour = {0.8F, 0.8F, 0.8F, 1.0F}; ///< sRGB and opacity, for the formats that have colours
};

/// What a surface file holds.
struct SurfaceContent {
    std::string title;     ///< "isosurfaces", in the file's first line
    std::string valueName; ///< of the array of the parts' values
    std::vector<SurfacePart> parts;
    MeshFacts facts;
};

/// Whether the name's ending is one that writeSurfaceFile() knows; if not, WrongUsage with those that it knows.
Status checkSurfaceFileName(const std::filesystem::path& path);

/// Whether the ending is that of a format for surfaces alone, in which a mesh can only be given by its boundary.
bool isSurfaceFileOnly(const std::filesystem::path& path);

/// Writes triangles in the format that the name's ending asks for, safely and in pieces as writeMeshFile() does; the
/// numbers are the same under every locale. The parts' vertices and triangles come one part after the other.
/// docs/formats.md describes:
/// `.vtp`  VTK XML polydata, appended raw, little endian; `.vtu`  the same as an unstructured grid of triangles;
/// `.vtk`  VTK legacy 4.2 polydata, binary;
/// `.ply`  binary little endian: elements `vertex` and `face`;
/// `.stl`  binary: triangles without shared vertices;
/// `.obj`  Wavefront text, a group for each part;
/// `.glb`  glTF 2.0 in one binary file, a mesh with a material for each part.
/// Errors: WrongUsage (another ending, arrays that do not fit), OutOfResource (more than the format can number),
/// CannotWrite, Cancelled.
Status writeSurfaceFile(const std::filesystem::path& path, const SurfaceContent& content,
                        const Progress& progress = {});

} // namespace tetra
