// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/refine/bent_grids.h"

#include <tan/data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tetra {

using GridPlace = std::array<std::int64_t, 3>;
using GridTetrahedron = std::array<GridPlace, 4>;

inline std::int64_t determinantOf(const GridPlace& a, const GridPlace& b, const GridPlace& c, const GridPlace& d)
{
    GridPlace u{}, v{}, w{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        u[axis] = b[axis] - a[axis];
        v[axis] = c[axis] - a[axis];
        w[axis] = d[axis] - a[axis];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Whether a tetrahedron and a cell have an inner point in common: no plane through three of their corners divides
/// them.
inline bool meetSlowly(const GridTetrahedron& tetrahedron, const GridPlace& cell)
{
    std::vector<GridPlace> corners(tetrahedron.begin(), tetrahedron.end());
    for (std::int64_t number = 0; number < 8; ++number)
        corners.push_back({cell[0] + (number & 1), cell[1] + (number >> 1 & 1), cell[2] + (number >> 2)});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto beyond = [&](std::int64_t plane, bool above) {
            return std::ranges::all_of(tetrahedron, [&](const GridPlace& corner) {
                return above ? corner[axis] >= plane : corner[axis] <= plane;
            });
        };
        if (beyond(cell[axis] + 1, true) || beyond(cell[axis], false))
            return false;
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                std::array<std::int64_t, 4> sides{}; // of the tetrahedron the least and the largest, then of the cell
                for (std::size_t corner = 0; corner < corners.size(); ++corner) {
                    const std::int64_t side = determinantOf(corners[i], corners[j], corners[k], corners[corner]);
                    const std::size_t body = corner < 4 ? 0 : 2;
                    if (corner == 0 || corner == 4)
                        sides[body] = sides[body + 1] = side;
                    sides[body] = std::min(sides[body], side);
                    sides[body + 1] = std::max(sides[body + 1], side);
                }
                if ((sides[1] <= 0 && sides[2] >= 0 && sides[0] < 0) ||
                    (sides[0] >= 0 && sides[3] <= 0 && sides[1] > 0))
                    return false;
            }
    return true;
}

/// A grid with what a slow search says of it.
class SlowGrid {
public:
    explicit SlowGrid(const BentGrid& grid) : grid_(grid)
    {
        std::int64_t balance = 0;
        forEachCorner([&](const GridPlace&, std::int64_t volume) { balance += (volume > 0) - (volume < 0); });
        hand_ = balance < 0 ? -1 : 1;
        forEachCorner([&](const GridPlace& cell, std::int64_t volume) {
            if (hand_ * volume < 0 && (folded_.empty() || folded_.back() != cell))
                folded_.push_back(cell);
        });
    }

    std::size_t foldedCells() const { return folded_.size(); }

    /// Of points, positive in computational space.
    bool isInverted(const std::array<std::uint32_t, 4>& points) const
    {
        return hand_ *
                   determinantOf(physical(points[0]), physical(points[1]), physical(points[2]), physical(points[3])) <
               0;
    }
    bool mayBeInverted(const std::array<std::uint32_t, 4>& points) const
    {
        GridTetrahedron tetrahedron{};
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto place = grid_.place(points[corner]);
            tetrahedron[corner] = {place[0], place[1], place[2]};
        }
        bool ofOneCell = true;
        for (const GridPlace& a : tetrahedron)
            for (const GridPlace& b : tetrahedron)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    ofOneCell = ofOneCell && std::abs(a[axis] - b[axis]) <= 1;
        return ofOneCell ||
               std::ranges::any_of(folded_, [&](const GridPlace& cell) { return meetSlowly(tetrahedron, cell); });
    }

private:
    GridPlace physical(std::uint64_t point) const
    {
        const Eigen::Vector3d scaled = 64 * grid_.positions[point];
        return {std::lround(scaled.x()), std::lround(scaled.y()), std::lround(scaled.z())};
    }
    template <class Visit> void forEachCorner(const Visit& visit) const
    {
        const auto& size = grid_.size;
        const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
            return physical(static_cast<std::uint64_t>((z * size[1] + y) * size[0] + x));
        };
        for (std::int64_t z = 0; z + 1 < size[2]; ++z)
            for (std::int64_t y = 0; y + 1 < size[1]; ++y)
                for (std::int64_t x = 0; x + 1 < size[0]; ++x)
                    for (std::int64_t dz = 0; dz < 2; ++dz)
                        for (std::int64_t dy = 0; dy < 2; ++dy)
                            for (std::int64_t dx = 0; dx < 2; ++dx)
                                visit(GridPlace{x, y, z},
                                      (1 - 2 * dx) * (1 - 2 * dy) * (1 - 2 * dz) *
                                          determinantOf(at(x + dx, y + dy, z + dz), at(x + 1 - dx, y + dy, z + dz),
                                                        at(x + dx, y + 1 - dy, z + dz),
                                                        at(x + dx, y + dy, z + 1 - dz)));
    }

    const BentGrid& grid_;
    int hand_ = 1;
    std::vector<GridPlace> folded_;
};

/// A bend of an arc, smooth but for the points that are pulled elsewhere: (x, y, z), and by how many cells along x.
inline BentGrid pulled(const std::vector<std::array<double, 4>>& points, bool mirrored = false)
{
    return bentGrid({9, 8, 7}, [&](double x, double y, double z) {
        double along = x;
        for (const auto& point : points)
            if (x == point[0] && (y == point[1] || point[1] < 0) && (z == point[2] || point[2] < 0))
                along += point[3];
        const double angle = 0.25 * y, radius = 4 + along;
        return Eigen::Vector3d((mirrored ? -1 : 1) * radius * std::cos(angle), radius * std::sin(angle),
                               z + 0.05 * along * y);
    });
}

inline BentGrid foldedGridNamed(const std::string& name)
{
    if (name == "inside")
        return pulled({{4, 4, 3, 1.5}});
    if (name == "one cell")
        return pulled({{0, 0, 0, 2.5}});
    if (name == "on the boundary")
        return pulled({{0, 4, 3, 1.6}});
    if (name == "at a face of blocks")
        return pulled({{3, 3, 3, -1.7}});
    if (name == "two neighbours")
        return pulled({{4, 4, 3, 1.4}, {5, 4, 3, -1.2}});
    if (name == "two places")
        return pulled({{2, 2, 2, 1.4}, {6, 6, 5, -1.6}});
    if (name == "a plane")
        return pulled({{4, -1, -1, 1.5}});
    if (name == "left-handed")
        return pulled({{4, 4, 3, 1.5}}, true);
    if (name == "turned back")
        return bentGrid({9, 6, 6}, [](double x, double y, double z) {
            return Eigen::Vector3d(std::abs(x - 4) + 0.1 * y, y + 0.05 * x * z, z + 0.1 * x);
        });
    if (name == "long") // 60,000 cells along an axis, and some of them folded
        return bentGrid({3, 2, 60001}, [](double x, double y, double z) {
            const bool isPulled = x == 1 && y == 1 && static_cast<int>(z) % 7001 == 13;
            return Eigen::Vector3d(x + (isPulled ? 1.5 : 0), y, z);
        });
    if (name == "bent cells") // none is folded, yet some tetrahedra of their corners are inverted
        return shakenGrid({8, 8, 8}, 0.24, 12);
    if (name == "wrapped") // an O-grid, of which coarse tetrahedra turn over, and a point of it pulled
        return bentGrid({6, 13, 5}, [](double x, double y, double z) {
            const double angle = 2 * 3.14159265358979 / 12 * std::fmod(y, 12);
            const double radius = 1 + x + (x == 4 && y == 5 && z == 2 ? 1.4 : 0);
            return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
        });
    const auto seed = static_cast<unsigned>(name.back() - '0');
    return shakenGrid({7, 8, 6}, 0.3 + 0.1 * seed, seed);
}

inline Dataset datasetOfGrid(const BentGrid& grid)
{
    Dataset dataset;
    dataset.domain = DomainClass::Curvilinear;
    dataset.lattice.size = grid.size;
    dataset.positions = std::make_shared<std::vector<Eigen::Vector3d>>(grid.positions);
    const auto values = std::make_shared<std::vector<double>>(grid.values);
    dataset.values =
        ScalarField(SampleType::Float64, values->size(), {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

} // namespace tetra
