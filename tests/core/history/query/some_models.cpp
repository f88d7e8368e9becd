// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/some_models.h"

#include "core/history/model_writer.h"
#include "core/refine/free/scattered_refinement.h"
#include "tests/core/history/model_fixture.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace tetra {

namespace {

std::shared_ptr<const Model> opened(const std::filesystem::path& path)
{
    auto model = Model::open(path);
    if (!model)
        std::abort();
    return *model;
}

} // namespace

std::vector<SomeModel> someModels(const std::filesystem::path& folder)
{
    const std::vector<std::pair<std::string, Dataset>> datasets = {
        {"lattice", bumps(SampleType::Float32, {7, 6, 5})},
        {"bytes", bumps(SampleType::UInt8, {5, 9, 4})},
        {"bent", bentBumps(SampleType::Float32, {6, 5, 4}, true)},
        {"mirrored", bentBumps(SampleType::Int16, {5, 5, 6}, false, true)},
    };
    std::vector<SomeModel> models;
    for (const auto& [name, dataset] : datasets) {
        const std::filesystem::path path = folder / (name + ".tan");
        writeModel(path, dataset);
        models.push_back({name, opened(path)});
    }
    models.push_back({"scattered", scatteredModel(folder / "scattered.tan", 150, 5)});
    return models;
}

std::shared_ptr<const Model> scatteredModel(const std::filesystem::path& path, std::size_t points, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    const auto values = std::make_shared<std::vector<double>>();
    for (std::size_t i = 0; i < points; ++i) {
        positions->emplace_back(coordinate(random), coordinate(random), coordinate(random));
        values->push_back(std::sin(4 * positions->back()[0]) * positions->back()[1] + positions->back()[2]);
    }
    Dataset dataset;
    dataset.domain = DomainClass::Scattered;
    dataset.lattice.size = {static_cast<std::uint32_t>(points), 1, 1};
    dataset.positions = positions;
    dataset.values =
        ScalarField(SampleType::Float64, points, {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.source = {"points", {}, contentHash(dataset.values, dataset.positions)};
    auto writer = ModelWriter::create(path, dataset, {});
    if (!writer || !refineScattered({*positions, *values, {}}, 0, **writer))
        std::abort();
    return opened(path);
}

} // namespace tetra
