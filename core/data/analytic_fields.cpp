// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_fields.h"

#include "core/base/checksum.h"
#include "core/data/analytic_functions.h"
#include "core/data/sample_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

namespace {

constexpr std::array<SampleKind, 4> kinds = {{
    {"c60", "electron density of the C60 molecule, a hollow ball of smooth bumps", SampleType::UInt8},
    {"hydrogen", "probability density of the hydrogen atom's 3d electron: two lobes and a ring", SampleType::Float32},
    {"marschner-lobb", "the test signal of Marschner and Lobb: ripples that are hard to reproduce",
     SampleType::Float32},
    {"noise", "white noise, the worst case: no sample tells of its neighbour", SampleType::UInt8},
}};

RowFunction rowFunction(const SampleRequest& request)
{
    if (request.name == "c60")
        return c60Density(request.size);
    if (request.name == "hydrogen")
        return hydrogenDensity(request.size);
    if (request.name == "marschner-lobb")
        return marschnerLobbSignal(request.size);
    return whiteNoise(request.size, request.seed);
}

Error unknownKind(std::string_view name)
{
    std::string text = "There is no sample called '" + std::string(name) + "'. There are:";
    for (const SampleKind& kind : kinds)
        text += " " + std::string(kind.name);
    return {ErrorKind::WrongUsage, text + "."};
}

template <class T> void quantise(std::span<const double> values, T* samples)
{
    std::ranges::transform(values, samples, [](double value) {
        if constexpr (std::is_integral_v<T>)
            return static_cast<T>(std::floor(std::min(value, 1.0) * std::numeric_limits<T>::max() + 0.5));
        else
            return static_cast<T>(value);
    });
}

Status fill(const RowFunction& rows, SampleType type, std::uint32_t size, std::byte* samples, const Progress& progress)
{
    constexpr std::string_view activity = "Making the sample";
    std::mutex reporting;
    std::uint32_t planesDone = 0;
    tbb::parallel_for(std::uint32_t(0), size, [&](std::uint32_t k) {
        if (progress.cancelled())
            return;
        std::vector<double> row(size);
        for (std::uint32_t j = 0; j < size; ++j) {
            rows(j, k, row);
            const std::uint64_t first = (std::uint64_t(k) * size + j) * size;
            visitSampleType(type, [&]<class T>() { quantise(row, reinterpret_cast<T*>(samples) + first); });
        }
        const std::scoped_lock lock(reporting);
        progress.report(++planesDone / static_cast<double>(size), activity);
    });
    if (progress.cancelled())
        return cancelledError(activity);
    return {};
}

} // namespace

std::span<const SampleKind> sampleKinds()
{
    return kinds;
}

Result<Dataset> makeSample(const SampleRequest& request, const Progress& progress)
try {
    const auto kind = std::ranges::find(kinds, request.name, &SampleKind::name);
    if (kind == kinds.end())
        return unknownKind(request.name);
    if (request.size < smallestSampleSize || request.size > largestSampleSize)
        return Error{ErrorKind::WrongUsage, "A sample has from " + std::to_string(smallestSampleSize) + " to " +
                                                std::to_string(largestSampleSize) + " points along each axis, not " +
                                                std::to_string(request.size) + "."};
    const SampleType type = request.type.value_or(kind->type);
    Dataset dataset;
    dataset.lattice.size = {request.size, request.size, request.size};
    const std::uint64_t count = dataset.lattice.pointCount();
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(type, count);
    if (!samples)
        return samples.error();
    if (const Status filled = fill(rowFunction(request), type, request.size, samples->get(), progress); !filled)
        return filled.error();
    dataset.values = ScalarField(type, count, *std::move(samples));
    const std::string size = std::to_string(request.size);
    dataset.source.name = std::string(kind->name) + " " + size + "x" + size + "x" + size;
    dataset.source.hash = checksum(dataset.values.bytes());
    return dataset;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to make the sample. Ask for a smaller size."};
}

} // namespace tetra
