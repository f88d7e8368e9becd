// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/vtu_cells.h"

#include "plugins/readers/cells/vtu_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace tetra {

namespace {

enum VtkType : std::uint64_t {
    PolyVertex = 2,
    PentagonalPrism = 15,
    HexagonalPrism = 16,
    BiquadraticWedge = 32,
    BiquadraticHexahedron = 33,
    TriquadraticPyramid = 37,
    PolyhedronType = 42,
    LagrangeTetrahedron = 71,
    LagrangeHexahedron = 72,
    LagrangeWedge = 73,
    LagrangePyramid = 74
};

/// Of a shape that needs no look at the nodes; nothing for others.
std::optional<CellShape> plainShape(std::uint64_t vtkType)
{
    switch (vtkType) {
    case 10: return CellShape::Tetrahedron;
    case 11: return CellShape::Voxel;
    case 12: return CellShape::Hexahedron;
    case 13: return CellShape::Prism;
    case 14: return CellShape::Pyramid;
    case 24: return CellShape::QuadraticTetrahedron;
    case 25: return CellShape::QuadraticHexahedron;
    case 26: return CellShape::QuadraticPrism;
    case 27: return CellShape::QuadraticPyramid;
    case 29: return CellShape::TriquadraticHexahedron;
    // Vertices, lines, strips and polygons, straight and curved.
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
    case 21:
    case 22:
    case 23:
    case 28:
    case 30:
    case 34:
    case 35:
    case 36:
    case 60:
    case 61:
    case 62:
    case 63:
    case 68:
    case 69:
    case 70:
    case 75:
    case 76:
    case 77: return CellShape::Flat;
    default: return std::nullopt;
    }
}

/// Of shapes that are not read.
Message nameOf(std::uint64_t vtkType)
{
    switch (vtkType) {
    case 31: return Message::say("quadratic-linear wedges");
    case 41: return Message::say("convex point sets");
    case 78: return Message::say("Bezier tetrahedra");
    case 79: return Message::say("Bezier hexahedra");
    case 80: return Message::say("Bezier wedges");
    case 81: return Message::say("Bezier pyramids");
    default: return Message::say("number %1", vtkType);
    }
}

/// The quadratic shape of so many nodes, for cells that are called linear; nothing else has as many.
std::optional<CellShape> quadraticShape(CellShape shape, std::uint64_t nodes)
{
    switch (shape) {
    case CellShape::Tetrahedron: return nodes == 10 ? std::optional(CellShape::QuadraticTetrahedron) : std::nullopt;
    case CellShape::Pyramid: return nodes == 13 ? std::optional(CellShape::QuadraticPyramid) : std::nullopt;
    case CellShape::Prism: return nodes == 15 ? std::optional(CellShape::QuadraticPrism) : std::nullopt;
    case CellShape::Hexahedron: return nodes == 20 ? std::optional(CellShape::QuadraticHexahedron) : std::nullopt;
    default: return std::nullopt;
    }
}

/// How a cell is taken: the first `nodes` of its nodes are those of the shape.
struct TakenShape {
    CellShape shape;
    std::uint64_t nodes;
};

/// What is known of a kind of Lagrange cells.
struct LagrangeKind {
    TakenShape linear;
    std::optional<TakenShape> quadratic;
    std::uint64_t (*nodesOfOrder)(std::uint64_t order);
};

const LagrangeKind* lagrangeKind(std::uint64_t vtkType)
{
    static constexpr LagrangeKind kinds[] = {
        {{CellShape::Tetrahedron, 4},
         TakenShape{CellShape::QuadraticTetrahedron, 10},
         [](std::uint64_t p) { return (p + 1) * (p + 2) * (p + 3) / 6; }},
        {{CellShape::Hexahedron, 8},
         TakenShape{CellShape::TriquadraticHexahedron, 27},
         [](std::uint64_t p) { return (p + 1) * (p + 1) * (p + 1); }},
        {{CellShape::Prism, 6},
         TakenShape{CellShape::QuadraticPrism, 15},
         [](std::uint64_t p) { return (p + 1) * (p + 1) * (p + 2) / 2; }},
        {{CellShape::Pyramid, 5}, std::nullopt, [](std::uint64_t p) { return (p + 1) * (p + 2) * (2 * p + 3) / 6; }}};
    return vtkType >= LagrangeTetrahedron && vtkType <= LagrangePyramid ? &kinds[vtkType - LagrangeTetrahedron]
                                                                        : nullptr;
}

using Degrees = std::array<std::uint64_t, 3>;

/// The order of a Lagrange cell with so many nodes; 0 if it is not one in all directions. `degrees` 0: not told.
std::uint64_t orderOf(const LagrangeKind& kind, std::uint64_t nodes, const Degrees& degrees)
{
    constexpr std::uint64_t most = 100;
    const bool isTold = degrees[0] > 0;
    // Wedges of order 2 may have no nodes in their faces, or one in each.
    const bool isWedge = kind.linear.shape == CellShape::Prism;
    if (isWedge && (nodes == 15 || nodes == 21) && (!isTold || degrees == Degrees{2, 2, 2}))
        return 2;
    std::uint64_t order = 1;
    while (order < most && kind.nodesOfOrder(order) < nodes)
        ++order;
    const bool fits = kind.nodesOfOrder(order) == nodes && (!isTold || degrees == Degrees{order, order, order});
    return fits ? order : 0;
}

class PieceCells {
public:
    PieceCells(const VtuHead& head, const VtuPiece& piece, std::uint64_t firstPoint, CellComplex& complex,
               VtuCellNotes& notes)
        : head_(head), piece_(piece), firstPoint_(firstPoint), complex_(complex), notes_(notes)
    {
    }

    Result<VtuNodes> run()
    {
        if (const Status read = readNodes(); !read)
            return read.error();
        if (const Status read = readFaces(); !read)
            return read.error();
        if (const Status read = readDegrees(); !read)
            return read.error();
        for (std::uint64_t cell = 0; cell < piece_.cells; ++cell)
            if (const Status added = add(cell); !added)
                return added.error();
        return std::move(file_);
    }

private:
    static Error bad(Message text) { return {ErrorKind::BadInput, std::move(text)}; }

    Status readNodes()
    {
        auto ends = readIntegers(head_, piece_.offsets, piece_.cells);
        if (!ends)
            return ends.error();
        if (!std::ranges::is_sorted(*ends))
            return bad(Message::say("the offsets of its cells do not rise."));
        auto nodes = readIntegers(head_, piece_.connectivity, ends->back());
        if (!nodes)
            return nodes.error();
        for (const std::uint64_t node : *nodes)
            if (const Status exists = checkPoint(node); !exists)
                return exists;
        auto types = readIntegers(head_, piece_.types, piece_.cells);
        if (!types)
            return types.error();
        file_ = {*std::move(ends), *std::move(nodes)};
        types_ = *std::move(types);
        return {};
    }

    Status checkPoint(std::uint64_t point) const
    {
        if (point < piece_.points)
            return {};
        return bad(
            Message::say("a cell has the corner %1 of %2 points.", static_cast<std::int64_t>(point), piece_.points));
    }

    /// The faces of polyhedra: of each cell their number, of each the number of its points and these.
    Status readFaces()
    {
        if (std::ranges::find(types_, std::uint64_t(PolyhedronType)) == types_.end())
            return {};
        if (piece_.faces.type.empty() || piece_.faceOffsets.type.empty())
            return readListedFaces();
        auto ends = readDoubles(head_, piece_.faceOffsets, piece_.cells); // -1 for other cells
        if (!ends)
            return ends.error();
        const double last = std::max(0.0, *std::ranges::max_element(*ends));
        constexpr double most = 9007199254740992; // 2^53
        if (!(last < most))
            return bad(Message::say("the offsets of its faces are out of range."));
        faceEnds_ = *std::move(ends);
        auto faces = readIntegers(head_, piece_.faces, static_cast<std::uint64_t>(last));
        if (!faces)
            return faces.error();
        faces_ = *std::move(faces);
        return {};
    }

    /// As VTK writes them from 9.4 on: the faces of the piece, and for each cell the numbers of its faces.
    Status readListedFaces()
    {
        for (const VtuArray* array : {&piece_.facePoints, &piece_.faceEnds, &piece_.cellFaces, &piece_.cellFaceEnds})
            if (array->type.empty())
                return bad(Message::say(
                    "it has polyhedra, but not their faces: these are in the arrays 'faces' and 'faceoffsets' or, "
                    "since VTK 9.4, 'face_connectivity', 'face_offsets', 'polyhedron_to_faces' and "
                    "'polyhedron_offsets'. Save it again, or divide its cells into tetrahedra."));
        const auto points = readAllIntegers(head_, piece_.facePoints), ends = readAllIntegers(head_, piece_.faceEnds);
        if (!points || !ends)
            return points ? ends.error() : points.error();
        const auto cellEnds = readIntegers(head_, piece_.cellFaceEnds, piece_.cells);
        if (!cellEnds)
            return cellEnds.error();
        const auto cellFaces = readIntegers(head_, piece_.cellFaces, cellEnds->back());
        if (!cellFaces)
            return cellFaces.error();
        if (!std::ranges::is_sorted(*ends) || (!ends->empty() && ends->back() > points->size()) ||
            !std::ranges::is_sorted(*cellEnds))
            return bad(Message::say("the offsets of its faces do not rise, or point beyond their points."));
        // A face lies in two cells at most; cells that are there twice are borne.
        constexpr std::uint64_t mostUses = 8;
        const std::uint64_t most = mostUses * (points->size() + ends->size()) + piece_.cells;
        faceEnds_.assign(piece_.cells, -1);
        for (std::uint64_t cell = 0, at = 0; cell < piece_.cells; at = (*cellEnds)[cell++]) {
            if (types_[cell] != PolyhedronType)
                continue;
            faces_.push_back((*cellEnds)[cell] - at);
            for (std::uint64_t i = at; i < (*cellEnds)[cell]; ++i) {
                const std::uint64_t face = (*cellFaces)[i];
                if (face >= ends->size())
                    return bad(Message::say("the polyhedron %1 has the face %2 of %3.", cell, face, ends->size()));
                const std::uint64_t begin = face == 0 ? 0 : (*ends)[face - 1], count = (*ends)[face] - begin;
                if (faces_.size() + count > most)
                    return bad(Message::say("its polyhedra use its faces more often than cells of a mesh can."));
                faces_.push_back(count);
                const auto of = std::span(*points).subspan(begin, count);
                faces_.insert(faces_.end(), of.begin(), of.end());
            }
            faceEnds_[cell] = static_cast<double>(faces_.size());
        }
        return {};
    }

    Status readDegrees()
    {
        const auto array = std::ranges::find(piece_.cellArrays, "HigherOrderDegrees", &VtuArray::name);
        const bool hasLagrange = std::ranges::any_of(types_, [](std::uint64_t type) { return lagrangeKind(type); });
        if (!hasLagrange || array == piece_.cellArrays.end() || array->components != 3 ||
            piece_.cells > std::numeric_limits<std::uint64_t>::max() / 3)
            return {};
        auto degrees = readDoubles(head_, *array, 3 * piece_.cells);
        if (!degrees)
            return degrees.error();
        degrees_ = *std::move(degrees);
        return {};
    }

    Status add(std::uint64_t cell)
    {
        const std::uint64_t begin = cell == 0 ? 0 : file_.ends[cell - 1], type = types_[cell];
        const auto nodes = std::span(file_.nodes).subspan(begin, file_.ends[cell] - begin);
        if (type == PolyhedronType)
            return addPolyhedron(cell);
        if (type == PentagonalPrism || type == HexagonalPrism)
            return addPrism(nodes, type == PentagonalPrism ? 5 : 6);
        if (const LagrangeKind* kind = lagrangeKind(type))
            return addLagrange(*kind, cell, nodes);
        if (type == BiquadraticWedge)
            return addWithoutFaceNodes({CellShape::QuadraticPrism, 15}, 18, nodes);
        if (type == BiquadraticHexahedron)
            return addWithoutFaceNodes({CellShape::QuadraticHexahedron, 20}, 24, nodes);
        if (type == TriquadraticPyramid)
            return addWithoutFaceNodes({CellShape::QuadraticPyramid, 13}, 19, nodes);
        const auto shape = plainShape(type);
        if (!shape)
            return bad(Message::say(
                "it has cells of a shape that TAn does not support: %1. Divide them into simpler ones.", nameOf(type)));
        const auto quadratic = quadraticShape(*shape, nodes.size());
        notes_.wronglyLinear += quadratic ? 1 : 0;
        notes_.joinsPoints = notes_.joinsPoints || type > PolyVertex;
        return close(quadratic.value_or(*shape), nodes);
    }

    Status addLagrange(const LagrangeKind& kind, std::uint64_t cell, std::span<const std::uint64_t> nodes)
    {
        if (nodes.size() < kind.linear.nodes)
            return bad(Message::say("a cell has %1 points, and its shape needs %2.", nodes.size(), kind.linear.nodes));
        Degrees degrees{};
        if (!degrees_.empty())
            for (std::size_t axis = 0; axis < 3; ++axis)
                degrees[axis] = degreeOf(degrees_[3 * cell + axis]);
        const std::uint64_t order = orderOf(kind, nodes.size(), degrees);
        if (order == 2 && kind.quadratic) {
            if (kind.quadratic->shape == CellShape::QuadraticPrism)
                return addWithoutFaceNodes(*kind.quadratic, nodes.size(), nodes);
            std::vector<std::uint64_t> ordered(nodes.begin(), nodes.end());
            constexpr std::size_t exchanged = 18; // and the next one
            if (kind.quadratic->shape == CellShape::TriquadraticHexahedron && head_.exchangesLagrangeEdges)
                std::swap(ordered[exchanged], ordered[exchanged + 1]);
            return close(kind.quadratic->shape, ordered);
        }
        if (order != 1)
            ++notes_.byCorners[order];
        return close(kind.linear.shape, nodes.first(kind.linear.nodes));
    }

    static std::uint64_t degreeOf(double number)
    {
        constexpr double most = 1e6;
        return number >= 1 && number <= most ? static_cast<std::uint64_t>(number) : 0;
    }

    Status addWithoutFaceNodes(const TakenShape& taken, std::uint64_t wanted, std::span<const std::uint64_t> nodes)
    {
        if (nodes.size() != wanted)
            return bad(Message::say("a cell has %1 points, and its shape needs %2.", nodes.size(), wanted));
        notes_.withoutFaceNodes += nodes.size() > taken.nodes ? 1 : 0;
        return close(taken.shape, nodes.first(taken.nodes));
    }

    Status addPrism(std::span<const std::uint64_t> nodes, std::uint64_t sides)
    {
        if (nodes.size() != 2 * sides)
            return bad(Message::say("a cell has %1 points, and its shape needs %2.", nodes.size(), 2 * sides));
        for (const std::uint64_t base : {std::uint64_t(0), sides}) {
            complex_.corners.push_back(sides);
            for (std::uint64_t i = 0; i < sides; ++i)
                complex_.corners.push_back(firstPoint_ + nodes[base + i]);
        }
        for (std::uint64_t i = 0; i < sides; ++i) {
            const std::uint64_t next = (i + 1) % sides;
            complex_.corners.push_back(4);
            for (const std::uint64_t corner : {i, next, sides + next, sides + i})
                complex_.corners.push_back(firstPoint_ + nodes[corner]);
        }
        end(CellShape::Polyhedron);
        return {};
    }

    Status addPolyhedron(std::uint64_t cell)
    {
        if (!(faceEnds_[cell] >= 1 && faceEnds_[cell] <= static_cast<double>(faces_.size())))
            return bad(Message::say("the polyhedron %1 has no faces.", cell));
        const auto stop = static_cast<std::uint64_t>(faceEnds_[cell]);
        const auto wrong = [&] { return bad(Message::say("the faces of the polyhedron %1 are damaged.", cell)); };
        if (faceBegin_ >= stop)
            return wrong();
        auto rest = std::span(faces_).subspan(faceBegin_, stop - faceBegin_);
        faceBegin_ = stop;
        const std::uint64_t faceCount = rest[0];
        rest = rest.subspan(1);
        for (std::uint64_t face = 0; face < faceCount; ++face) {
            if (rest.empty() || rest[0] > rest.size() - 1)
                return wrong();
            complex_.corners.push_back(rest[0]);
            for (const std::uint64_t point : rest.subspan(1, rest[0])) {
                if (const Status exists = checkPoint(point); !exists)
                    return exists;
                complex_.corners.push_back(firstPoint_ + point);
            }
            rest = rest.subspan(1 + rest[0]);
        }
        if (!rest.empty())
            return wrong();
        end(CellShape::Polyhedron);
        return {};
    }

    Status close(CellShape shape, std::span<const std::uint64_t> nodes)
    {
        for (const std::uint64_t node : nodes)
            complex_.corners.push_back(firstPoint_ + node);
        end(shape);
        return {};
    }

    void end(CellShape shape)
    {
        complex_.shapes.push_back(shape);
        complex_.offsets.push_back(complex_.corners.size());
    }

    const VtuHead& head_;
    const VtuPiece& piece_;
    std::uint64_t firstPoint_;
    CellComplex& complex_;
    VtuCellNotes& notes_;
    VtuNodes file_;
    std::vector<std::uint64_t> types_, faces_;
    std::vector<double> faceEnds_, degrees_;
    std::uint64_t faceBegin_ = 0;
};

} // namespace

Result<VtuNodes> addVtuCells(const VtuHead& head, const VtuPiece& piece, std::uint64_t firstPoint, CellComplex& complex,
                             VtuCellNotes& notes)
{
    return PieceCells(head, piece, firstPoint, complex, notes).run();
}

std::vector<Message> remarksOn(const VtuCellNotes& notes)
{
    std::vector<Message> remarks;
    if (notes.wronglyLinear == 1)
        remarks.push_back(
            Message::say("1 cell is declared linear and has the corners of a quadratic one: it was read as such."));
    else if (notes.wronglyLinear > 1)
        remarks.push_back(
            Message::say("%1 cells are declared linear and have the corners of quadratic ones: they were read as such.",
                         notes.wronglyLinear));
    if (notes.withoutFaceNodes > 0)
        remarks.push_back(
            Message::say("Nodes in the faces of quadratic cells were not used: in %1 cells.", notes.withoutFaceNodes));
    for (const auto& [order, count] : notes.byCorners)
        remarks.push_back(
            order > 0 ? Message::say(
                            "For the Lagrange cells of order %1 (%2) only the corners were used, with straight edges.",
                            order, count)
                      : Message::say("For the Lagrange cells whose order differs by direction (%1) only the corners "
                                     "were used, with straight edges.",
                                     count));
    return remarks;
}

} // namespace tetra
