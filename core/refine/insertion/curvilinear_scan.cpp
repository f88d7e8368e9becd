// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/insertion/curvilinear_scan.h"

#include "core/refine/curvilinear/curvilinear_grid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

/// What is so little below a limit may be beyond it, but for rounding.
constexpr double nearlyOnePhysical = 1 - 1e-12;

using LatticePlace = std::array<std::int32_t, 3>;
using Lifted = Eigen::Array4d; ///< x, y, z and the value

/// One tetrahedron in computational space, and what it has at its vertices in physical space.
class PhysicalTetrahedron {
public:
    PhysicalTetrahedron(const PackedLattice& lattice, const CurvilinearGrid& grid,
                        const DelaunayTetrahedron& tetrahedron)
        : determinant_(tetrahedron.determinant())
    {
        for (std::size_t i = 0; i < 4; ++i) {
            const PackedPoint vertex = tetrahedron.vertices[i];
            corners_[i] = {lattice.x(vertex), lattice.y(vertex), lattice.z(vertex)};
            physical_[i] = Lifted(grid.at(vertex).components.data());
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [least, most] =
                std::ranges::minmax({corners_[0][axis], corners_[1][axis], corners_[2][axis], corners_[3][axis]});
            first[axis] = least;
            last[axis] = most;
        }
        const Eigen::Vector3d b = edge(1), c = edge(2), d = edge(3);
        normals_ = {c.cross(d), d.cross(b), b.cross(c)};
    }

    /// Where the bounding box begins and ends.
    LatticePlace first{}, last{};

    bool isCorner(const LatticePlace& place) const { return std::ranges::find(corners_, place) != corners_.end(); }

    /// What the point has less what the tetrahedron makes of its vertices there; false if it lies outside. Volumes of
    /// integers, so exact.
    bool residual(const LatticePlace& place, const PhysicalPoint& point, Lifted& result) const
    {
        const Eigen::Vector3d offset(place[0] - corners_[0][0], place[1] - corners_[0][1], place[2] - corners_[0][2]);
        std::array<double, 4> volumes{};
        for (std::size_t i = 0; i < 3; ++i)
            volumes[i + 1] = normals_[i].dot(offset);
        volumes[0] = determinant_ - volumes[1] - volumes[2] - volumes[3];
        if (std::ranges::min(volumes) < 0)
            return false;
        result = Lifted(point.components.data()) - physical_[0];
        for (std::size_t i = 1; i < 4; ++i)
            result -= volumes[i] / determinant_ * (physical_[i] - physical_[0]);
        return true;
    }

private:
    Eigen::Vector3d edge(std::size_t corner) const
    {
        return {double(corners_[corner][0] - corners_[0][0]), double(corners_[corner][1] - corners_[0][1]),
                double(corners_[corner][2] - corners_[0][2])};
    }

    double determinant_;
    std::array<LatticePlace, 4> corners_{};
    std::array<Lifted, 4> physical_;
    std::array<Eigen::Vector3d, 3> normals_; ///< towards the corners 1, 2, 3
};

class CurvilinearScan {
public:
    CurvilinearScan(const LocalDelaunay& mesh, const CurvilinearGrid& grid, const CurvilinearLimits& limits)
        : mesh_(mesh), lattice_(mesh.lattice()), grid_(grid), limits_(limits)
    {
    }

    /// The worst sample of a tetrahedron; of no excess if none is beyond its limit.
    WorstSample worstOf(std::uint32_t slot, ScannedPart part) const
    {
        const DelaunayTetrahedron& tetrahedron = mesh_.mesh()[slot];
        const PhysicalTetrahedron physical(lattice_, grid_, tetrahedron);
        LatticePlace first = physical.first, last = physical.last;
        if (part == ScannedPart::Limited)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                first[axis] = std::max(first[axis], limits_.first[axis]);
                last[axis] = std::min(last[axis], limits_.last[axis]);
            }
        WorstSample worst;
        worst.slot = slot;
        worst.tetrahedron = tetrahedron.vertices;
        LatticePlace place{};
        for (place[2] = first[2]; place[2] <= last[2]; ++place[2])
            for (place[1] = first[1]; place[1] <= last[1]; ++place[1])
                for (place[0] = first[0]; place[0] <= last[0]; ++place[0])
                    compare(physical, place, worst);
        return worst;
    }

private:
    void compare(const PhysicalTetrahedron& physical, const LatticePlace& place, WorstSample& worst) const
    {
        const PackedPoint point =
            lattice_.pack(static_cast<std::uint32_t>(place[0]), static_cast<std::uint32_t>(place[1]),
                          static_cast<std::uint32_t>(place[2]));
        const std::uint32_t index = lattice_.index(point);
        Lifted residual;
        if (physical.isCorner(place) || !physical.residual(place, grid_[index], residual))
            return;
        const double error = std::abs(residual[3]);
        const double warping = residual.head<3>().matrix().norm();
        const double excess = std::max(excessOf(error, limits_.errors[index], grid_.leastError()),
                                       excessOf(warping, limits_.warpings[index], grid_.leastWarping()));
        WorstSample sample = worst;
        sample.excess = excess;
        sample.error = error;
        sample.point = point;
        if (excess > 0 && (!(worst.excess > 0) || isWorse(sample, worst)))
            worst = sample;
    }

    /// How far beyond its limit, 0 if not at all. What rounding alone makes is nothing.
    static double excessOf(double amount, double limit, double least)
    {
        return amount > least && amount > limit * nearlyOnePhysical ? amount / limit : 0;
    }

    const LocalDelaunay& mesh_;
    const PackedLattice& lattice_;
    const CurvilinearGrid& grid_;
    const CurvilinearLimits& limits_;
};

/// The cure of a flipped tetrahedron that may not stay so.
std::optional<WorstSample> cureOf(const LocalDelaunay& mesh, std::uint32_t slot, const CurvilinearGrid& grid,
                                  const BlockDivision& blocks)
{
    const DelaunayTetrahedron& tetrahedron = mesh.mesh()[slot];
    if (grid.orientation(tetrahedron.vertices) >= 0 || grid.allowsInverted(tetrahedron.vertices))
        return std::nullopt;
    const PackedLattice& lattice = mesh.lattice();
    std::array<std::uint32_t, 3> middle{}; // inside of the one block that the tetrahedron lies in
    for (const PackedPoint vertex : tetrahedron.vertices) {
        middle[0] += static_cast<std::uint32_t>(lattice.x(vertex));
        middle[1] += static_cast<std::uint32_t>(lattice.y(vertex));
        middle[2] += static_cast<std::uint32_t>(lattice.z(vertex));
    }
    for (std::uint32_t& coordinate : middle)
        coordinate /= 4;
    std::vector<std::uint32_t> containing;
    blocks.blocksOf(middle, containing);
    for (const std::uint32_t block : containing) {
        const LatticeBox box = blocks.box(block);
        const auto holds = [&](PackedPoint vertex) {
            const std::array<std::int32_t, 3> place = {lattice.x(vertex), lattice.y(vertex), lattice.z(vertex)};
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (place[axis] < static_cast<std::int32_t>(box.origin[axis]) ||
                    place[axis] > static_cast<std::int32_t>(box.last(axis)))
                    return false;
            return true;
        };
        if (!std::ranges::all_of(tetrahedron.vertices, holds))
            continue;
        const auto point = deepestPointInSphere(lattice, tetrahedron, box);
        if (!point || mesh.isVertex(*point))
            return std::nullopt;
        return WorstSample{std::numeric_limits<double>::infinity(), 0, *point, slot, tetrahedron.vertices};
    }
    return std::nullopt;
}

} // namespace

void scanCurvilinearSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots,
                            const CurvilinearGrid& grid, const BlockDivision& blocks, const CurvilinearLimits& limits,
                            ScannedPart part, std::vector<WorstSample>& worst)
{
    const CurvilinearScan scan(mesh, grid, limits);
    for (const std::uint32_t slot : slots) {
        if (!(mesh.mesh()[slot].determinant() > 0))
            continue;
        const auto cure = part == ScannedPart::All ? cureOf(mesh, slot, grid, blocks) : std::nullopt;
        const WorstSample found = cure ? *cure : scan.worstOf(slot, part);
        if (found.excess > 0)
            worst.push_back(found);
    }
}

} // namespace tetra
