// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/samples/sampled_field.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"

#include <tan/render.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace tetra {
namespace {

constexpr MarkedText noMemoryForData =
    Message::marked("Not enough memory to show the data beside the mesh. Close other programs.");
constexpr std::uint8_t farthestBlock = 255;
constexpr std::size_t mostSegments = 0xfffe;
constexpr MarkedText preparing = Message::marked("Preparing the data");

std::uint64_t layerSamples(const Lattice& lattice)
{
    return std::uint64_t(lattice.size[0]) * lattice.size[1];
}

/// Calls visit(values) with the samples as what they are.
template <class Visit> auto withSamples(const ScalarField& field, Visit&& visit)
{
    switch (field.type()) {
    case SampleType::UInt8: return visit(field.as<std::uint8_t>());
    case SampleType::Int8: return visit(field.as<std::int8_t>());
    case SampleType::UInt16: return visit(field.as<std::uint16_t>());
    case SampleType::Int16: return visit(field.as<std::int16_t>());
    case SampleType::UInt32: return visit(field.as<std::uint32_t>());
    case SampleType::Int32: return visit(field.as<std::int32_t>());
    case SampleType::Float64: return visit(field.as<double>());
    default: return visit(field.as<float>());
    }
}

/// Calls work(layer) for each layer of a lattice, on all threads.
template <class Work>
void forEachLayer(std::uint32_t layers, const Progress& progress, double from, double to, const Work& work)
{
    SharedProgress done(progress.part(from, to), layers, preparing);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, layers, 1), [&](const auto& range) {
        for (std::uint32_t layer = range.begin(); layer != range.end() && !progress.cancelled(); ++layer) {
            work(layer);
            done.done(1);
        }
    });
}

/// In single precision unless rays are cast through them as they are.
ScalarField narrowed(const Lattice& lattice, const ScalarField& field, const Progress& progress)
{
    if (field.type() == SampleType::UInt8 || field.type() == SampleType::Int16 || field.type() == SampleType::Float32)
        return field;
    std::vector<float> values(field.count());
    const std::uint64_t layer = layerSamples(lattice);
    withSamples(field, [&](auto samples) {
        forEachLayer(lattice.size[2], progress, 0, 0.4, [&](std::uint32_t k) {
            std::transform(samples.begin() + static_cast<std::ptrdiff_t>(k * layer),
                           samples.begin() + static_cast<std::ptrdiff_t>((k + 1) * layer),
                           values.begin() + static_cast<std::ptrdiff_t>(k * layer),
                           [](auto value) { return static_cast<float>(value); });
        });
    });
    return progress.cancelled() ? ScalarField() : ScalarField::of(std::move(values));
}

/// The smallest and the largest of the samples [first, last] of a row.
template <class Value>
void extend(std::array<float, 2>& extent, const Value* row, std::uint32_t first, std::uint32_t last)
{
    const auto [least, largest] = std::minmax_element(row + first, row + last + 1);
    extent = {std::min(extent[0], static_cast<float>(*least)), std::max(extent[1], static_cast<float>(*largest))};
}

/// The extents of the blocks of one layer of blocks.
template <class Value> void findExtents(SampledField& field, std::span<const Value> samples, std::uint32_t layer)
{
    const auto& size = field.lattice.size;
    const auto end = [&](std::uint32_t block, std::size_t axis) {
        return std::min((block + 1) * sampleBlockSide, size[axis] - 1);
    };
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<float, 2>* extent = field.extents.data() + std::size_t(layer) * field.blocks[0] * field.blocks[1];
    for (std::uint32_t y = 0; y < field.blocks[1]; ++y)
        for (std::uint32_t x = 0; x < field.blocks[0]; ++x, ++extent) {
            *extent = {infinity, -infinity};
            for (std::uint32_t k = layer * sampleBlockSide; k <= end(layer, 2); ++k)
                for (std::uint32_t j = y * sampleBlockSide; j <= end(y, 1); ++j)
                    extend(*extent, samples.data() + field.lattice.index(0, j, k), x * sampleBlockSide, end(x, 0));
        }
}

} // namespace

Result<SampledField> makeSampledField(const Dataset& dataset, const Progress& progress)
{
    return guarded(noMemoryForData, [&]() -> Result<SampledField> {
        if (dataset.domain != DomainClass::RegularLattice || dataset.cells || dataset.values.notFiniteCount() > 0)
            return Error{ErrorKind::WrongUsage,
                         Message::say("Only the samples of a whole lattice can be shown beside the mesh.")};
        SampledField field{dataset.lattice, narrowed(dataset.lattice, dataset.values, progress), {}, {}};
        if (progress.cancelled())
            return cancelledError(preparing);
        for (std::size_t axis = 0; axis < 3; ++axis)
            field.blocks[axis] = (field.lattice.size[axis] - 1 + sampleBlockSide - 1) / sampleBlockSide;
        field.extents.resize(std::size_t(field.blocks[0]) * field.blocks[1] * field.blocks[2]);
        withSamples(field.values, [&](auto samples) {
            forEachLayer(field.blocks[2], progress, 0.4, 1,
                         [&](std::uint32_t layer) { findExtents(field, samples, layer); });
        });
        if (progress.cancelled())
            return cancelledError(preparing);
        return field;
    });
}

namespace {

/// The difference of a row's neighbours for one step along an axis at a sample.
template <class Value> struct Differences {
    const Value* samples;
    const Lattice& lattice;

    float along(std::size_t axis, std::uint64_t here, std::uint32_t index) const
    {
        const std::uint64_t stride = axis == 0 ? 1 : axis == 1 ? lattice.size[0] : layerSamples(lattice);
        const bool first = index == 0, last = index + 1 == lattice.size[axis];
        const auto before = static_cast<float>(samples[first ? here : here - stride]);
        const auto after = static_cast<float>(samples[last ? here : here + stride]);
        return first || last ? after - before : (after - before) / 2;
    }
    Eigen::Vector3f at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        const std::uint64_t here = lattice.index(i, j, k);
        return {along(0, here, i), along(1, here, j), along(2, here, k)};
    }
};

/// Calls visit(sample, gradient) for the samples of a layer, the gradient in world coordinates.
template <class Value, class Visit> void forEachGradient(const Lattice& lattice, std::span<const Value> samples,
                                                         const Eigen::Matrix3f& worldFromIndex, std::uint32_t layer,
                                                         const Visit& visit)
{
    const Differences<Value> differences{samples.data(), lattice};
    for (std::uint32_t j = 0; j < lattice.size[1]; ++j)
        for (std::uint32_t i = 0; i < lattice.size[0]; ++i)
            visit(lattice.index(i, j, layer), worldFromIndex * differences.at(i, j, layer));
}

/// What turns differences along the indices into gradients: the transposed inverse of the steps.
Eigen::Matrix3d gradientsFromDifferences(const Lattice& lattice)
{
    return (lattice.directions * lattice.spacing.asDiagonal()).inverse().transpose();
}

} // namespace

Result<SampleGradients> sampleGradients(const SampledField& field, const Progress& progress)
{
    return guarded(noMemoryForData, [&]() -> Result<SampleGradients> {
        const Eigen::Matrix3d wholeMatrix = gradientsFromDifferences(field.lattice);
        const double unit = wholeMatrix.cwiseAbs().maxCoeff(); // so that what follows are floats whatever the lengths
        const Eigen::Matrix3f matrix = (wholeMatrix / unit).cast<float>();
        SampleGradients gradients{Buffer<std::array<std::int16_t, 4>>(field.values.count())};
        std::vector<float> largest(field.lattice.size[2], 0);
        withSamples(field.values, [&](auto samples) {
            forEachLayer(field.lattice.size[2], progress, 0, 0.5, [&](std::uint32_t layer) {
                forEachGradient(field.lattice, samples, matrix, layer, [&](std::uint64_t, const Eigen::Vector3f& here) {
                    largest[layer] = std::max(largest[layer], here.cwiseAbs().maxCoeff());
                });
            });
            const float most = *std::ranges::max_element(largest);
            const float scale = most > 0 && std::isfinite(most) ? 32767 / most : 0;
            gradients.unit = scale > 0 ? unit / scale : 0;
            forEachLayer(field.lattice.size[2], progress, 0.5, 1, [&](std::uint32_t layer) {
                forEachGradient(field.lattice, samples, matrix, layer,
                                [&](std::uint64_t sample, const Eigen::Vector3f& here) {
                                    for (int axis = 0; axis < 3; ++axis)
                                        gradients.vectors[sample][static_cast<std::size_t>(axis)] =
                                            static_cast<std::int16_t>(std::lrint(here[axis] * scale));
                                    gradients.vectors[sample][3] = 0;
                                });
            });
        });
        if (progress.cancelled())
            return cancelledError(preparing);
        return gradients;
    });
}

namespace {

/// Whether any value of an extent is seen: extinction is affine in a segment, so it is largest at an end.
bool isSeen(const std::array<float, 2>& extent, std::span<const TransferSegment> segments)
{
    return std::ranges::any_of(segments, [&](const TransferSegment& segment) {
        const double least = std::max<double>(segment.begin, extent[0]);
        const double largest = std::min<double>(segment.end, extent[1]);
        const auto extinction = [&](double value) {
            return segment.atOrigin.extinction + (value - segment.origin) * segment.perValue.extinction;
        };
        return least <= largest && !segment.transparent() && (extinction(least) > 0 || extinction(largest) > 0);
    });
}

/// Where a block is among all.
using BlockPlace = std::array<std::uint32_t, 3>;

std::size_t numberOf(const BlockPlace& place, const BlockPlace& count)
{
    return (std::size_t(place[2]) * count[1] + place[1]) * count[0] + place[0];
}

/// The smallest distance of the block's thirteen neighbours that come before it (direction -1) or after it (1).
int leastOfNeighbours(const std::vector<std::uint8_t>& distances, const BlockPlace& count, const BlockPlace& place,
                      int direction)
{
    constexpr int before = 13; // of the 27 in a cube, before the middle one
    int least = farthestBlock;
    for (int neighbour = 0; neighbour < before; ++neighbour) {
        const int steps[] = {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
        BlockPlace there{};
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t index = std::int64_t(place[axis]) - direction * steps[axis];
            inside = inside && index >= 0 && index < std::int64_t(count[axis]);
            there[axis] = static_cast<std::uint32_t>(index);
        }
        if (inside)
            least = std::min<int>(least, distances[numberOf(there, count)]);
    }
    return least;
}

/// Turns 0 for some blocks, and the largest number for others, into distances: once forwards and once backwards are
/// enough (A. Rosenfeld and J. Pfaltz, "Distance functions on digital pictures", Pattern Recognition 1, 1968).
void spreadDistances(std::vector<std::uint8_t>& distances, const BlockPlace& count)
{
    for (const int direction : {-1, 1})
        for (std::size_t step = 0; step < distances.size(); ++step) {
            const std::size_t block = direction < 0 ? step : distances.size() - 1 - step;
            if (distances[block] == 0)
                continue;
            const BlockPlace place{static_cast<std::uint32_t>(block % count[0]),
                                   static_cast<std::uint32_t>(block / count[0] % count[1]),
                                   static_cast<std::uint32_t>(block / count[0] / count[1])};
            const int least = leastOfNeighbours(distances, count, place, direction);
            distances[block] = static_cast<std::uint8_t>(std::min<int>(distances[block], least + 1));
        }
}

} // namespace

Result<SampledTransfer> makeSampledTransfer(const SampledField& field, std::span<const TransferSegment> segments)
{
    return guarded(noMemoryForData, [&]() -> Result<SampledTransfer> {
        if (segments.size() > mostSegments)
            return Error{ErrorKind::OutOfResource,
                         Message::say("The transfer function has more than 65,000 points. Leave some out.")};
        SampledTransfer transfer{{segments.begin(), segments.end()}, std::vector<std::uint8_t>(field.extents.size())};
        std::ranges::transform(field.extents, transfer.distances.begin(), [&](const std::array<float, 2>& extent) {
            return isSeen(extent, transfer.segments) ? std::uint8_t(0) : farthestBlock;
        });
        spreadDistances(transfer.distances, field.blocks);
        return transfer;
    });
}

namespace {

bool isSameSegment(const TransferSegment& one, const TransferSegment& other)
{
    const auto equal = [](const TransferSample& a, const TransferSample& b) {
        return a.colour == b.colour && a.extinction == b.extinction;
    };
    return one.begin == other.begin && one.end == other.end && one.origin == other.origin &&
           equal(one.atOrigin, other.atOrigin) && equal(one.perValue, other.perValue);
}

} // namespace

Result<SampledVolume> SampledVolumeCache::update(const TransferFunction& function, bool shaded,
                                                 const Progress& progress)
{
    if (Status status = checkTransferFunction(function); !status)
        return status.error();
    return update(transferSegments(function), shaded, progress);
}

Result<SampledVolume> SampledVolumeCache::update(std::span<const TransferSegment> segments, bool shaded,
                                                 const Progress& progress)
{
    if (!samples_) {
        auto made = makeSampledField(*dataset_, progress.part(0, 0.5));
        if (!made)
            return made.error();
        samples_ = std::make_shared<const SampledField>(*std::move(made));
    }
    if (shaded && !gradients_) {
        auto made = sampleGradients(*samples_, progress.part(0.5, 1));
        if (!made)
            return made.error();
        gradients_ = std::make_shared<const SampleGradients>(*std::move(made));
    }
    if (!transfer_ || !std::ranges::equal(transfer_->segments, segments, isSameSegment)) {
        auto made = makeSampledTransfer(*samples_, segments);
        if (!made)
            return made.error();
        transfer_ = std::make_shared<const SampledTransfer>(*std::move(made));
    }
    return SampledVolume{samples_, transfer_, shaded ? gradients_ : nullptr};
}

} // namespace tetra
