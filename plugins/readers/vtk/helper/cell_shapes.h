// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetra {

/// What a cell is taken for that is not what its file calls it.
enum class ShapeChange : std::uint8_t {
    None,
    CalledLinear, ///< it is called linear, and has the nodes of a quadratic one
    WithoutFaces, ///< quadratic, with nodes in the middle of its faces, which are not used
    CornersAlone  ///< of a higher order: read by its corners
};

/// How a cell of VTK is read: as a shape whose corners and nodes are its first ones. A prism with more than four sides
/// is a polyhedron; its faces tells prismFaces().
struct CellReading {
    CellShape shape = CellShape::Flat;
    vtkIdType nodes = 0; ///< how many of its nodes are used
    ShapeChange change = ShapeChange::None;
};

/// How a cell of that type (vtkCellType.h) with so many nodes is read; nothing if TAn does not know its shape.
/// `degrees` along its three axes count for Lagrange cells, whose number of nodes may leave them open; zeros where the
/// file does not say. VTK numbers the nodes of Lagrange cells of order 2 as those of its quadratic cells, followed by
/// the middles of faces; its readers turn the numbers of files before VTK 9.1 into these.
std::optional<CellReading> cellReading(int vtkType, vtkIdType nodes, const std::array<int, 3>& degrees);

/// The faces of a prism of VTK over a polygon of half its corners, as CellShape::Polyhedron has them.
std::vector<vtkIdType> prismFaces(const vtkIdType* corners, vtkIdType count);

/// "ConvexPointSet", "number 17".
Message cellTypeName(int vtkType);

/// A sentence about so many cells that were changed so.
Message shapeChangeText(ShapeChange change, std::uint64_t cells);

} // namespace tetra
