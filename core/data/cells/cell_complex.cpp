// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/cell_complex.h"

#include "core/mesh/topology.h"

#include <tan/data.h>

namespace tetra {

namespace {

using Face = CellTopology::Face;
using Edge = std::array<std::uint8_t, 2>;

constexpr std::array<Face, 4> tetrahedronFaces = [] {
    std::array<Face, 4> faces{};
    for (std::size_t face = 0; face < 4; ++face) {
        const auto& [a, b, c] = cornersOfFace[face];
        faces[face] = {{a, b, c}, 3};
    }
    return faces;
}();
constexpr std::array<Edge, 6> tetrahedronEdges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

constexpr std::array<Face, 5> pyramidFaces = {
    {{{0, 3, 2, 1}, 4}, {{0, 1, 4}, 3}, {{1, 2, 4}, 3}, {{2, 3, 4}, 3}, {{3, 0, 4}, 3}}};
constexpr std::array<Edge, 8> pyramidEdges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

constexpr std::array<Face, 5> prismFaces = {
    {{{0, 2, 1}, 3}, {{3, 4, 5}, 3}, {{0, 1, 4, 3}, 4}, {{1, 2, 5, 4}, 4}, {{2, 0, 3, 5}, 4}}};
constexpr std::array<Edge, 9> prismEdges = {{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

constexpr std::array<Face, 6> hexahedronFaces = {
    {{{0, 3, 2, 1}, 4}, {{4, 5, 6, 7}, 4}, {{0, 1, 5, 4}, 4}, {{1, 2, 6, 5}, 4}, {{2, 3, 7, 6}, 4}, {{3, 0, 4, 7}, 4}}};
constexpr std::array<Edge, 12> hexahedronEdges = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

constexpr CellTopology tetrahedron{4, tetrahedronFaces, tetrahedronEdges};
constexpr CellTopology pyramid{5, pyramidFaces, pyramidEdges};
constexpr CellTopology prism{6, prismFaces, prismEdges};
constexpr CellTopology hexahedron{8, hexahedronFaces, hexahedronEdges};
constexpr CellTopology noTopology{0, {}, {}};

} // namespace

const CellTopology& cellTopology(CellShape shape)
{
    switch (shape) {
    case CellShape::Tetrahedron:
    case CellShape::QuadraticTetrahedron: return tetrahedron;
    case CellShape::Pyramid:
    case CellShape::QuadraticPyramid: return pyramid;
    case CellShape::Prism:
    case CellShape::QuadraticPrism: return prism;
    case CellShape::Hexahedron:
    case CellShape::Voxel:
    case CellShape::QuadraticHexahedron:
    case CellShape::TriquadraticHexahedron: return hexahedron;
    case CellShape::Polyhedron:
    case CellShape::Flat: break;
    }
    return noTopology;
}

std::uint32_t nodeCount(CellShape shape)
{
    const CellTopology& topology = cellTopology(shape);
    constexpr std::uint32_t nodesOfTriquadratic = 27;
    if (shape == CellShape::TriquadraticHexahedron)
        return nodesOfTriquadratic;
    return topology.cornerCount + (isQuadratic(shape) ? static_cast<std::uint32_t>(topology.edges.size()) : 0);
}

bool isQuadratic(CellShape shape)
{
    return shape >= CellShape::QuadraticTetrahedron && shape <= CellShape::TriquadraticHexahedron;
}

std::vector<std::array<Eigen::Vector3d, 2>> edgesOf(const FaultyCell& cell)
{
    std::vector<std::array<Eigen::Vector3d, 2>> edges;
    for (const CellTopology* shape : {&tetrahedron, &pyramid, &prism, &hexahedron})
        if (shape->cornerCount == cell.corners.size())
            for (const auto& [from, to] : shape->edges)
                edges.push_back({cell.corners[from], cell.corners[to]});
    return edges;
}

std::string_view cellShapeName(CellShape shape)
{
    switch (shape) {
    case CellShape::Tetrahedron: return "tetrahedron";
    case CellShape::Pyramid: return "pyramid";
    case CellShape::Prism: return "prism";
    case CellShape::Hexahedron: return "hexahedron";
    case CellShape::Voxel: return "voxel";
    case CellShape::QuadraticTetrahedron: return "quadratic tetrahedron";
    case CellShape::QuadraticPyramid: return "quadratic pyramid";
    case CellShape::QuadraticPrism: return "quadratic prism";
    case CellShape::QuadraticHexahedron: return "quadratic hexahedron";
    case CellShape::TriquadraticHexahedron: return "triquadratic hexahedron";
    case CellShape::Polyhedron: return "polyhedron";
    case CellShape::Flat: break;
    }
    return "flat cell";
}

} // namespace tetra
