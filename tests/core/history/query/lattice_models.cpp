// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/lattice_models.h"

#include "core/base/checksum.h"
#include "core/history/blocks/block_runs.h"
#include "core/history/blocks/merged_model.h"
#include "core/history/model_writer.h"
#include "core/refine/lattice/lattice_refinement.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace tetra {

namespace {

template <class T, class Function> Dataset made(SampleType type, const Lattice& lattice, Function&& valueAt)
{
    const auto values = std::make_shared<std::vector<T>>(lattice.pointCount());
    for (std::uint64_t point = 0; point < values->size(); ++point)
        (*values)[point] = static_cast<T>(valueAt(lattice.coordinates(point)));
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    const ScalarField field(type, lattice.pointCount(), bytes);
    return {.lattice = lattice, .values = field, .source = {"random lattice", {}, checksum(field.bytes())}};
}

void orAbort(const Status& status)
{
    if (!status)
        std::abort();
}

void writeInBlocks(const Dataset& dataset, std::uint32_t cells, const std::filesystem::path& folder,
                   const std::filesystem::path& path)
{
    LatticeRunsOptions options;
    options.division = BlockDivision(dataset.lattice.size, cells);
    options.box.latticeSize = dataset.lattice.size;
    options.box.metric = latticeMetric(options.division.box(0).size, dataset.lattice.spacing).value();
    options.box.valueExtent = dataset.values.range().extent();
    RunFiles runs(folder, dataset.source.hash, options.division.count());
    orAbort(runs.openOwn(false));
    orAbort(visitSampleType(dataset.values.type(), [&]<class T>() {
        return makeLatticeRuns(options, LatticeSamples(dataset.values.as<T>()), runs, {});
    }));
    const ModelFileOpener open = [&](const FixedCounts& counts) {
        return ModelFileWriter::create(path, dataset, {}, counts, folder);
    };
    if (!mergeRuns(runs, folder, open, {}))
        std::abort();
}

void writeWhole(const Dataset& dataset, const std::filesystem::path& path)
{
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    const auto writer = ModelWriter::create(path, dataset, {});
    const bool refined = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>()), **writer).ok();
    });
    if (!refined)
        std::abort();
}

} // namespace

Dataset randomLattice(LatticeKind kind, const std::array<std::uint32_t, 3>& size, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const double stretch = seed % 3 == 0 ? 1.5 : 1;
    const Lattice lattice{size, {0.5, 0.5, 0.5 * stretch}, {-2, 7, 0.25}};
    const double phase = seed, pitch = 0.3 + 0.1 * (seed % 7);
    const auto wave = [&](const std::array<std::uint32_t, 3>& c) {
        return std::sin(pitch * c[0] + phase) + std::cos(0.7 * pitch * c[1]) * std::sin(0.5 * c[2] + 0.1 * c[0] * c[1]);
    };
    switch (kind) {
    case LatticeKind::Ties:
        return made<std::uint8_t>(SampleType::UInt8, lattice, [&](const auto&) { return random() % 3; });
    case LatticeKind::Noise:
        return made<std::uint16_t>(SampleType::UInt16, lattice, [&](const auto&) { return random() % 65536; });
    case LatticeKind::Smooth:
        return made<std::uint8_t>(SampleType::UInt8, lattice, [&](const auto& c) { return 120 + 55 * wave(c); });
    case LatticeKind::Wide:
        return made<double>(SampleType::Float64, lattice, [&](const auto&) {
            return std::normal_distribution()(random) * std::pow(10, std::uniform_real_distribution(-8.0, 8.0)(random));
        });
    case LatticeKind::Real: break;
    }
    return made<float>(SampleType::Float32, lattice, wave);
}

std::shared_ptr<const Model> modelOf(const Dataset& dataset, std::uint32_t blockCells,
                                     const std::filesystem::path& folder)
{
    const std::filesystem::path path = folder / (std::to_string(dataset.source.hash) + ".tan");
    if (blockCells > 0)
        writeInBlocks(dataset, blockCells, folder, path);
    else
        writeWhole(dataset, path);
    return Model::open(path).value();
}

} // namespace tetra
