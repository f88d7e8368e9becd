// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/analytic_fields.h"

#include "core/data/analytic_functions.h"
#include "core/data/analytic_grids.h"
#include "core/data/analytic_part.h"
#include "core/data/analytic_points.h"
#include "core/data/sample_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

namespace {

constexpr std::array<SampleKind, 10> kinds = {{
    {"c60", "electron density of the C60 molecule, a hollow ball of smooth bumps", SampleType::UInt8},
    {"hydrogen", "probability density of the hydrogen atom's 3d electron: two lobes and a ring", SampleType::Float32},
    {"marschner-lobb", "the test signal of Marschner and Lobb: ripples that are hard to reproduce",
     SampleType::Float32},
    {"noise", "white noise, the worst case: no sample tells of its neighbour", SampleType::UInt8},
    {"blunt-body", "flow in front of a hemisphere: a curvilinear grid whose axis is collapsed", SampleType::Float32,
     DomainClass::Curvilinear},
    {"o-grid", "flow around a cylinder: a curvilinear grid that closes on itself", SampleType::Float32,
     DomainClass::Curvilinear},
    {"bent-duct", "flow through a bent duct: a curvilinear grid", SampleType::Float32, DomainClass::Curvilinear},
    {"stretched", "a layer at a wall: a rectilinear grid with spacings that grow", SampleType::Float32,
     DomainClass::Curvilinear},
    {"scattered", "random points in a ball, with waves that grow finer outwards", SampleType::Float32,
     DomainClass::Scattered},
    {"part", "stress in a plate with five holes and a closed cavity: an irregular mesh", SampleType::Float32,
     DomainClass::Irregular},
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

using PlaneFunction = std::function<void(std::uint32_t k)>;

/// Makes all planes of the sample, on all threads.
Status forEachPlane(std::uint32_t size, const Progress& progress, const PlaneFunction& plane)
{
    constexpr std::string_view activity = "Making the sample";
    std::mutex reporting;
    std::uint32_t planesDone = 0;
    tbb::parallel_for(std::uint32_t(0), size, [&](std::uint32_t k) {
        if (progress.cancelled())
            return;
        plane(k);
        const std::scoped_lock lock(reporting);
        progress.report(++planesDone / static_cast<double>(size), activity);
    });
    if (progress.cancelled())
        return cancelledError(activity);
    return {};
}

void storeRow(std::span<const double> row, SampleType type, std::uint64_t first, std::byte* samples)
{
    visitSampleType(type, [&]<class T>() { quantise(row, reinterpret_cast<T*>(samples) + first); });
}

Status fillCube(const RowFunction& rows, SampleType type, std::uint32_t size, std::byte* samples,
                const Progress& progress)
{
    return forEachPlane(size, progress, [&](std::uint32_t k) {
        std::vector<double> row(size);
        for (std::uint32_t j = 0; j < size; ++j) {
            rows(j, k, row);
            storeRow(row, type, (std::uint64_t(k) * size + j) * size, samples);
        }
    });
}

Status fillGrid(const GridFunction& grid, SampleType type, std::uint32_t size, std::byte* samples,
                std::vector<Eigen::Vector3d>& positions, const Progress& progress)
{
    const auto fraction = [size](std::uint32_t index) { return index / (size - 1.0); };
    return forEachPlane(size, progress, [&](std::uint32_t k) {
        std::vector<double> row(size);
        for (std::uint32_t j = 0; j < size; ++j) {
            const std::uint64_t first = (std::uint64_t(k) * size + j) * size;
            for (std::uint32_t i = 0; i < size; ++i) {
                const GridPoint point = grid({fraction(i), fraction(j), fraction(k)});
                positions[first + i] = point.position.cast<float>().cast<double>(); // files and models stay small
                row[i] = point.value;
            }
            storeRow(row, type, first, samples);
        }
    });
}

/// On one thread: each random number follows from the one before.
Status fillBall(std::uint64_t seed, SampleType type, std::byte* samples, std::vector<Eigen::Vector3d>& positions,
                const Progress& progress)
{
    constexpr std::size_t pointsBetweenReports = 1 << 14;
    constexpr std::string_view activity = "Making the sample";
    ScatteredBall ball(seed);
    std::vector<double> row;
    for (std::size_t first = 0; first < positions.size(); first += row.size()) {
        if (progress.cancelled())
            return cancelledError(activity);
        row.resize(std::min(pointsBetweenReports, positions.size() - first));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const ScatteredPoint point = ball.next();
            positions[first + i] = point.position;
            row[i] = point.value;
        }
        storeRow(row, type, first, samples);
        progress.report(static_cast<double>(first + row.size()) / static_cast<double>(positions.size()), activity);
    }
    return {};
}

bool onGrid(const SampleKind& kind)
{
    return kind.domain == DomainClass::RegularLattice || kind.domain == DomainClass::Curvilinear;
}

std::string nameOf(const SampleKind& kind, std::uint32_t size, std::uint64_t points)
{
    const std::string edge = std::to_string(size);
    return std::string(kind.name) + " " + (onGrid(kind) ? edge + "x" + edge + "x" + edge : std::to_string(points));
}

/// A mesh, on one thread.
Result<Dataset> partDataset(SampleType type, std::uint32_t size, const Progress& progress)
{
    AnalyticMesh mesh = analyticPart(size);
    if (progress.cancelled())
        return cancelledError("Making the sample");
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(type, mesh.values.size());
    if (!samples)
        return samples.error();
    storeRow(mesh.values, type, 0, samples->get());
    Dataset dataset;
    dataset.lattice.size = {static_cast<std::uint32_t>(mesh.values.size()), 1, 1};
    dataset.values = ScalarField(type, mesh.values.size(), *std::move(samples));
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(mesh.positions));
    dataset.tetrahedra = std::make_shared<const std::vector<std::array<std::uint32_t, 4>>>(std::move(mesh.tetrahedra));
    return dataset;
}

Dataset described(Dataset dataset, const SampleKind& kind, std::uint32_t size)
{
    dataset.domain = kind.domain;
    dataset.source.name = nameOf(kind, size, dataset.pointCount());
    dataset.source.hash = contentHash(dataset.values, dataset.positions, dataset.tetrahedra);
    return dataset;
}

Status checkSize(const SampleKind& kind, std::uint32_t size)
{
    const std::uint32_t largest = onGrid(kind) ? largestSampleSize : largestScatteredSize;
    if (size >= smallestSampleSize && size <= largest)
        return {};
    return Error{ErrorKind::WrongUsage, "The sample '" + std::string(kind.name) + "' has from " +
                                            std::to_string(smallestSampleSize) + " to " + std::to_string(largest) +
                                            " points along each axis, not " + std::to_string(size) + "."};
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
    if (const Status fits = checkSize(*kind, request.size); !fits)
        return fits.error();
    const SampleType type = request.type.value_or(kind->type);
    if (kind->domain == DomainClass::Irregular) {
        Result<Dataset> part = partDataset(type, request.size, progress);
        return part ? described(*std::move(part), *kind, request.size) : part;
    }
    Dataset dataset;
    dataset.lattice.size = {request.size, request.size, request.size};
    const std::uint64_t count = dataset.lattice.pointCount();
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(type, count);
    if (!samples)
        return samples.error();
    Status filled;
    if (const GridFunction grid = gridFunction(request.name)) {
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(count);
        filled = fillGrid(grid, type, request.size, samples->get(), *positions, progress);
        dataset.positions = std::move(positions);
    } else if (kind->domain == DomainClass::Scattered) {
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(count);
        filled = fillBall(request.seed, type, samples->get(), *positions, progress);
        dataset.positions = std::move(positions);
        dataset.lattice.size = {static_cast<std::uint32_t>(count), 1, 1};
    } else {
        filled = fillCube(rowFunction(request), type, request.size, samples->get(), progress);
    }
    if (!filled)
        return filled.error();
    dataset.values = ScalarField(type, count, *std::move(samples));
    return described(std::move(dataset), *kind, request.size);
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to make the sample. Ask for a smaller size."};
}

} // namespace tetra
