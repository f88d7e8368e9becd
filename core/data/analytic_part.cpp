// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_part.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tetra {

namespace {

constexpr std::uint32_t tilesAlongX = 3, tilesAlongY = 2;
constexpr double tileEdge = 2, holeRadius = 0.5, thickness = 1;
/// The tile with the cavity.
constexpr std::uint32_t closedX = 1, closedY = 1;

using PlanePlace = Eigen::Vector2d;

struct Quadrilateral {
    std::array<std::uint32_t, 4> corners;
    bool overCavity;
};

PlanePlace centreOf(std::uint32_t tileX, std::uint32_t tileY)
{
    return {tileEdge * (tileX + 0.5), tileEdge * (tileY + 0.5)};
}

/// The plan of the plate: rings of quadrilaterals between circles and squares; in the cavity's tile also within.
class Plan {
public:
    explicit Plan(std::uint32_t edgeCells) : edgeCells_(edgeCells), ringCells_(edgeCells / 2 + 1)
    {
        for (std::uint32_t y = 0; y < tilesAlongY; ++y)
            for (std::uint32_t x = 0; x < tilesAlongX; ++x)
                addTile(x, y);
    }
    const std::vector<PlanePlace>& places() const { return places_; }
    const std::vector<Quadrilateral>& cells() const { return cells_; }

private:
    using Index = std::pair<std::uint32_t, std::uint32_t>;

    /// Of the points around a square of edgeCells_^2 cells, counterclockwise.
    Index around(std::uint32_t step) const
    {
        const std::uint32_t side = step / edgeCells_ % 4, along = step % edgeCells_;
        switch (side) {
        case 0: return {along, 0};
        case 1: return {edgeCells_, along};
        case 2: return {edgeCells_ - along, edgeCells_};
        default: return {0, edgeCells_ - along};
        }
    }
    /// In [-1, 1]^2.
    PlanePlace onSquare(const Index& index) const
    {
        return {2.0 * index.first / edgeCells_ - 1, 2.0 * index.second / edgeCells_ - 1};
    }

    std::uint32_t add(const PlanePlace& place)
    {
        places_.push_back(place);
        return static_cast<std::uint32_t>(places_.size() - 1);
    }
    /// Neighbouring tiles have the points on their common edge together.
    std::uint32_t edgePoint(std::uint32_t tileX, std::uint32_t tileY, const Index& index)
    {
        const Index key{tileX * edgeCells_ + index.first, tileY * edgeCells_ + index.second};
        const auto [found, isNew] = edgePoints_.emplace(key, 0);
        if (isNew)
            found->second = add({tileEdge * key.first / edgeCells_, tileEdge * key.second / edgeCells_});
        return found->second;
    }

    void addTile(std::uint32_t tileX, std::uint32_t tileY)
    {
        const PlanePlace centre = centreOf(tileX, tileY);
        const std::uint32_t steps = 4 * edgeCells_;
        std::vector<std::vector<std::uint32_t>> rings(ringCells_ + 1);
        for (std::uint32_t ring = 0; ring <= ringCells_; ++ring)
            for (std::uint32_t step = 0; step < steps; ++step) {
                const PlanePlace corner = onSquare(around(step));
                const double part = static_cast<double>(ring) / ringCells_;
                const double outwards = part * (0.5 + 0.5 * part); // finer at the hole
                const PlanePlace inner = holeRadius * corner / corner.norm();
                const PlanePlace outer = tileEdge / 2 * corner;
                rings[ring].push_back(ring == ringCells_ ? edgePoint(tileX, tileY, around(step))
                                                         : add(centre + inner + outwards * (outer - inner)));
            }
        for (std::uint32_t ring = 0; ring < ringCells_; ++ring)
            for (std::uint32_t step = 0; step < steps; ++step) {
                const std::uint32_t next = (step + 1) % steps;
                cells_.push_back(
                    {{rings[ring][step], rings[ring + 1][step], rings[ring + 1][next], rings[ring][next]}, false});
            }
        if (tileX == closedX && tileY == closedY)
            addCore(centre, rings[0]);
    }

    void addCore(const PlanePlace& centre, const std::vector<std::uint32_t>& circle)
    {
        std::map<Index, std::uint32_t> points;
        for (std::uint32_t step = 0; step < circle.size(); ++step)
            points[around(step)] = circle[step];
        for (std::uint32_t j = 1; j < edgeCells_; ++j)
            for (std::uint32_t i = 1; i < edgeCells_; ++i) {
                // Squares that become round outwards.
                const PlanePlace place = onSquare({i, j});
                const double outwards = place.cwiseAbs().maxCoeff();
                const double length = place.norm();
                const PlanePlace onDisk = length > 0 ? PlanePlace(place * (outwards / length)) : place;
                constexpr double squareness = 0.7;
                points[{i, j}] = add(centre + holeRadius * (outwards * onDisk + (1 - outwards) * squareness * place));
            }
        for (std::uint32_t j = 0; j < edgeCells_; ++j)
            for (std::uint32_t i = 0; i < edgeCells_; ++i)
                cells_.push_back(
                    {{points[{i, j}], points[{i + 1, j}], points[{i + 1, j + 1}], points[{i, j + 1}]}, true});
    }

    std::uint32_t edgeCells_;
    std::uint32_t ringCells_;
    std::vector<PlanePlace> places_;
    std::vector<Quadrilateral> cells_;
    std::map<Index, std::uint32_t> edgePoints_;
};

/// xx, yy and xy of what a hole around the origin changes of a stress of 1 along x.
Eigen::Vector3d stressOfHole(const PlanePlace& place)
{
    const double square = std::max(place.squaredNorm(), holeRadius * holeRadius);
    const double length = std::max(place.squaredNorm(), 1e-30);
    const double ratio = holeRadius * holeRadius / square;
    const double cosine = (place[0] * place[0] - place[1] * place[1]) / length; // of the double angle
    const double sine = 2 * place[0] * place[1] / length;
    const double radial = (1 - ratio) / 2 + (1 - 4 * ratio + 3 * ratio * ratio) / 2 * cosine;
    const double around = (1 + ratio) / 2 - (1 + 3 * ratio * ratio) / 2 * cosine;
    const double shear = -(1 + 2 * ratio - 3 * ratio * ratio) / 2 * sine;
    const double mean = (radial + around) / 2, difference = (radial - around) / 2;
    return {mean + difference * cosine - shear * sine - 1, mean - difference * cosine + shear * sine,
            difference * sine + shear * cosine};
}

double stressAt(const Eigen::Vector3d& position)
{
    constexpr double largest = 3.2;
    Eigen::Vector3d stress(1, 0, 0);
    for (std::uint32_t y = 0; y < tilesAlongY; ++y)
        for (std::uint32_t x = 0; x < tilesAlongX; ++x) {
            // The cavity weakens the plate most in its middle.
            const double fromMiddle = (position[2] - thickness / 2) / (thickness / 3);
            const double share = x == closedX && y == closedY ? 1 / (1 + fromMiddle * fromMiddle) : 1;
            stress += share * stressOfHole(position.head<2>() - centreOf(x, y));
        }
    const double xx = stress[0], yy = stress[1], xy = stress[2];
    const double equivalent = std::sqrt(std::max(xx * xx - xx * yy + yy * yy + 3 * xy * xy, 0.0));
    return std::min(equivalent / largest, 1.0);
}

/// Three tetrahedra between two copies of a triangle; prisms that share a side cut it alike, for the order of the
/// vertices decides.
void addPrism(std::array<std::uint32_t, 3> triangle, std::uint32_t below, std::uint32_t above, AnalyticMesh& mesh)
{
    std::ranges::sort(triangle);
    const auto [a, b, c] = triangle;
    for (std::array<std::uint32_t, 4> piece : {std::array<std::uint32_t, 4>{a + below, b + below, c + below, c + above},
                                               {a + below, b + below, b + above, c + above},
                                               {a + below, a + above, b + above, c + above}}) {
        const Eigen::Vector3d origin = mesh.positions[piece[0]];
        const auto edge = [&](std::size_t i) { return (mesh.positions[piece[i]] - origin).eval(); };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(piece[2], piece[3]);
        mesh.tetrahedra.push_back(piece);
    }
}

void dropUnused(AnalyticMesh& mesh)
{
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> numbers(mesh.positions.size(), unused);
    for (const auto& tetrahedron : mesh.tetrahedra)
        for (const std::uint32_t point : tetrahedron)
            numbers[point] = 0;
    std::uint32_t kept = 0;
    for (std::size_t point = 0; point < numbers.size(); ++point)
        if (numbers[point] != unused) {
            mesh.positions[kept] = mesh.positions[point];
            numbers[point] = kept++;
        }
    mesh.positions.resize(kept);
    for (auto& tetrahedron : mesh.tetrahedra)
        for (std::uint32_t& point : tetrahedron)
            point = numbers[point];
}

} // namespace

AnalyticMesh analyticPart(std::uint32_t size)
{
    constexpr std::uint32_t sizeOfCell = 8, layersOfThird = 3;
    const std::uint32_t edgeCells = std::max<std::uint32_t>(2, size / sizeOfCell);
    const std::uint32_t third = std::max<std::uint32_t>(1, edgeCells / layersOfThird), layers = 3 * third;
    const Plan plan(edgeCells);
    const auto perLayer = static_cast<std::uint32_t>(plan.places().size());
    AnalyticMesh mesh;
    mesh.positions.reserve(std::size_t(perLayer) * (layers + 1));
    for (std::uint32_t layer = 0; layer <= layers; ++layer)
        for (const PlanePlace& place : plan.places()) {
            const Eigen::Vector3d position(place[0], place[1], thickness * layer / layers);
            mesh.positions.push_back(position.cast<float>().cast<double>()); // files and models stay small
        }
    for (std::uint32_t layer = 0; layer < layers; ++layer)
        for (const auto& [corners, overCavity] : plan.cells()) {
            if (overCavity && layer / third == 1)
                continue;
            const auto first = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
            const std::uint32_t below = layer * perLayer, above = below + perLayer;
            for (std::size_t i = 1; i < 3; ++i)
                addPrism({corners[first], corners[(first + i) % 4], corners[(first + i + 1) % 4]}, below, above, mesh);
        }
    dropUnused(mesh);
    for (const Eigen::Vector3d& position : mesh.positions)
        mesh.values.push_back(stressAt(position));
    return mesh;
}

} // namespace tetra
