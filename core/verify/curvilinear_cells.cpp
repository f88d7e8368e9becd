// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/curvilinear_cells.h"

#include "core/geometry/orientation.h"
#include "core/history/site_positions.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>

namespace tetra {

GridPoints::GridPoints(const Dataset& grid) : lattice_(grid.lattice)
{
    std::uint32_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        count *= blocks_[axis] = (lattice_.size[axis] + 1) / 2;
    boxes_.resize(count);
    for (std::uint32_t block = 0; block < count; ++block)
        forEachPoint(block, [&](std::uint64_t point) { boxes_[block].extend((*grid.positions)[point]); });
    tree_ = BoxTree(
        count, [this](std::uint32_t block) { return boxes_[block]; },
        [this](std::uint32_t block, Eigen::Index axis) { return boxes_[block].center()[axis]; });
}

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

/// Where the corners of a cell of the grid lie; the bits of a corner's number choose the later point along x, y and z.
class CellPlaces {
public:
    CellPlaces(const Dataset& original, const LatticePoint& cell)
    {
        const auto& size = original.lattice.size;
        const Eigen::Vector3d* const first =
            original.positions->data() + original.lattice.index(static_cast<std::uint32_t>(cell[2]),
                                                                static_cast<std::uint32_t>(cell[1]),
                                                                static_cast<std::uint32_t>(cell[0]));
        for (unsigned corner = 0; corner < places_.size(); ++corner)
            places_[corner] =
                first[(corner & 1) + std::size_t(size[0]) * ((corner >> 1 & 1) + std::size_t(size[1]) * (corner >> 2))];
    }
    /// Six times the volume of the tetrahedron of a corner and its neighbours along the edges, as who writes a model
    /// finds it: for the hand that will do, and may not be the exact one.
    double roughVolume(unsigned corner) const
    {
        const Eigen::Vector3d& at = places_[corner];
        return turn(corner) *
               (places_[corner ^ 1] - at).dot((places_[corner ^ 2] - at).cross(places_[corner ^ 4] - at));
    }
    /// Its sign; exact. Most are decided by lengths alone, without the products that volumeSign() adds up.
    int sign(unsigned corner, double rough) const
    {
        const Eigen::Vector3d& at = places_[corner];
        const double lengths = (places_[corner ^ 1] - at).squaredNorm() * (places_[corner ^ 2] - at).squaredNorm() *
                               (places_[corner ^ 4] - at).squaredNorm();
        // No product is larger than the three lengths', and six of them are rounded a few times each.
        if (lengths > 1e-200 && rough * rough > 0x1p-80 * lengths && std::isfinite(lengths))
            return rough > 0 ? 1 : -1;
        return turn(corner) *
               volumeSign(places_[corner], places_[corner ^ 1], places_[corner ^ 2], places_[corner ^ 4]);
    }

private:
    /// -1 if an odd number of the edges runs backwards.
    static int turn(unsigned corner) { return std::popcount(corner) % 2 == 0 ? 1 : -1; }

    std::array<Eigen::Vector3d, 8> places_;
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

Result<CurvilinearOriginal> CurvilinearOriginal::make(const Dataset& original, bool leftHanded,
                                                      std::vector<std::string>& failures, const Progress& progress)
{
    const std::size_t layerCount = original.lattice.size[2] - 1;
    const std::string activity = "Verifying the cells of the grid";
    std::vector<std::array<CornerSigns, 2>> counts(layerCount);
    const Status counted = verifyEach(layerCount, 1, activity, progress.part(0, 0.5), [&](std::size_t layer) {
        forEachGridCell(original.lattice, layer, [&, &count = counts[layer]](const LatticePoint& cell) {
            const CellPlaces places(original, cell);
            for (unsigned corner = 0; corner < 8; ++corner) {
                const double rough = places.roughVolume(corner);
                count[0].add(places.sign(corner, rough));
                count[1].add(rough);
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
    CurvilinearOriginal result;
    result.size_ = original.lattice.size;
    const bool agrees = leftHanded == exact.leftHanded() || leftHanded == rough.leftHanded();
    if (!agrees)
        failures.push_back(std::string("The model takes the grid for a ") + (leftHanded ? "left" : "right") +
                           "-handed one, but most corners of its cells are " +
                           (leftHanded ? "not negative." : "negative."));
    result.hand_ = (agrees ? leftHanded : exact.leftHanded()) ? -1 : 1;
    if ((result.hand_ > 0 ? exact.positive : exact.negative) == 8 * original.lattice.cellCount())
        return result;
    struct Faulty {
        std::vector<LatticePoint> folded, withoutVolume;
    };
    std::vector<Faulty> layers(layerCount);
    const Status listed = verifyEach(layerCount, 1, activity, progress.part(0.5, 1), [&](std::size_t layer) {
        forEachGridCell(original.lattice, layer, [&, &found = layers[layer]](const LatticePoint& cell) {
            const CellPlaces places(original, cell);
            CornerSigns signs;
            for (unsigned corner = 0; corner < 8; ++corner)
                signs.add(places.sign(corner, places.roughVolume(corner)));
            if ((result.hand_ > 0 ? signs.negative : signs.positive) > 0)
                found.folded.push_back(cell);
            if (signs.negative + signs.positive == 0)
                found.withoutVolume.push_back(cell);
        });
    });
    if (!listed)
        return listed.error();
    for (const Faulty& layer : layers) {
        result.folded_.insert(result.folded_.end(), layer.folded.begin(), layer.folded.end());
        for (const LatticePoint& cell : layer.withoutVolume)
            result.withoutVolume_.push_back(result.numberOf(cell));
    }
    return result;
}

std::uint64_t CurvilinearOriginal::numberOf(const LatticePoint& cell) const
{
    const auto& [z, y, x] = cell;
    return static_cast<std::uint64_t>((z * (std::int64_t(size_[1]) - 1) + y) * (std::int64_t(size_[0]) - 1) + x);
}

std::vector<std::uint64_t> CurvilinearOriginal::foldedCellNumbers() const
{
    std::vector<std::uint64_t> numbers;
    for (const LatticePoint& cell : folded_)
        numbers.push_back(numberOf(cell));
    return numbers;
}

/// Cuts the tetrahedron into slices of the grid's layers, these into columns along x, and looks how far the columns
/// reach. Only layers and rows that have folded cells are looked at.
bool CurvilinearOriginal::allowsInverted(const LatticeCorners& corners) const
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

namespace {

/// Adds to `counts` the inverted tetrahedra that a site created, for each of the meshes that has them.
void countInvertedOf(const Model& model, std::uint32_t creator, std::span<const std::uint32_t> sites,
                     std::vector<std::uint64_t>& counts)
{
    const int inverted = model.description().leftHanded ? 1 : -1;
    const auto place = [&](std::uint32_t site) {
        const Eigen::Vector3d position = model.position(std::min(site, creator));
        return std::array<double, 3>{position.x(), position.y(), position.z()};
    };
    for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t) {
        const auto has = [creator, destroyer = model.destroyers()[t]](std::uint32_t count) {
            return creator < count && count <= destroyer;
        };
        if (std::ranges::none_of(sites, has))
            continue;
        const auto& [a, b, c] = model.otherSites()[t];
        if (orientationSign(place(creator), place(a), place(b), place(c)) != inverted)
            continue;
        for (std::size_t mesh = 0; mesh < sites.size(); ++mesh)
            counts[mesh] += has(sites[mesh]) ? 1 : 0;
    }
}

} // namespace

Result<std::vector<std::uint64_t>> countInverted(const Model& model, std::span<const std::uint32_t> sites)
{
    using Counts = std::vector<std::uint64_t>;
    const Counts none(sites.size(), 0);
    if (model.description().domain != DomainClass::Curvilinear)
        return none;
    if (const Status right = model.checkPrefix(model.siteCount(), Model::Stars); !right)
        return right.error();
    if (!model.check(model.floatPositions()) || !model.check(model.doublePositions()))
        return model.checkIntact().error();
    if (!std::ranges::is_sorted(model.starOffsets()) || model.starOffsets().back() != model.tetrahedronCount())
        return inconsistentModel(model, Message::say("its tetrahedra are not in the order of their sites"));
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, model.siteCount()), none,
        [&](const auto& range, Counts counts) {
            for (std::uint32_t creator = range.begin(); creator != range.end(); ++creator)
                countInvertedOf(model, creator, sites, counts);
            return counts;
        },
        [](Counts a, const Counts& b) {
            std::ranges::transform(a, b, a.begin(), std::plus());
            return a;
        });
}

} // namespace tetra
