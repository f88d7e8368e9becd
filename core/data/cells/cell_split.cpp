// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/cell_split.h"

#include "core/base/sort_unique.h"
#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>

namespace tetra {

namespace {

constexpr std::size_t mostFaces = 14; // of a hexahedron with its corners cut off

/// The faces of a polytope, without the vector's memory.
struct Polytope {
    std::array<CellPolygon, mostFaces> faces{};
    std::size_t count = 0;

    void add(const CellPolygon& face) { faces[count++] = face; }
    std::span<const CellPolygon> all() const { return std::span(faces).first(count); }
};

std::uint32_t smallestPlace(const CellPolygon& polygon)
{
    std::uint32_t place = 0;
    for (std::uint32_t i = 1; i < polygon.count; ++i)
        if (polygon.nodes[i] < polygon.nodes[place])
            place = i;
    return place;
}

bool repeats(const std::array<std::uint32_t, 3>& triangle)
{
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[0] == triangle[2];
}

template <class Visit> void forTriangles(const CellPolygon& polygon, std::uint32_t first, Visit&& visit)
{
    for (std::uint32_t i = 1; i + 1 < polygon.count; ++i) {
        const std::array<std::uint32_t, 3> triangle = {polygon.nodes[first], polygon.nodes[(first + i) % polygon.count],
                                                       polygon.nodes[(first + i + 1) % polygon.count]};
        if (!repeats(triangle))
            visit(triangle);
    }
}

bool polygonHas(const CellPolygon& polygon, std::uint32_t node)
{
    return std::ranges::count(std::span(polygon.nodes).first(polygon.count), node) != 0;
}

/// The tetrahedra between a node and the faces that it is not on.
void pull(std::span<const CellPolygon> faces, std::uint32_t apex, CellPieces& pieces)
{
    for (const CellPolygon& face : faces)
        if (!polygonHas(face, apex))
            forTriangles(face, smallestPlace(face), [&](const auto& triangle) {
                pieces.push_back({triangle[0], triangle[2], triangle[1], apex});
            });
}

void pullFromSmallest(const Polytope& polytope, CellPieces& pieces)
{
    std::uint32_t apex = polytope.faces[0].nodes[0];
    for (const CellPolygon& face : polytope.all())
        apex = std::min(apex, face.nodes[smallestPlace(face)]);
    pull(polytope.all(), apex, pieces);
}

CellPolygon facePolygon(const CellTopology::Face& face, std::span<const std::uint32_t> nodes)
{
    CellPolygon polygon{.nodes = {}, .count = face.count};
    for (std::uint32_t i = 0; i < face.count; ++i)
        polygon.nodes[i] = nodes[face.corners[i]];
    return polygon;
}

std::uint32_t middleOf(const CellTopology& topology, std::span<const std::uint32_t> nodes, std::uint8_t a,
                       std::uint8_t b)
{
    for (std::size_t edge = 0; edge < topology.edges.size(); ++edge)
        if (topology.edges[edge] == std::array{a, b} || topology.edges[edge] == std::array{b, a})
            return nodes[topology.cornerCount + edge];
    return nodes[a];
}

/// Middle i lies between the corners i and i + 1 of the face.
CellPolygon middlePolygon(const CellTopology& topology, const CellTopology::Face& face,
                          std::span<const std::uint32_t> nodes)
{
    CellPolygon polygon{.nodes = {}, .count = face.count};
    for (std::uint32_t i = 0; i < face.count; ++i)
        polygon.nodes[i] = middleOf(topology, nodes, face.corners[i], face.corners[(i + 1) % face.count]);
    return polygon;
}

/// The middles of the edges at a corner, in their order around it, seen from the corner counterclockwise.
CellPolygon cornerPolygon(const CellTopology& topology, std::uint8_t corner, std::span<const std::uint32_t> nodes)
{
    // Each face at the corner leads from the edge it comes by to the edge it leaves by.
    std::array<std::array<std::uint8_t, 2>, 4> links{};
    std::uint32_t count = 0;
    for (const CellTopology::Face& face : topology.faces)
        for (std::uint32_t i = 0; i < face.count; ++i)
            if (face.corners[i] == corner)
                links[count++] = {face.corners[(i + face.count - 1) % face.count], face.corners[(i + 1) % face.count]};
    CellPolygon polygon{.nodes = {}, .count = count};
    std::uint8_t at = links[0][0];
    for (std::uint32_t i = 0; i < count; ++i) {
        polygon.nodes[i] = middleOf(topology, nodes, corner, at);
        const auto next =
            std::ranges::find(std::span(links).first(count), at, [](const auto& link) { return link[1]; });
        at = (*next)[0];
    }
    return polygon;
}

CellPolygon reversed(CellPolygon polygon)
{
    std::ranges::reverse(std::span(polygon.nodes).first(polygon.count));
    return polygon;
}

void splitQuadratic(const CellTopology& topology, std::span<const std::uint32_t> nodes, CellPieces& pieces)
{
    Polytope middle;
    for (const CellTopology::Face& face : topology.faces)
        middle.add(middlePolygon(topology, face, nodes));
    for (std::uint8_t corner = 0; corner < topology.cornerCount; ++corner) {
        // Where four edges meet, the cut is a quadrilateral with a diagonal like those of the faces.
        const CellPolygon cut = cornerPolygon(topology, corner, nodes);
        middle.add(cut);
        const CellPolygon back = reversed(cut);
        pull(std::span(&back, 1), nodes[corner], pieces);
    }
    pullFromSmallest(middle, pieces);
}

void addTriangle(const std::array<std::uint32_t, 3>& triangle, CellSurface& surface)
{
    const auto isBack = [&](const std::array<std::uint32_t, 3>& other) {
        for (std::size_t turn = 0; turn < 3; ++turn)
            if (other[turn] == triangle[0] && other[(turn + 2) % 3] == triangle[1] &&
                other[(turn + 1) % 3] == triangle[2])
                return true;
        return false;
    };
    if (const auto back = std::ranges::find_if(surface, isBack); back != surface.end())
        surface.erase(back);
    else
        surface.push_back(triangle);
}

} // namespace

void splitCell(CellShape shape, std::span<const std::uint32_t> nodes, CellPieces& pieces)
{
    const std::size_t first = pieces.size();
    const CellTopology& topology = cellTopology(shape);
    if (shape == CellShape::Tetrahedron) {
        pieces.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
    } else if (isQuadratic(shape)) {
        splitQuadratic(topology, nodes, pieces);
    } else {
        Polytope cell;
        for (const CellTopology::Face& face : topology.faces)
            cell.add(facePolygon(face, nodes));
        pullFromSmallest(cell, pieces);
    }
    const auto repeated = [](std::array<std::uint32_t, 4> piece) {
        std::ranges::sort(piece);
        return std::ranges::adjacent_find(piece) != piece.end();
    };
    const auto end = std::remove_if(pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end(), repeated);
    pieces.erase(end, pieces.end());
}

void cellSurface(CellShape shape, std::span<const std::uint32_t> nodes, const OtherDiagonal& other,
                 CellSurface& surface)
{
    const CellTopology& topology = cellTopology(shape);
    const auto addPolygon = [&](const CellPolygon& polygon) {
        const bool turned = polygon.count == 4 && other && other(polygon);
        forTriangles(polygon, smallestPlace(polygon) + (turned ? 1 : 0),
                     [&](const auto& triangle) { addTriangle(triangle, surface); });
    };
    for (const CellTopology::Face& face : topology.faces) {
        const CellPolygon corners = facePolygon(face, nodes);
        if (!isQuadratic(shape)) {
            addPolygon(corners);
            continue;
        }
        const CellPolygon middles = middlePolygon(topology, face, nodes);
        addPolygon(middles);
        for (std::uint32_t i = 0; i < face.count; ++i)
            addPolygon({{corners.nodes[i], middles.nodes[i], middles.nodes[(i + face.count - 1) % face.count]}, 3});
    }
}

std::vector<CellPolygon> quadrilateralsOf(CellShape shape, std::span<const std::uint32_t> nodes)
{
    std::vector<CellPolygon> quadrilaterals;
    if (!isQuadratic(shape))
        for (const CellTopology::Face& face : cellTopology(shape).faces)
            if (face.count == 4)
                quadrilaterals.push_back(facePolygon(face, nodes));
    return quadrilaterals;
}

namespace {

/// Of one cavity.
constexpr std::uint64_t mostFillingSteps = 5000;

/// The same triangle, its smallest corner first.
Triangle turnedAround(Triangle triangle)
{
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    return triangle;
}

class CavitySearch {
public:
    CavitySearch(std::span<const Eigen::Vector3d> positions, const CellSurface& surface, std::uint64_t steps)
        : positions_(positions), stepsLeft_(steps)
    {
        for (const Triangle& triangle : surface) {
            front_.push_back(turnedAround(triangle));
            corners_.insert(corners_.end(), triangle.begin(), triangle.end());
        }
        sortUnique(corners_);
    }

    bool fill()
    {
        if (front_.empty())
            return true;
        // The oldest triangle first: the search stays narrow, and the same input gives the same pieces.
        const Triangle base = front_.front();
        for (const std::uint32_t apex : corners_) {
            if (stepsLeft_ == 0)
                return false;
            --stepsLeft_;
            const Tetrahedron piece = {base[0], base[2], base[1], apex};
            if (std::ranges::count(base, apex) != 0 || orientation(positions_, piece) <= 0)
                continue;
            const std::vector<Triangle> before = front_;
            if (advance(piece)) {
                pieces_.push_back(piece);
                if (fill())
                    return true;
                pieces_.pop_back();
            }
            front_ = before;
        }
        return false;
    }
    const CellPieces& pieces() const { return pieces_; }
    std::uint64_t stepsLeft() const { return stepsLeft_; }

private:
    /// Takes the piece away from what is to be filled; false if its faces do not fit.
    bool advance(const Tetrahedron& piece)
    {
        for (const auto& corners : cornersOfFace) {
            const Triangle face = {piece[corners[0]], piece[corners[1]], piece[corners[2]]};
            if (const auto found = std::ranges::find(front_, turnedAround(face)); found != front_.end()) {
                front_.erase(found);
                continue;
            }
            const Triangle back = turnedAround({face[0], face[2], face[1]});
            if (std::ranges::find(front_, back) != front_.end())
                return false;
            front_.push_back(back);
        }
        return true;
    }

    std::span<const Eigen::Vector3d> positions_;
    std::uint64_t stepsLeft_;
    std::vector<std::uint32_t> corners_;
    std::vector<Triangle> front_;
    CellPieces pieces_;
};

} // namespace

std::optional<CellPieces> fillCavity(std::span<const Eigen::Vector3d> positions, const CellSurface& surface,
                                     std::uint64_t& stepsLeft)
{
    const std::uint64_t steps = std::min(stepsLeft, mostFillingSteps);
    CavitySearch search(positions, surface, steps);
    const bool filled = !surface.empty() && search.fill();
    stepsLeft -= steps - search.stepsLeft();
    if (!filled)
        return std::nullopt;
    return search.pieces();
}

} // namespace tetra
