// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/model_writer.h"
#include "core/refine/free/scattered_refinement.h"
#include "tests/core/history/model_fixture.h"

#include <tan/query.h>

#include <QString>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

namespace tetra {

/// Random points, of a smooth field.
inline Dataset scatteredPoints(std::size_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    auto values = std::make_shared<std::vector<double>>();
    for (std::size_t point = 0; point < count; ++point) {
        const Eigen::Vector3d& place =
            positions->emplace_back(coordinate(random), coordinate(random), coordinate(random));
        values->push_back(std::sin(3 * place[0]) * place[1] + place[2]);
    }
    Dataset dataset;
    dataset.domain = DomainClass::Scattered;
    dataset.lattice.size = {static_cast<std::uint32_t>(count), 1, 1};
    dataset.positions = positions;
    dataset.values =
        ScalarField(SampleType::Float64, count, {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.source = {"points", {}, contentHash(dataset.values, dataset.positions)};
    return dataset;
}

/// Samples as a survey has them, where single precision would put a vertex onto its neighbours.
inline Dataset farLattice()
{
    Dataset dataset = bumps(SampleType::UInt8, {6, 5, 4});
    dataset.lattice.origin = {339385, 4264212, 1e8};
    dataset.lattice.spacing = {0.05, 0.05, 0.05};
    return dataset;
}

/// "integers", "floats", "bent", "bent doubles", "bent mirrored", "scattered", "far".
inline Dataset datasetOf(const QString& kind)
{
    if (kind == "far")
        return farLattice();
    if (kind == "scattered")
        return scatteredPoints(150);
    if (kind.startsWith("bent"))
        return bentBumps(SampleType::Float32, {5, 4, 5}, kind.contains("double"), kind.contains("mirrored"));
    return bumps(kind == "integers" ? SampleType::UInt8 : SampleType::Float32, {6, 5, 4});
}

/// Writes the dataset's model. What fails here fails the test.
inline std::shared_ptr<const Model> modelOf(const std::filesystem::path& path, const Dataset& dataset)
{
    if (dataset.domain != DomainClass::Scattered) {
        writeModel(path, dataset);
    } else {
        ModelDescription description;
        description.builder = "refinement";
        auto writer = ModelWriter::create(path, dataset, description);
        if (!writer || !refineScattered({*dataset.positions, dataset.values.as<double>(), {}}, 0, **writer))
            std::abort();
    }
    return Model::open(path).value();
}

/// A mesh, and a query that it answers.
struct Case {
    MeshQuery query;
    ExtractedMesh mesh;
};

/// The mesh of an accuracy.
inline Case uniform(const Model& model, const Accuracy& accuracy)
{
    Case made;
    made.query.error = accuracy.error;
    made.query.warping = accuracy.warping;
    const MeshSize size = meshSizeAt(model, accuracy);
    made.mesh.mesh = extractPrefix(model, size.sites).value();
    made.mesh.sites.resize(size.sites);
    std::iota(made.mesh.sites.begin(), made.mesh.sites.end(), 0U);
    made.mesh.points.assign(model.points().begin(), model.points().begin() + size.sites); // as if none were a site
    return made;
}

} // namespace tetra
