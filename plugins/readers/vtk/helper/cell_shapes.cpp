// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/cell_shapes.h"

#include <vtkCellType.h>
#include <vtkCellTypes.h>

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

bool isFlat(int vtkType)
{
    switch (vtkType) {
    case VTK_QUADRATIC_EDGE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_POLYGON:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_CURVE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_BEZIER_QUADRILATERAL: return true;
    default: return vtkType >= VTK_EMPTY_CELL && vtkType <= VTK_QUAD;
    }
}

/// The shapes of one kind of cell, with the number of nodes of each.
struct ShapeFamily {
    CellShape linear;
    vtkIdType corners;
    CellShape quadratic;
    vtkIdType middles; ///< corners and middles of edges
    vtkIdType whole;   ///< with the middles of faces and of the cell, of an order of 2
};
constexpr ShapeFamily tetrahedra{CellShape::Tetrahedron, 4, CellShape::QuadraticTetrahedron, 10, 10};
constexpr ShapeFamily pyramids{CellShape::Pyramid, 5, CellShape::QuadraticPyramid, 13, 14};
constexpr ShapeFamily prisms{CellShape::Prism, 6, CellShape::QuadraticPrism, 15, 18};
constexpr ShapeFamily hexahedra{CellShape::Hexahedron, 8, CellShape::QuadraticHexahedron, 20, 27};

CellReading cornersOf(const ShapeFamily& family, vtkIdType nodes, ShapeChange change)
{
    return {family.linear, std::min(nodes, family.corners), change};
}

/// One that is called linear may have the nodes of a quadratic one; no other has as many.
CellReading linearReading(const ShapeFamily& family, vtkIdType nodes)
{
    if (nodes == family.middles)
        return {family.quadratic, nodes, ShapeChange::CalledLinear};
    if (family.linear == CellShape::Hexahedron && nodes == family.whole)
        return {CellShape::TriquadraticHexahedron, nodes, ShapeChange::CalledLinear};
    return {family.linear, nodes};
}

CellReading quadraticReading(const ShapeFamily& family, vtkIdType nodes)
{
    return {family.quadratic, std::min(nodes, family.middles),
            nodes > family.middles ? ShapeChange::WithoutFaces : ShapeChange::None};
}

/// Of any order. Bezier cells have their corners on the places of these alone: `isLagrange` says that other nodes are
/// on theirs.
CellReading orderedReading(const ShapeFamily& family, vtkIdType nodes, const std::array<int, 3>& degrees,
                           bool isLagrange)
{
    const bool isUniform = degrees[0] == degrees[1] && degrees[0] == degrees[2];
    if (nodes <= family.corners)
        return {family.linear, nodes};
    if (!isLagrange || !isUniform || (nodes != family.middles && nodes != family.whole))
        return cornersOf(family, nodes, ShapeChange::CornersAlone);
    if (family.linear == CellShape::Hexahedron && nodes == family.whole)
        return {CellShape::TriquadraticHexahedron, nodes};
    return quadraticReading(family, nodes);
}

} // namespace

std::optional<CellReading> cellReading(int vtkType, vtkIdType nodes, const std::array<int, 3>& degrees)
{
    switch (vtkType) {
    case VTK_TETRA: return linearReading(tetrahedra, nodes);
    case VTK_PYRAMID: return linearReading(pyramids, nodes);
    case VTK_WEDGE: return linearReading(prisms, nodes);
    case VTK_HEXAHEDRON: return linearReading(hexahedra, nodes);
    case VTK_VOXEL: return CellReading{CellShape::Voxel, nodes};
    case VTK_QUADRATIC_TETRA: return quadraticReading(tetrahedra, nodes);
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID: return quadraticReading(pyramids, nodes);
    case VTK_QUADRATIC_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE: return quadraticReading(prisms, nodes);
    case VTK_QUADRATIC_LINEAR_WEDGE: return cornersOf(prisms, nodes, ShapeChange::CornersAlone);
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON: return quadraticReading(hexahedra, nodes);
    case VTK_TRIQUADRATIC_HEXAHEDRON: return CellReading{CellShape::TriquadraticHexahedron, nodes};
    case VTK_LAGRANGE_TETRAHEDRON: return orderedReading(tetrahedra, nodes, degrees, true);
    case VTK_LAGRANGE_PYRAMID: return orderedReading(pyramids, nodes, degrees, true);
    case VTK_LAGRANGE_WEDGE: return orderedReading(prisms, nodes, degrees, true);
    case VTK_LAGRANGE_HEXAHEDRON: return orderedReading(hexahedra, nodes, degrees, true);
    case VTK_BEZIER_TETRAHEDRON: return orderedReading(tetrahedra, nodes, degrees, false);
    case VTK_BEZIER_PYRAMID: return orderedReading(pyramids, nodes, degrees, false);
    case VTK_BEZIER_WEDGE: return orderedReading(prisms, nodes, degrees, false);
    case VTK_BEZIER_HEXAHEDRON: return orderedReading(hexahedra, nodes, degrees, false);
    case VTK_POLYHEDRON:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM: return CellReading{CellShape::Polyhedron, nodes};
    default: return isFlat(vtkType) ? std::optional(CellReading{CellShape::Flat, nodes}) : std::nullopt;
    }
}

std::vector<vtkIdType> prismFaces(const vtkIdType* corners, vtkIdType count)
{
    const vtkIdType sides = count / 2;
    std::vector<vtkIdType> faces;
    for (const vtkIdType base : {vtkIdType(0), sides}) {
        faces.push_back(sides);
        faces.insert(faces.end(), corners + base, corners + base + sides);
    }
    for (vtkIdType side = 0; side < sides; ++side) {
        const vtkIdType next = (side + 1) % sides;
        faces.insert(faces.end(), {4, corners[side], corners[next], corners[sides + next], corners[sides + side]});
    }
    return faces;
}

Message cellTypeName(int vtkType)
{
    const char* found = vtkCellTypes::GetClassNameFromTypeId(vtkType);
    std::string_view name = found == nullptr ? "" : found;
    if (name.empty() || name == "UnknownClass")
        return Message::say("number %1", vtkType);
    if (name.starts_with("vtk"))
        name.remove_prefix(3);
    return name;
}

Message shapeChangeText(ShapeChange change, std::uint64_t cells)
{
    const bool one = cells == 1;
    switch (change) {
    case ShapeChange::CalledLinear:
        return one ? Message::say(
                         "1 cell is declared linear and has the corners of a quadratic one: it was read as such.")
                   : Message::say(
                         "%1 cells are declared linear and have the corners of quadratic ones: they were read as such.",
                         cells);
    case ShapeChange::WithoutFaces:
        return one ? Message::say("1 cell has nodes in the middle of its faces, which were not used.")
                   : Message::say("%1 cells have nodes in the middle of their faces, which were not used.", cells);
    case ShapeChange::CornersAlone:
        return one ? Message::say("1 cell is of a higher order: it was read by its corners alone, with straight edges.")
                   : Message::say("%1 cells are of a higher order: they were read by their corners alone, with "
                                  "straight edges.",
                                  cells);
    case ShapeChange::None: break;
    }
    return {};
}

} // namespace tetra
