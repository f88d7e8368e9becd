// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

/// A number for each vertex, or for each tetrahedron, with a name.
struct NamedArray {
    using Values = std::variant<std::span<const float>, std::span<const double>, std::span<const std::uint8_t>,
                                std::span<const std::uint16_t>, std::span<const std::uint32_t>>;
    std::string name;
    Values values;
};

/// What is said of a mesh as a whole: field data of VTK files, comments of PLY files. Names are not empty.
using MeshFacts = std::vector<std::pair<std::string, std::variant<double, std::string>>>;

/// What a mesh file holds. Points into arrays that outlive the writing.
struct MeshContent {
    std::span<const Eigen::Vector3f> positions;
    std::span<const std::array<std::uint32_t, 4>> tetrahedra; ///< numbers of positions
    std::vector<NamedArray> pointArrays;                      ///< as many values as there are positions ...
    std::vector<NamedArray> cellArrays;                       ///< ... or tetrahedra
    MeshFacts facts;
};

/// Whether the name's ending is one that writeMeshFile() knows; if not, WrongUsage with those that it knows. For asking
/// before the mesh is made.
Status checkMeshFileName(const std::filesystem::path& path);

/// Writes a mesh in the format that the name's ending asks for, safely (FileWriter), in pieces: the memory it needs
/// does not depend on the mesh. Stops within a second of being cancelled, but for the disk itself. docs/formats.md
/// describes:
/// `.vtu`  VTK XML unstructured grid, appended raw, little endian, 64-bit headers;
/// `.vtk`  VTK legacy 4.2 unstructured grid, binary;
/// `.ply`  binary little endian: elements `vertex` and `cell`;
/// `.vtp`, `.stl`, `.obj`, `.glb`  the boundary as triangles (surface_file.h), with the vertices' first array of
/// floats;
///         finding it takes memory as boundaryFaces() does.
/// Errors: WrongUsage (another ending, arrays that do not fit), OutOfResource (more vertices or cells than the format
/// can number), CannotWrite, Cancelled.
Status writeMeshFile(const std::filesystem::path& path, const MeshContent& content, const Progress& progress = {});

} // namespace tetra
