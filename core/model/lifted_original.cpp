// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/lifted_original.h"

#include "core/model/exact_volume.h"
#include "core/model/verify_each.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>

namespace tetra {

namespace {

/// How many corners of cells have volume, of either sign.
struct CornerSigns {
    std::uint64_t positive = 0;
    std::uint64_t negative = 0;

    void add(double volume)
    {
        positive += volume > 0;
        negative += volume < 0;
    }
    void add(const CornerSigns& other)
    {
        positive += other.positive;
        negative += other.negative;
    }
    bool leftHanded() const { return negative > positive; }
};

/// A corner of a cell with its neighbours along the edges; the bits of its number choose the later point along x, y
/// and z.
struct GridCorner {
    Eigen::Vector3d at;
    std::array<Eigen::Vector3d, 3> neighbours;
    int turn; ///< -1 if an odd number of the edges runs backwards

    GridCorner(const Dataset& original, const LatticePoint& cell, unsigned number)
        : turn(std::popcount(number) % 2 == 0 ? 1 : -1)
    {
        const auto place = [&](unsigned corner) {
            return original.position(original.lattice.index(static_cast<std::uint32_t>(cell[2]) + (corner & 1),
                                                            static_cast<std::uint32_t>(cell[1]) + (corner >> 1 & 1),
                                                            static_cast<std::uint32_t>(cell[0]) + (corner >> 2)));
        };
        at = place(number);
        for (unsigned axis = 0; axis < 3; ++axis)
            neighbours[axis] = place(number ^ (1u << axis));
    }
    int sign() const { return turn * volumeSign(at, neighbours[0], neighbours[1], neighbours[2]); }
    /// As who writes a model finds it: for the hand that will do, and may not be the exact one.
    double roughVolume() const
    {
        return turn * (neighbours[0] - at).dot((neighbours[1] - at).cross(neighbours[2] - at));
    }
};

/// Calls visit(cell) for the cells of a layer across z, in order.
template <class Visit> void forEachGridCell(const Lattice& lattice, std::size_t layer, const Visit& visit)
{
    for (std::int64_t y = 0; y + 1 < lattice.size[1]; ++y)
        for (std::int64_t x = 0; x + 1 < lattice.size[0]; ++x)
            visit(LatticePoint{static_cast<std::int64_t>(layer), y, x});
}

/// x, y, z and what they are to be divided by, which is positive. Grids have at most 2^30 points along an axis: what is
/// cut once takes 61 bits, twice 122.
using ProjectivePoint = std::array<__int128, 4>;
using PointCloud = std::vector<ProjectivePoint>;

/// On which side of a plane across an axis the point lies.
__int128 beyondPlane(const ProjectivePoint& point, std::size_t axis, std::int64_t plane)
{
    return point[axis] - plane * point[3];
}

/// Whether the convex hull of the points, which has volume, has points strictly between two planes.
bool reachesBetween(const PointCloud& points, std::size_t axis, std::int64_t least, std::int64_t most)
{
    return std::ranges::any_of(points, [&](const auto& point) { return beyondPlane(point, axis, least) > 0; }) &&
           std::ranges::any_of(points, [&](const auto& point) { return beyondPlane(point, axis, most) < 0; });
}

/// Points whose convex hull is what the hull of `points` has between two planes.
PointCloud cutBetween(const PointCloud& points, std::size_t axis, std::int64_t least, std::int64_t most)
{
    PointCloud part;
    for (const ProjectivePoint& point : points)
        if (beyondPlane(point, axis, least) >= 0 && beyondPlane(point, axis, most) <= 0)
            part.push_back(point);
    for (const std::int64_t plane : {least, most})
        for (const ProjectivePoint& before : points)
            for (const ProjectivePoint& behind : points) {
                const __int128 from = beyondPlane(before, axis, plane), to = beyondPlane(behind, axis, plane);
                if (from >= 0 || to <= 0)
                    continue;
                ProjectivePoint& between = part.emplace_back();
                for (std::size_t i = 0; i < 4; ++i)
                    between[i] = to * before[i] - from * behind[i];
            }
    return part;
}

} // namespace

Result<LiftedOriginal> LiftedOriginal::make(const Dataset& original, bool leftHanded,
                                            std::vector<std::string>& failures, const Progress& progress)
{
    const std::size_t layerCount = original.lattice.size[2] - 1;
    const std::string activity = "Verifying the cells of the grid";
    std::vector<std::array<CornerSigns, 2>> counts(layerCount);
    const Status counted = verifyEach(layerCount, 1, activity, progress.part(0, 0.5), [&](std::size_t layer) {
        forEachGridCell(original.lattice, layer, [&, &count = counts[layer]](const LatticePoint& cell) {
            for (unsigned number = 0; number < 8; ++number) {
                const GridCorner corner(original, cell, number);
                count[0].add(corner.sign());
                count[1].add(corner.roughVolume());
            }
        });
    });
    if (!counted)
        return counted.error();
    CornerSigns exact, rough;
    for (const auto& count : counts) {
        exact.add(count[0]);
        rough.add(count[1]);
    }
    LiftedOriginal result;
    const bool agrees = leftHanded == exact.leftHanded() || leftHanded == rough.leftHanded();
    if (!agrees)
        failures.push_back(std::string("The model takes the grid for a ") + (leftHanded ? "left" : "right") +
                           "-handed one, but most corners of its cells are " +
                           (leftHanded ? "not negative." : "negative."));
    result.hand_ = (agrees ? leftHanded : exact.leftHanded()) ? -1 : 1;
    if ((result.hand_ > 0 ? exact.negative : exact.positive) == 0)
        return result;
    std::vector<std::vector<LatticePoint>> layers(layerCount);
    const Status listed = verifyEach(layerCount, 1, activity, progress.part(0.5, 1), [&](std::size_t layer) {
        forEachGridCell(original.lattice, layer, [&](const LatticePoint& cell) {
            for (unsigned number = 0; number < 8; ++number)
                if (GridCorner(original, cell, number).sign() == -result.hand_) {
                    layers[layer].push_back(cell);
                    return;
                }
        });
    });
    if (!listed)
        return listed.error();
    for (const std::vector<LatticePoint>& layer : layers)
        result.folded_.insert(result.folded_.end(), layer.begin(), layer.end());
    return result;
}

/// Cuts the tetrahedron into slices of the grid's layers, these into columns along x, and looks how far the columns
/// reach. Only layers and rows that have folded cells are looked at.
bool LiftedOriginal::bears(const CellCorners& corners) const
{
    LatticePoint least = corners[0], most = corners[0];
    PointCloud tetrahedron;
    for (const LatticePoint& corner : corners) {
        tetrahedron.push_back({corner[0], corner[1], corner[2], 1});
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], corner[axis]);
            most[axis] = std::max(most[axis], corner[axis]);
        }
    }
    if (most[0] - least[0] <= 1 && most[1] - least[1] <= 1 && most[2] - least[2] <= 1)
        return true; // of one cell
    const auto from = [this](const LatticePoint& cell) { return std::ranges::lower_bound(folded_, cell); };
    for (auto cell = from({least[2], least[1], least[0]}); cell != folded_.end() && (*cell)[0] < most[2];) {
        const std::int64_t z = (*cell)[0];
        const PointCloud slice = cutBetween(tetrahedron, 2, z, z + 1);
        for (cell = from({z, least[1], least[0]}); cell != folded_.end() && (*cell)[0] == z && (*cell)[1] < most[1];) {
            const std::int64_t y = (*cell)[1];
            if (reachesBetween(slice, 1, y, y + 1)) {
                const PointCloud column = cutBetween(slice, 1, y, y + 1);
                for (cell = from({z, y, least[0]});
                     cell != folded_.end() && (*cell)[0] == z && (*cell)[1] == y && (*cell)[2] < most[0]; ++cell)
                    if (reachesBetween(column, 0, (*cell)[2], (*cell)[2] + 1))
                        return true;
            }
            cell = from({z, y + 1, least[0]});
        }
        cell = from({z + 1, least[1], least[0]});
    }
    return false;
}

} // namespace tetra
