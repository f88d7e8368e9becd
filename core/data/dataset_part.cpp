// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/dataset_part.h"

#include "core/base/guarded.h"
#include "core/data/dataset_checks.h"
#include "core/mesh/manifold.h"

#include <tan/data.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// A part of a grid in numbers of points.
struct GridPart {
    std::array<std::uint32_t, 3> first{};
    std::array<std::uint32_t, 3> count{};
    std::array<std::uint32_t, 3> stride{};
    Lattice from;

    std::uint64_t points() const { return std::uint64_t(count[0]) * count[1] * count[2]; }
    std::uint64_t rows() const { return std::uint64_t(count[1]) * count[2]; }
    /// The dataset's point that row `row` begins with.
    std::uint64_t rowBegin(std::uint64_t row) const
    {
        return from.index(first[0], first[1] + stride[1] * static_cast<std::uint32_t>(row % count[1]),
                          first[2] + stride[2] * static_cast<std::uint32_t>(row / count[1]));
    }
    /// Whether its points follow one another in the dataset.
    bool isContiguous() const
    {
        return stride == std::array<std::uint32_t, 3>{1, 1, 1} && count[0] == from.size[0] && count[1] == from.size[1];
    }
};

Error wrongPart(const Message& text)
{
    return {ErrorKind::WrongUsage, text};
}

std::string partSizeText(const std::array<std::uint32_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

Result<std::uint32_t> wholeNumber(double number, std::uint32_t size, int axis)
{
    if (number >= 0 && number < size && number == std::floor(number))
        return static_cast<std::uint32_t>(number);
    return wrongPart(Message::say("The region does not lie in the grid, of which it takes the numbers of points, not "
                                  "coordinates: along %1 whole numbers from 0 to %2.",
                                  std::string(1, "xyz"[axis]), size - 1));
}

Result<GridPart> gridPart(const Lattice& lattice, const DatasetPart& part)
{
    GridPart grid{{}, {}, part.stride, lattice};
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        const auto first = part.region ? wholeNumber(part.region->min()[axis], lattice.size[a], axis) : 0u;
        const auto last =
            part.region ? wholeNumber(part.region->max()[axis], lattice.size[a], axis) : lattice.size[a] - 1;
        if (!first)
            return first.error();
        if (!last)
            return last.error();
        if (part.stride[a] == 0)
            return wrongPart(Message::say("A stride is a whole number of at least 1."));
        const std::uint32_t points = *last >= *first ? (*last - *first) / part.stride[a] + 1 : 0;
        if (points < 2)
            return wrongPart(Message::say("The part has %1 points along %2, and a volume needs at least two along each "
                                          "axis. Choose a larger region or a smaller stride.",
                                          points, std::string(1, "xyz"[axis])));
        grid.first[a] = *first;
        grid.count[a] = points;
    }
    return grid;
}

/// Calls `copy(from, to, count)` for each row: the number of the dataset's first point, of the part's, how many.
template <class Copy> Status forEachRow(const GridPart& part, const Progress& progress, const Copy& copy)
{
    constexpr std::uint64_t rowsBetweenReports = 256;
    for (std::uint64_t row = 0; row < part.rows(); ++row) {
        if (row % rowsBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Reading"));
            progress.report(static_cast<double>(row) / static_cast<double>(part.rows()), Message::marked("Reading"));
        }
        copy(part.rowBegin(row), row * part.count[0], part.count[0]);
    }
    return {};
}

bool staysInFile(const Dataset& dataset, const GridPart& part)
{
    return dataset.mappedFile && part.isContiguous();
}

std::shared_ptr<const std::byte> samplesInFile(const Dataset& dataset, const GridPart& part)
{
    const std::size_t size = sampleSize(dataset.values.type());
    // The dataset's field keeps alive what it lies in.
    const auto owner = std::make_shared<const ScalarField>(dataset.values);
    return {owner, dataset.values.bytes().data() + part.rowBegin(0) * size};
}

Result<ScalarField> valuesOf(const Dataset& dataset, const GridPart& part, const Progress& progress)
{
    const SampleType type = dataset.values.type();
    if (staysInFile(dataset, part))
        return ScalarField::scanned(type, part.points(), samplesInFile(dataset, part), progress);
    auto samples = allocateSamples(type, part.points());
    if (!samples)
        return samples.error();
    const Status copied = visitSampleType(type, [&]<class T>() {
        const T* const from = dataset.values.as<T>().data();
        T* const to = reinterpret_cast<T*>(samples->get());
        return forEachRow(part, progress, [&](std::uint64_t source, std::uint64_t target, std::uint32_t count) {
            if (part.stride[0] == 1)
                std::memcpy(to + target, from + source, count * sizeof(T));
            else
                for (std::uint32_t i = 0; i < count; ++i)
                    to[target + i] = from[source + std::uint64_t(i) * part.stride[0]];
        });
    });
    if (!copied)
        return copied.error();
    return ScalarField(type, part.points(), *std::move(samples));
}

Result<PointPositions> positionsOf(const Dataset& dataset, const GridPart& part, const Progress& progress)
{
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(part.points());
    const Status copied =
        forEachRow(part, progress, [&](std::uint64_t source, std::uint64_t target, std::uint32_t count) {
            for (std::uint32_t i = 0; i < count; ++i)
                (*positions)[target + i] = (*dataset.positions)[source + std::uint64_t(i) * part.stride[0]];
        });
    if (!copied)
        return copied.error();
    return PointPositions(std::move(positions));
}

/// A cell of the part is a hole if one of those is that lie in it.
std::shared_ptr<const std::vector<GridCell>> cellsOf(const Dataset& dataset, const GridPart& part)
{
    const auto holeIn = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const auto& stride = part.stride;
        const std::uint64_t row = dataset.lattice.size[0] - 1, layer = row * (dataset.lattice.size[1] - 1);
        for (std::uint64_t z = part.first[2] + std::uint64_t(k) * stride[2], endZ = z + stride[2]; z < endZ; ++z)
            for (std::uint64_t y = part.first[1] + std::uint64_t(j) * stride[1], endY = y + stride[1]; y < endY; ++y)
                for (std::uint64_t x = part.first[0] + std::uint64_t(i) * stride[0], endX = x + stride[0]; x < endX;
                     ++x)
                    if (const GridCell cell = (*dataset.cells)[z * layer + y * row + x]; cell != GridCell::Kept)
                        return cell;
        return GridCell::Kept;
    };
    std::vector<GridCell> cells;
    for (std::uint32_t k = 0; k + 1 < part.count[2]; ++k)
        for (std::uint32_t j = 0; j + 1 < part.count[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < part.count[0]; ++i)
                cells.push_back(holeIn(i, j, k));
    if (std::ranges::count(cells, GridCell::Kept) == std::ssize(cells))
        return nullptr;
    return std::make_shared<const std::vector<GridCell>>(std::move(cells));
}

Result<Dataset> partOfGrid(const Dataset& dataset, const DatasetPart& part, const Progress& progress)
{
    const auto grid = gridPart(dataset.lattice, part);
    if (!grid)
        return grid.error();
    Dataset result = dataset;
    auto values = valuesOf(dataset, *grid, progress.part(0, 0.6));
    if (!values)
        return values.error();
    result.values = *std::move(values);
    if (dataset.positions) {
        result.lattice.size = grid->count; // the computational space keeps spacing 1 and origin 0
        auto positions = positionsOf(dataset, *grid, progress.part(0.6, 0.9));
        if (!positions)
            return positions.error();
        result.positions = *std::move(positions);
        if (const CellCornerSigns signs = cellCornerSigns(result);
            !hasHoles(dataset) && signs.positive + signs.negative == 0)
            return wrongPart(
                Message::say("No cell of the part has a volume. Choose another region or a smaller stride."));
    }
    if (!dataset.positions)
        result.lattice = *partOfLattice(dataset.lattice, part);
    if (dataset.cells)
        result.cells = cellsOf(dataset, *grid);
    if (!staysInFile(dataset, *grid))
        result.mappedFile = nullptr;
    result.remarks.push_back(Message::say("Part of the data: %1 of the %2 points.", partSizeText(grid->count),
                                          partSizeText(dataset.lattice.size)));
    return result;
}

std::string nameOfPart(const DatasetPart& part)
{
    const std::string region = regionText(part);
    const std::string stride = strideText(part);
    return (region.empty() ? "" : ", region " + region) + (stride.empty() ? "" : ", stride " + stride);
}

constexpr std::uint32_t notTaken = std::numeric_limits<std::uint32_t>::max();

Error nothingInside(const Message& what)
{
    return {ErrorKind::WrongUsage,
            Message::say("The region holds %1. Choose a larger one; 'bounds' of 'tan info' tells where the points lie.",
                         what)};
}

/// The points that are taken, in their order, and the number that each point has there.
struct Chosen {
    std::vector<std::uint32_t> points;
    std::vector<std::uint32_t> numbers;
};

template <class IsTaken> Chosen choose(std::uint64_t points, const IsTaken& isTaken)
{
    Chosen chosen;
    chosen.numbers.resize(points, notTaken);
    for (std::uint32_t point = 0; point < points; ++point)
        if (isTaken(point)) {
            chosen.numbers[point] = static_cast<std::uint32_t>(chosen.points.size());
            chosen.points.push_back(point);
        }
    return chosen;
}

Result<Dataset> ofPoints(const Dataset& dataset, const std::vector<std::uint32_t>& points)
{
    const SampleType type = dataset.values.type();
    auto samples = allocateSamples(type, points.size());
    if (!samples)
        return samples.error();
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    positions->reserve(points.size());
    visitSampleType(type, [&]<class T>() {
        T* to = reinterpret_cast<T*>(samples->get());
        for (const std::uint32_t point : points) {
            *to++ = dataset.values.as<T>()[point];
            positions->push_back((*dataset.positions)[point]);
        }
    });
    Dataset result = dataset;
    result.values = ScalarField(type, points.size(), *std::move(samples));
    result.positions = std::move(positions);
    result.lattice.size = {static_cast<std::uint32_t>(points.size()), 1, 1};
    result.mappedFile = nullptr;
    result.remarks.push_back(
        Message::say("Part of the data: %1 of the %2 points.", points.size(), dataset.pointCount()));
    return result;
}

Result<Dataset> partOfIrregular(const Dataset& dataset, const Eigen::AlignedBox3d& box, const Progress& progress)
{
    const auto& all = *dataset.tetrahedra;
    std::vector<std::uint8_t> taken(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        taken[i] =
            std::ranges::all_of(all[i], [&](std::uint32_t point) { return box.contains((*dataset.positions)[point]); });
    if (progress.cancelled())
        return cancelledError(Message::marked("Reading"));
    const std::uint64_t removed = restrictToManifold(all, static_cast<std::uint32_t>(dataset.positions->size()), taken);
    std::vector<std::uint8_t> isUsed(dataset.positions->size());
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const std::uint32_t point : all[i])
            isUsed[point] |= taken[i];
    const Chosen chosen = choose(isUsed.size(), [&](std::uint32_t point) { return isUsed[point] != 0; });
    if (chosen.points.empty())
        return nothingInside(Message::say("no whole tetrahedron"));
    auto result = ofPoints(dataset, chosen.points);
    if (!result)
        return result;
    auto tetrahedra = std::make_shared<std::vector<std::array<std::uint32_t, 4>>>();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (taken[i] != 0)
            tetrahedra->push_back({chosen.numbers[all[i][0]], chosen.numbers[all[i][1]], chosen.numbers[all[i][2]],
                                   chosen.numbers[all[i][3]]});
    result->tetrahedra = std::move(tetrahedra);
    if (removed > 0)
        result->remarks.push_back(
            removed == 1 ? Message::say("1 tetrahedron inside the region was left out: it touches the others only at a "
                                        "vertex or an edge.")
                         : Message::say("%1 tetrahedra inside the region were left out: they touch the others only at "
                                        "a vertex or an edge.",
                                        removed));
    return result;
}

/// takePart() for scattered and irregular data, without name and hash.
Result<Dataset> partOfPoints(const Dataset& dataset, const Eigen::AlignedBox3d& box, const Progress& progress)
{
    if (dataset.tetrahedra)
        return partOfIrregular(dataset, box, progress);
    constexpr std::size_t leastPoints = 4;
    const Chosen chosen =
        choose(dataset.pointCount(), [&](std::uint32_t point) { return box.contains((*dataset.positions)[point]); });
    if (chosen.points.size() < leastPoints)
        return nothingInside(Message::say("%1 points, and a volume needs four", chosen.points.size()));
    return ofPoints(dataset, chosen.points);
}

Result<Dataset> takeAnyPart(const Dataset& dataset, const DatasetPart& part, const Progress& progress)
{
    if (dataset.domain == DomainClass::RegularLattice || dataset.domain == DomainClass::Curvilinear)
        return partOfGrid(dataset, part, progress);
    if (part.stride != std::array<std::uint32_t, 3>{1, 1, 1})
        return wrongPart(Message::say("A stride is for points of a grid only. Choose a region."));
    return partOfPoints(dataset, *part.region, progress);
}

} // namespace

Result<Lattice> partOfLattice(const Lattice& lattice, const DatasetPart& part)
{
    const auto grid = gridPart(lattice, part);
    if (!grid)
        return grid.error();
    Lattice result = lattice;
    result.size = grid->count;
    for (int axis = 0; axis < 3; ++axis)
        result.spacing[axis] *= grid->stride[static_cast<std::size_t>(axis)];
    result.origin = lattice.position(grid->first[0], grid->first[1], grid->first[2]);
    return result;
}

Result<Dataset> takePart(const Dataset& dataset, const DatasetPart& part, const Progress& progress)
{
    return guarded(Message::marked("Not enough memory for this part. Choose a smaller one."), [&]() -> Result<Dataset> {
        if (part.isWhole())
            return dataset;
        auto result = takeAnyPart(dataset, part, progress);
        if (!result)
            return result;
        if (const Status intact = dataset.checkIntact(); !intact)
            return intact.error();
        result->convex = hasConvexDomain(*result);
        result->source.name += nameOfPart(part);
        result->source.hash = contentHash(result->values, result->positions, result->tetrahedra);
        progress.report(1, Message::marked("Reading"));
        return result;
    });
}

namespace {

std::vector<std::string_view> entriesOf(std::string_view text)
{
    std::vector<std::string_view> entries;
    for (;;) {
        const auto end = text.find(',');
        entries.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return entries;
        text.remove_prefix(end + 1);
    }
}

} // namespace

std::string regionText(const DatasetPart& part)
{
    std::string text;
    if (part.region)
        for (const Eigen::Vector3d& corner : {Eigen::Vector3d(part.region->min()), Eigen::Vector3d(part.region->max())})
            for (const double number : corner)
                text += (text.empty() ? "" : ",") + formatNumber(number);
    return text;
}

std::string strideText(const DatasetPart& part)
{
    const auto& stride = part.stride;
    if (stride[0] == stride[1] && stride[1] == stride[2])
        return stride[0] == 1 ? std::string() : std::to_string(stride[0]);
    return std::to_string(stride[0]) + "," + std::to_string(stride[1]) + "," + std::to_string(stride[2]);
}

Result<std::optional<Eigen::AlignedBox3d>> parseRegion(std::string_view text)
{
    if (text.empty())
        return std::optional<Eigen::AlignedBox3d>();
    const auto wrong = [&](const Message& what) {
        return Error{ErrorKind::WrongUsage, Message::say("The region '%1' %2", text, what)};
    };
    const auto entries = entriesOf(text);
    if (entries.size() != 6)
        return wrong(Message::say("is not understood. Give six numbers separated by commas: the first corner's and the "
                                  "last one's, as in 0,0,0,31,31,15."));
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < 6; ++i) {
        const auto number = parseNumber<double>(entries[i]);
        if (!number || !std::isfinite(*number))
            return wrong(Message::say("holds '%1', which is not a number.", entries[i]));
        numbers[i] = *number;
    }
    const Eigen::Vector3d first(numbers[0], numbers[1], numbers[2]);
    const Eigen::Vector3d last(numbers[3], numbers[4], numbers[5]);
    if ((first.array() > last.array()).any())
        return wrong(Message::say("ends before it begins. Give the smaller numbers first."));
    return std::optional(Eigen::AlignedBox3d(first, last));
}

Result<std::array<std::uint32_t, 3>> parseStride(std::string_view text)
{
    std::array<std::uint32_t, 3> stride{1, 1, 1};
    if (text.empty())
        return stride;
    const auto entries = entriesOf(text);
    for (std::size_t axis = 0; axis < 3 && (entries.size() == 1 || entries.size() == 3); ++axis) {
        const auto number = parseNumber<std::uint32_t>(entries[entries.size() == 1 ? 0 : axis]);
        stride[axis] = number.value_or(0);
    }
    if ((entries.size() != 1 && entries.size() != 3) || stride[0] == 0 || stride[1] == 0 || stride[2] == 0)
        return Error{ErrorKind::WrongUsage, Message::say("The stride '%1' is not understood. Give one whole number of "
                                                         "at least 1, or three separated by commas, as in 2,2,1.",
                                                         text)};
    return stride;
}

} // namespace tetra
