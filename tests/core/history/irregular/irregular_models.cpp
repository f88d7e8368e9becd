// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/irregular/irregular_models.h"

#include "core/history/model_writer.h"
#include "tests/core/decimate/test_meshes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace tetra {

Dataset datasetOfTetrahedra(std::vector<Eigen::Vector3d> positions, const std::vector<double>& values,
                            std::vector<std::array<std::uint32_t, 4>> tetrahedra, SampleType type)
{
    Dataset dataset;
    dataset.domain = DomainClass::Irregular;
    dataset.lattice = {{static_cast<std::uint32_t>(positions.size()), 1, 1}, {1, 1, 1}, {0, 0, 0}};
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    dataset.tetrahedra = std::make_shared<const std::vector<std::array<std::uint32_t, 4>>>(std::move(tetrahedra));
    visitSampleType(type, [&]<class T>() {
        const auto samples = std::make_shared<std::vector<T>>();
        for (const double value : values)
            samples->push_back(static_cast<T>(value));
        dataset.values =
            ScalarField(type, samples->size(), {samples, reinterpret_cast<const std::byte*>(samples->data())});
    });
    dataset.source = {"a part", {}, contentHash(dataset.values, dataset.positions, dataset.tetrahedra)};
    return dataset;
}

Dataset withoutUnused(const Dataset& dataset)
{
    std::vector<std::uint32_t> numbers(dataset.pointCount(), 0xffffffff);
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra = *dataset.tetrahedra;
    for (auto& tetrahedron : tetrahedra)
        for (std::uint32_t& point : tetrahedron) {
            if (numbers[point] == 0xffffffff) {
                numbers[point] = static_cast<std::uint32_t>(positions.size());
                positions.push_back((*dataset.positions)[point]);
                values.push_back(dataset.values.at(point));
            }
            point = numbers[point];
        }
    return datasetOfTetrahedra(std::move(positions), values, std::move(tetrahedra), dataset.values.type());
}

Dataset randomIrregular(std::uint32_t seed)
{
    TestMesh mesh = nonconvexMesh(seed, seed % 3 == 0 ? 0 : 0.15);
    const SampleType type = seed % 2 == 0 ? SampleType::Float64 : SampleType::Float32;
    return datasetOfTetrahedra(std::move(mesh.positions), mesh.values, std::move(mesh.tetrahedra), type);
}

Dataset withFaultyCells(Dataset dataset)
{
    std::vector<FaultyCell> cells{
        {3, CellFault::NotFinite, {}},
        {8, CellFault::Overlap, {{1, 1, 1}, {2, 1, 1}, {1, 2.5, 1}, {1, 1, 1.75}}},
        {20,
         CellFault::Warped,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0.1, 1, 1}, {0, 1, 1}}}};
    dataset.faultyCells = std::make_shared<const std::vector<FaultyCell>>(std::move(cells));
    return dataset;
}

namespace {

std::vector<double> valuesOf(const Dataset& dataset)
{
    std::vector<double> values(dataset.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
    return values;
}

RecordedSteps decimated(const DecimationMesh& mesh, double warpingWeight, bool twoSided = false)
{
    DecimationOptions options;
    options.warpingWeight = warpingWeight;
    options.twoSided = twoSided;
    RecordedSteps history;
    if (!decimate(mesh, options, history))
        std::abort();
    return history;
}

double weightOf(const Dataset& dataset)
{
    return dataset.values.range().extent() / dataset.bounds().diagonal().norm();
}

} // namespace

RecordedSteps decimated(const Dataset& dataset, const std::vector<float>& weights, bool twoSided)
{
    const std::vector<double> values = valuesOf(dataset);
    return decimated({*dataset.positions, {}, values, weights, *dataset.tetrahedra, false}, weightOf(dataset),
                     twoSided);
}

RecordedSteps decimatedGrid(const Dataset& dataset)
{
    const std::vector<double> values = valuesOf(dataset);
    std::vector<Eigen::Vector3d> positions;
    for (std::uint64_t point = 0; point < values.size(); ++point) {
        const auto place = dataset.lattice.coordinates(point);
        positions.emplace_back(place[0], place[1], place[2]);
    }
    const auto tetrahedra = latticeTetrahedra(dataset.lattice.size, LatticeCut::Five);
    if (!dataset.positions)
        return decimated({positions, {}, values, {}, tetrahedra, true}, 0);
    return decimated({positions, *dataset.positions, values, {}, tetrahedra, true}, weightOf(dataset));
}

std::shared_ptr<const Model> modelOf(const std::filesystem::path& path, const Dataset& dataset,
                                     const RecordedSteps& history,
                                     std::vector<std::pair<std::string, std::string>> parameters)
{
    ModelDescription description;
    description.builder = "decimation";
    description.parameters = std::move(parameters);
    auto writer = ModelWriter::create(path, dataset, std::move(description));
    if (!writer)
        std::abort();
    if (const Status written = replay(history, **writer); !written) {
        std::fputs(written.error().text().c_str(), stderr);
        std::abort();
    }
    auto model = Model::open(path);
    if (!model) {
        std::fputs(model.error().text().c_str(), stderr);
        std::abort();
    }
    return *model;
}

} // namespace tetra
