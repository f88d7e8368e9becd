// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/model/irregular/irregular_models.h"

#include "core/model/model_writer.h"
#include "tests/core/mesh/decimation/test_meshes.h"

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

Dataset randomIrregular(std::uint32_t seed)
{
    TestMesh mesh = nonconvexMesh(seed, seed % 3 == 0 ? 0 : 0.15);
    const SampleType type = seed % 2 == 0 ? SampleType::Float64 : SampleType::Float32;
    return datasetOfTetrahedra(std::move(mesh.positions), mesh.values, std::move(mesh.tetrahedra), type);
}

RecordedHistory decimated(const Dataset& dataset, const std::vector<float>& weights)
{
    std::vector<double> values(dataset.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
    DecimationMesh mesh;
    mesh.positions = *dataset.positions;
    mesh.values = values;
    mesh.weights = weights;
    mesh.tetrahedra = *dataset.tetrahedra;
    DecimationOptions options;
    options.warpingWeight = dataset.values.range().extent() / dataset.bounds().diagonal().norm();
    RecordedHistory history;
    if (!decimate(mesh, options, history))
        std::abort();
    return history;
}

std::shared_ptr<const Model> modelOf(const std::filesystem::path& path, const Dataset& dataset,
                                     const RecordedHistory& history,
                                     std::vector<std::pair<std::string, std::string>> parameters)
{
    ModelDescription description;
    description.builder = "decimation";
    description.parameters = std::move(parameters);
    auto writer = ModelWriter::create(path, dataset, std::move(description));
    if (!writer)
        std::abort();
    if (const Status written = replay(history, **writer); !written) {
        std::fputs(written.error().text.c_str(), stderr);
        std::abort();
    }
    auto model = Model::open(path);
    if (!model) {
        std::fputs(model.error().text.c_str(), stderr);
        std::abort();
    }
    return *model;
}

} // namespace tetra
