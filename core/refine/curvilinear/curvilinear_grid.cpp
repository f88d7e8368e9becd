// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/curvilinear/curvilinear_grid.h"

#include "core/geometry/orientation.h"

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

namespace tetra {

namespace {

using Integers = std::array<std::int64_t, 3>;

constexpr std::uint32_t foldedCellsOfLeaf = 4;

Integers crossProductOf(const Integers& a, const Integers& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::int64_t dotProductOf(const Integers& axis, const Integers& place)
{
    return axis[0] * place[0] + axis[1] * place[1] + axis[2] * place[2];
}

/// Where a convex body lies along an axis.
struct ExtentAlongAxis {
    std::int64_t least;
    std::int64_t most;
};

/// A tetrahedron of integer corners among boxes of integer corners. Two convex polyhedra have no inner point in common
/// if a plane divides them that is parallel to a face of one, or to an edge of each: there are 25 such directions. Each
/// term of a product has one factor of each coordinate, so that none exceeds six times the grid's points.
class TetrahedronAmongBoxes {
public:
    explicit TetrahedronAmongBoxes(const FoldedCells::Corners& corners)
    {
        std::array<Integers, 4> places{};
        for (std::size_t i = 0; i < 4; ++i)
            std::ranges::copy(corners[i], places[i].begin());
        origin_ = places[0];
        for (Integers& place : places)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] -= origin_[axis];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Integers direction{};
            direction[axis] = 1;
            add(direction, places);
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Integers& a = places[(corner + 1) % 4];
            const Integers& b = places[(corner + 2) % 4];
            const Integers& c = places[(corner + 3) % 4];
            add(crossProductOf({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]}),
                places);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                const auto& a = places[i];
                const auto& b = places[j];
                const Integers edge{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
                add({0, edge[2], -edge[1]}, places);
                add({-edge[2], 0, edge[0]}, places);
                add({edge[1], -edge[0], 0}, places);
            }
    }

    /// Whether it meets the interior of the box.
    bool meets(const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        for (std::size_t i = 0; i < count_; ++i) {
            const ExtentAlongAxis box = extentOf(i, first, last);
            if (extents_[i].most <= box.least || box.most <= extents_[i].least)
                return false;
        }
        return true;
    }

    /// Whether it holds the box.
    bool holds(const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        for (std::size_t face = firstFace; face < firstFace + 4; ++face) {
            const ExtentAlongAxis box = extentOf(face, first, last);
            if (box.least < extents_[face].least || box.most > extents_[face].most)
                return false;
        }
        return true;
    }

private:
    static constexpr std::size_t firstFace = 3;

    void add(const Integers& direction, const std::array<Integers, 4>& places)
    {
        if (direction == Integers{}) // the edge runs along an axis
            return;
        const auto [least, most] =
            std::ranges::minmax({dotProductOf(direction, places[0]), dotProductOf(direction, places[1]),
                                 dotProductOf(direction, places[2]), dotProductOf(direction, places[3])});
        directions_[count_] = direction;
        extents_[count_++] = {least, most};
    }

    ExtentAlongAxis extentOf(std::size_t number, const FoldedCells::Place& first, const FoldedCells::Place& last) const
    {
        const Integers& direction = directions_[number];
        ExtentAlongAxis extent{0, 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t a = direction[axis] * (first[axis] - origin_[axis]);
            const std::int64_t b = direction[axis] * (last[axis] - origin_[axis]);
            extent.least += std::min(a, b);
            extent.most += std::max(a, b);
        }
        return extent;
    }

    Integers origin_{};
    std::array<Integers, 25> directions_{};
    std::array<ExtentAlongAxis, 25> extents_{};
    std::size_t count_ = 0;
};

} // namespace

FoldedCells::FoldedCells(std::vector<Place> cells) : cells_(std::move(cells))
{
    if (!cells_.empty())
        addNode(0, static_cast<std::uint32_t>(cells_.size()));
}

std::uint32_t FoldedCells::addNode(std::uint32_t begin, std::uint32_t end)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node{.first = cells_[begin], .last = cells_[begin], .begin = begin, .end = end};
    for (std::uint32_t cell = begin; cell < end; ++cell)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.first[axis] = std::min(node.first[axis], cells_[cell][axis]);
            node.last[axis] = std::max(node.last[axis], cells_[cell][axis] + 1);
        }
    nodes_.push_back(node);
    if (end - begin <= foldedCellsOfLeaf)
        return number;
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (node.last[axis] - node.first[axis] > node.last[longest] - node.first[longest])
            longest = axis;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::ranges::nth_element(cells_.begin() + begin, cells_.begin() + middle, cells_.begin() + end, {},
                             [longest](const Place& cell) { return cell[longest]; });
    addNode(begin, middle);
    nodes_[number].second = addNode(middle, end);
    return number;
}

bool FoldedCells::meet(const Corners& corners) const
{
    if (cells_.empty())
        return false;
    const TetrahedronAmongBoxes tetrahedron(corners);
    // Halved at each step, so that of 2^32 cells no more than this wait.
    std::array<std::uint32_t, 40> waiting{0};
    std::size_t count = 1;
    while (count > 0) {
        const std::uint32_t number = waiting[--count];
        const Node& node = nodes_[number];
        if (!tetrahedron.meets(node.first, node.last))
            continue;
        if (tetrahedron.holds(node.first, node.last))
            return true;
        if (node.second != 0) {
            waiting[count++] = node.second;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::uint32_t cell = node.begin; cell < node.end; ++cell) {
            const auto& [x, y, z] = cells_[cell];
            if (tetrahedron.meets(cells_[cell], {x + 1, y + 1, z + 1}))
                return true;
        }
    }
    return false;
}

namespace {

/// Whether four points of a grid are corners of one of its cells. Exactly the tetrahedra whose circumsphere has no
/// point of the grid strictly inside are so: no further point can destroy them in a Delaunay mesh.
bool isOfOneCell(const FoldedCells::Corners& corners)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [least, most] =
            std::ranges::minmax({corners[0][axis], corners[1][axis], corners[2][axis], corners[3][axis]});
        if (most - least > 1)
            return false;
    }
    return true;
}

/// Residuals are sums of a few products of numbers of this size, each rounded at 2^-53 of it.
double roundingOf(double magnitude)
{
    return std::ldexp(magnitude, -48);
}

/// Of a cell; the bits of a corner's number choose the later point along x, y and z.
using CellPositions = std::array<Eigen::Vector3d, 8>;

std::array<std::uint32_t, 8> cornerOffsets(const std::array<std::uint32_t, 3>& size)
{
    std::array<std::uint32_t, 8> offsets{};
    for (std::uint32_t corner = 0; corner < 8; ++corner)
        offsets[corner] = (corner & 1) + (corner >> 1 & 1) * size[0] + (corner >> 2) * size[0] * size[1];
    return offsets;
}

/// Each edge that runs backwards turns the sign.
int turnOfCorner(unsigned corner)
{
    return std::popcount(corner) % 2 == 0 ? 1 : -1;
}

/// Six times the volume of a cell's corner with its three edges, as doubles give it, and by how much that may be off.
struct CornerVolume {
    double six;
    double doubt;

    /// 0: there is a doubt.
    int sign() const { return std::abs(six) > doubt ? (six > 0 ? 1 : -1) : 0; }
};

CornerVolume cornerVolumeOf(const CellPositions& corners, unsigned corner)
{
    const Eigen::Vector3d& at = corners[corner];
    const Eigen::Vector3d u = corners[corner ^ 1] - at;
    const Eigen::Vector3d v = corners[corner ^ 2] - at;
    const Eigen::Vector3d w = corners[corner ^ 4] - at;
    const Eigen::Vector3d a = v.cwiseAbs(), b = w.cwiseAbs();
    const double size = u.cwiseAbs().dot(
        Eigen::Vector3d(a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]));
    // Where products underflow, no bound on their rounding holds.
    constexpr double least = 1e-290;
    return {turnOfCorner(corner) * u.dot(v.cross(w)), std::max(roundingOf(size), least)};
}

int cornerSignOf(const CellPositions& corners, unsigned corner)
{
    if (const int sign = cornerVolumeOf(corners, corner).sign(); sign != 0)
        return sign;
    const auto at = [&](unsigned number) {
        return std::array<double, 3>{corners[number].x(), corners[number].y(), corners[number].z()};
    };
    return turnOfCorner(corner) * orientationSign(at(corner), at(corner ^ 1), at(corner ^ 2), at(corner ^ 4));
}

/// Calls visit(positions of the corners, number of the first) for each cell between two planes of points.
template <class Visit> void forEachCellOfLayer(const std::array<std::uint32_t, 3>& size, std::uint32_t z,
                                               const auto& positionOf, const Visit& visit)
{
    const std::array<std::uint32_t, 8> offsets = cornerOffsets(size);
    for (std::uint32_t y = 0; y + 1 < size[1]; ++y) {
        std::uint64_t first = (std::uint64_t(z) * size[1] + y) * size[0];
        for (std::uint32_t x = 0; x + 1 < size[0]; ++x, ++first) {
            CellPositions corners;
            for (unsigned corner = 0; corner < 8; ++corner)
                corners[corner] = positionOf(first + offsets[corner]);
            visit(corners, FoldedCells::Place{std::int32_t(x), std::int32_t(y), std::int32_t(z)});
        }
    }
}

/// What is summed up of a grid's planes.
struct GridSums {
    std::int64_t balance = 0; ///< of positive and negative corners of cells, for which signs in doubles will do
    double largestValue = 0;
    double largestCoordinate = 0;

    GridSums operator+(const GridSums& other) const
    {
        return {balance + other.balance, std::max(largestValue, other.largestValue),
                std::max(largestCoordinate, other.largestCoordinate)};
    }
};

} // namespace

CurvilinearFacts factsOf(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                         const LatticeSamples& samples)
{
    const auto sumsOf = [&](std::uint32_t z) {
        GridSums sums;
        const std::uint64_t layer = std::uint64_t(size[0]) * size[1];
        samples.visit([&](const auto* values) {
            for (std::uint64_t point = z * layer; point < (z + 1) * layer; ++point) {
                sums.largestValue = std::max(sums.largestValue, std::abs(static_cast<double>(values[point])));
                sums.largestCoordinate = std::max(sums.largestCoordinate, positions[point].cwiseAbs().maxCoeff());
            }
        });
        if (z + 1 == size[2])
            return sums;
        const auto positionOf = [&](std::uint64_t point) { return positions[point]; };
        forEachCellOfLayer(size, z, positionOf, [&](const CellPositions& corners, const FoldedCells::Place&) {
            for (unsigned corner = 0; corner < 8; ++corner) {
                const double six = cornerVolumeOf(corners, corner).six;
                sums.balance += six > 0 ? 1 : six < 0 ? -1 : 0;
            }
        });
        return sums;
    };
    const GridSums sums = tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, size[2]), GridSums(),
        [&](const tbb::blocked_range<std::uint32_t>& layers, GridSums of) {
            for (std::uint32_t z = layers.begin(); z < layers.end(); ++z)
                of = of + sumsOf(z);
            return of;
        },
        std::plus());
    return factsOf(sums.balance < 0 ? -1 : 1, sums.largestValue, sums.largestCoordinate);
}

CurvilinearFacts factsOf(int handedness, double largestValue, double largestCoordinate)
{
    return {handedness, roundingOf(largestValue), roundingOf(2 * largestCoordinate)};
}

CurvilinearGrid::CurvilinearGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                                 const LatticeSamples& samples)
    : CurvilinearGrid(size, {{0, 0, 0}, size}, positions, samples, factsOf(size, positions, samples))
{
}

CurvilinearGrid::CurvilinearGrid(const std::array<std::uint32_t, 3>& size, const LatticeBox& box,
                                 std::span<const Eigen::Vector3d> positions, const LatticeSamples& samples,
                                 const CurvilinearFacts& facts)
    : lattice_(box.size), facts_(facts)
{
    fill(size, box, positions, samples);
    findFoldedCells();
}

CurvilinearGrid::CurvilinearGrid(const std::array<std::uint32_t, 3>& size, std::span<const Eigen::Vector3d> positions,
                                 const LatticeSamples& samples, const KnownOfGrid& known)
    : lattice_(size), facts_(known.facts), foldedCells_(known.foldedCells)
{
    fill(size, {{0, 0, 0}, size}, positions, samples);
}

void CurvilinearGrid::fill(const std::array<std::uint32_t, 3>& size, const LatticeBox& box,
                           std::span<const Eigen::Vector3d> positions, const LatticeSamples& samples)
{
    points_.resize(box.pointCount());
    weights_.resize(samples.weighted() ? box.pointCount() : 0);
    std::vector<PackedPoint> row(box.size[0]);
    std::vector<double> values(box.size[0]);
    std::size_t index = 0;
    for (std::uint32_t z = 0; z < box.size[2]; ++z)
        for (std::uint32_t y = 0; y < box.size[1]; ++y) {
            for (std::uint32_t x = 0; x < box.size[0]; ++x)
                row[x] = lattice_.pack(x, y, z);
            samples.gather(lattice_, row, values.data());
            const std::uint64_t first =
                (std::uint64_t(box.origin[2] + z) * size[1] + box.origin[1] + y) * size[0] + box.origin[0];
            for (std::uint32_t x = 0; x < box.size[0]; ++x, ++index) {
                const Eigen::Vector3d& position = positions[first + x];
                points_[index].components = {position.x(), position.y(), position.z(), values[x]};
                if (samples.weighted())
                    weights_[index] = samples.weight(lattice_, row[x]);
            }
        }
}

/// Exact signs are found only of cells of which not all corners are of the grid's hand without doubt.
void CurvilinearGrid::findFoldedCells()
{
    const auto& size = lattice_.size();
    std::vector<FoldedCells::Place> folded;
    const auto positionOf = [&](std::uint64_t point) { return Eigen::Vector3d(points_[point].components.data()); };
    for (std::uint32_t z = 0; z + 1 < size[2]; ++z)
        forEachCellOfLayer(size, z, positionOf, [&](const CellPositions& corners, const FoldedCells::Place& place) {
            bool doubtful = false;
            for (unsigned corner = 0; corner < 8; ++corner)
                doubtful |= facts_.handedness * cornerVolumeOf(corners, corner).sign() <= 0;
            if (!doubtful)
                return;
            for (unsigned corner = 0; corner < 8; ++corner)
                if (facts_.handedness * cornerSignOf(corners, corner) < 0) {
                    folded.push_back(place);
                    return;
                }
        });
    foldedCells_ = FoldedCells(std::move(folded));
}

int CurvilinearGrid::orientation(const std::array<PackedPoint, 4>& vertices) const
{
    return facts_.handedness *
           orientationSign(position(vertices[0]), position(vertices[1]), position(vertices[2]), position(vertices[3]));
}

bool CurvilinearGrid::allowsInverted(const std::array<PackedPoint, 4>& vertices) const
{
    FoldedCells::Corners corners{};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = {lattice_.x(vertices[i]), lattice_.y(vertices[i]), lattice_.z(vertices[i])};
    return isOfOneCell(corners) || foldedCells_.meet(corners);
}

namespace {

/// The integer nearest to a / b, of two the smaller; b is positive.
std::int64_t nearestQuotient(std::int64_t a, std::int64_t b)
{
    // The quotient less a half, rounded up.
    const std::int64_t numerator = 2 * a - b, denominator = 2 * b;
    const std::int64_t towardsZero = numerator / denominator;
    return towardsZero + (numerator % denominator > 0 ? 1 : 0);
}

} // namespace

std::optional<PackedPoint> deepestPointInSphere(const PackedLattice& lattice, const DelaunayTetrahedron& tetrahedron,
                                                const LatticeBox& box)
{
    const PackedPoint apex = tetrahedron.vertices[0];
    const std::array<std::int32_t, 3> origin{lattice.x(apex), lattice.y(apex), lattice.z(apex)};
    const std::array<double, 4>& sphere = tetrahedron.sphere;
    // The distance to the centre is a sum over the axes, and the box is one of intervals: each axis by itself.
    std::array<std::uint32_t, 3> nearest{};
    double power = 0; // times the determinant; positive inside
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t offset =
            nearestQuotient(static_cast<std::int64_t>(sphere[axis]), 2 * static_cast<std::int64_t>(sphere[3]));
        const std::int64_t coordinate =
            std::clamp<std::int64_t>(origin[axis] + offset, box.origin[axis], box.last(axis));
        nearest[axis] = static_cast<std::uint32_t>(coordinate);
        const double q = static_cast<double>(coordinate - origin[axis]);
        power += sphere[axis] * q - sphere[3] * q * q;
    }
    if (power <= 0)
        return std::nullopt;
    return lattice.pack(nearest[0], nearest[1], nearest[2]);
}

} // namespace tetra
