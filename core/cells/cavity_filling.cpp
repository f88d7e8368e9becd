// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/cavity_filling.h"

#include "core/cells/cell_orientation.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>

namespace tetra {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Tetrahedron = std::array<std::uint32_t, 4>;

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
        std::ranges::sort(corners_);
        const auto repeated = std::ranges::unique(corners_);
        corners_.erase(repeated.begin(), repeated.end());
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
