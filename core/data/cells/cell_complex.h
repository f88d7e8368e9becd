// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The shape of a cell as files have it; corners are numbered as in VTK. Quadratic cells carry their nodes of order two
/// after the corners.
enum class CellShape : std::uint8_t {
    Tetrahedron,
    Pyramid,
    Prism,
    Hexahedron,
    Voxel, ///< a hexahedron along the axes, corners x fastest
    QuadraticTetrahedron,
    QuadraticPyramid,
    QuadraticPrism,
    QuadraticHexahedron,
    TriquadraticHexahedron,
    Polyhedron, ///< refused, with their count
    Flat        ///< vertices, lines, triangles, quadrilaterals: without volume, left out and said
};

/// Cells of mixed shapes over points, as a reader finds them: nothing about them is certain yet.
struct CellComplex {
    std::vector<Eigen::Vector3d> positions;
    std::vector<CellShape> shapes;
    std::vector<std::uint64_t> offsets; ///< the corners of cell c are corners[offsets[c]] up to corners[offsets[c + 1]]
    std::vector<std::uint64_t> corners; ///< numbers of positions
    std::vector<std::uint8_t> blanked;  ///< one a cell, not 0: no part of the domain; empty if none is
};

/// Values for the points of a complex, or for its cells.
struct ComplexValues {
    std::vector<double> values;
    bool perCell = false;                  ///< brought to the points as the mean of the cells around, which is said
    SampleType type = SampleType::Float32; ///< that the dataset keeps them in
};

/// The irregular dataset that such cells make (R1, S6, S20), which passes checkIrregular(): every cell is cut into
/// tetrahedra, quadratic ones through all their nodes; cells blanked or with a value that is not finite are holes.
/// Harmless things are repaired and said in `remarks`: points on one place (the mean of their values), points that no
/// cell uses, cells with a repeated corner, of no volume, turned over or there twice. Refused with a count and an
/// example: polyhedra, overlapping cells, faces in three cells, a boundary that is no manifold or meets itself, numbers
/// of points out of range, nothing left. One thread, about 300 bytes a tetrahedron; safe from any thread.
Result<Dataset> irregularDataset(const CellComplex& complex, const ComplexValues& values, const Source& source,
                                 const Progress& progress = {});

/// How the corners, edges and faces of a cell hang together; numbers of corners as in VTK.
struct CellTopology {
    struct Face {
        std::array<std::uint8_t, 4> corners; ///< seen from outside a positive cell counterclockwise
        std::uint8_t count;                  ///< of corners: 3 or 4
    };
    std::uint8_t cornerCount;
    std::span<const Face> faces;
    std::span<const std::array<std::uint8_t, 2>> edges; ///< in the order in which VTK numbers their middle nodes
};

/// Of the linear cell with the same corners; a voxel's is that of a hexahedron (hexahedronCorner() renumbers it), a
/// polyhedron and a flat cell have none: no corners.
const CellTopology& cellTopology(CellShape shape);

/// How many nodes a cell of this shape has; 0 for polyhedra and flat ones, which have any number.
std::uint32_t nodeCount(CellShape shape);

/// Whether the cell has a node in the middle of each edge.
bool isQuadratic(CellShape shape);

/// The place of a voxel's corner among those of a hexahedron, and the reverse.
constexpr std::uint32_t hexahedronCorner(std::uint32_t voxelCorner)
{
    return voxelCorner ^ ((voxelCorner >> 1) & 1);
}

/// What is called so in messages: "hexahedron".
std::string_view cellShapeName(CellShape shape);

} // namespace tetra
