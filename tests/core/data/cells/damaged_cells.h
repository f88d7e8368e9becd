// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/orientation.h"
#include "core/geometry/tetrahedron_overlap.h"
#include "tests/core/data/cells/random_cells.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace tetra {

/// Tetrahedra of a box, of which up to a thousandth are damaged in a random way: overlaps, flips, slivers, duplicates,
/// a third cell at a face, a corner of another place, values that are not finite; and parts that only touch.
class DamagedCells {
public:
    enum Kind { Duplicate, Sliver, Flip, Copy, ThirdAtFace, OtherCorner, NotFinite, Touching, KindCount };

    DamagedCells(std::uint32_t size, std::uint32_t seed)
        : base_({size, size, size}, 0.1, seed, RandomCells::Kinds::OnlyTetrahedra), random_(seed),
          complex_(std::move(base_.complex()))
    {
        complex_.blanked.assign(complex_.shapes.size(), 0);
        whole_ = static_cast<std::uint32_t>(complex_.shapes.size());
        for (const Eigen::Vector3d& place : complex_.positions)
            values_.values.push_back(std::sin(0.7 * place[0]) + std::cos(0.5 * place[1] - 0.3 * place[2]));
        // A flip damages as many as it says, each of the others one cell; that and one that it overlaps may go.
        std::uint32_t left = 1 + random(whole_ / 1000);
        while (left > 0) {
            const auto kind = static_cast<Kind>(random(KindCount));
            const std::uint32_t damaged = damage(kind, left);
            left -= std::min(left, damaged);
        }
    }

    const CellComplex& complex() const { return complex_; }
    const ComplexValues& values() const { return values_; }

private:
    using Corners = std::array<std::uint64_t, 4>;

    std::uint32_t random(std::uint32_t below) { return random_() % std::max(below, 1U); }

    Corners corners(std::uint32_t cell) const
    {
        Corners result;
        for (std::size_t i = 0; i < 4; ++i)
            result[i] = complex_.corners[4 * cell + i];
        return result;
    }
    const Eigen::Vector3d& at(std::uint64_t point) const { return complex_.positions[point]; }

    std::uint64_t addPoint(const Eigen::Vector3d& place)
    {
        complex_.positions.push_back(place);
        values_.values.push_back(place.sum());
        return complex_.positions.size() - 1;
    }
    void addCell(const Corners& cell)
    {
        complex_.shapes.push_back(CellShape::Tetrahedron);
        complex_.corners.insert(complex_.corners.end(), cell.begin(), cell.end());
        complex_.offsets.push_back(complex_.corners.size());
        complex_.blanked.push_back(0);
    }

    std::array<std::uint32_t, 4> positive(std::uint32_t cell) const
    {
        std::array<std::uint32_t, 4> result;
        std::ranges::copy(corners(cell), result.begin());
        if (orientation(complex_.positions, result) < 0)
            std::swap(result[0], result[1]);
        return result;
    }

    /// How many of the cells that have the point overlap any other.
    std::uint32_t overlappingAround(std::uint64_t point) const
    {
        std::uint32_t count = 0;
        for (std::uint32_t cell = 0; cell < whole_; ++cell) {
            const Corners c = corners(cell);
            if (std::ranges::find(c, point) == c.end())
                continue;
            for (std::uint32_t other = 0; other < whole_; ++other)
                if (other != cell && tetrahedraOverlap(complex_.positions, positive(cell), positive(other))) {
                    ++count;
                    break;
                }
        }
        return count;
    }

    /// Returns how many of the cells that there were, or are new, are damaged by it: none if it would be more than
    /// `most`.
    std::uint32_t damage(Kind kind, std::uint32_t most)
    {
        const std::uint32_t cell = random(whole_);
        const Corners c = corners(cell);
        const Eigen::Vector3d middle = (at(c[0]) + at(c[1]) + at(c[2]) + at(c[3])) / 4;
        if ((kind == Copy || kind == ThirdAtFace || kind == OtherCorner) && most < 2)
            return 0;
        switch (kind) {
        case Duplicate: addCell({c[1], c[0], c[2], c[3]}); return 1;
        case Sliver: addCell({c[0], c[1], c[2], addPoint((at(c[0]) + at(c[1])) / 2)}); return 1;
        case Flip: { // a corner goes a little through the face on its other side
            const Eigen::Vector3d before = at(c[3]);
            const Eigen::Vector3d normal = (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])).normalized();
            const double height = normal.dot(before - at(c[0]));
            complex_.positions[c[3]] -= (1.005 + 0.01 * random(3)) * height * normal;
            const std::uint32_t damaged = overlappingAround(c[3]);
            if (damaged <= most)
                return damaged;
            complex_.positions[c[3]] = before;
            return 0;
        }
        case Copy: { // inside its original, or through some around it
            const double scale = random(2) == 0 ? 0.5 : 1.3;
            Corners copy;
            for (std::size_t i = 0; i < 4; ++i)
                copy[i] = addPoint(middle + scale * (at(c[i]) - middle));
            addCell(copy);
            return 2;
        }
        case ThirdAtFace: addCell({c[0], c[1], c[2], addPoint(middle)}); return 2;
        case OtherCorner: complex_.corners[4 * cell + random(4)] = corners(random(whole_))[0]; return 2;
        case NotFinite: values_.values[c[random(4)]] = std::numeric_limits<double>::quiet_NaN(); return 0;
        case Touching: // of the cells around a point every other one is a hole
            for (std::uint32_t other = 0; other < whole_; ++other)
                for (const std::uint64_t point : corners(other))
                    if (point == c[0] && random(2) == 0)
                        complex_.blanked[other] = 1;
            return 0;
        case KindCount: break;
        }
        return 0;
    }

    RandomCells base_;
    std::mt19937 random_;
    CellComplex complex_;
    ComplexValues values_{.values = {}, .perCell = false, .type = SampleType::Float64};
    std::uint32_t whole_ = 0; ///< cells at the beginning
};

} // namespace tetra
