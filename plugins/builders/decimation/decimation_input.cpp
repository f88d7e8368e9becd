// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_input.h"

#include "core/data/dataset_checks.h"
#include "core/geometry/orientation.h"
#include "plugins/builders/decimation/decimation_need.h"

#include <new>
#include <span>

namespace tetra {

namespace {

std::vector<double> valuesOf(const Dataset& dataset)
{
    return visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset.values.as<T>();
        return std::vector<double>(samples.begin(), samples.end());
    });
}

std::vector<Eigen::Vector3d> computationalPositions(const Lattice& lattice)
{
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(lattice.pointCount());
    for (std::uint32_t z = 0; z < lattice.size[2]; ++z)
        for (std::uint32_t y = 0; y < lattice.size[1]; ++y)
            for (std::uint32_t x = 0; x < lattice.size[0]; ++x)
                positions.emplace_back(x, y, z);
    return positions;
}

} // namespace

Result<DecimationInput> DecimationInput::make(const Dataset& dataset, const Weighting& weighting,
                                              const Progress& progress)
try {
    DecimationInput input(dataset);
    Result<std::vector<float>> weights = pointWeights(weighting, dataset, progress);
    if (!weights)
        return weights.error();
    input.weights_ = *std::move(weights);
    input.values_ = valuesOf(dataset);
    if (dataset.domain != DomainClass::Irregular) {
        input.positions_ = computationalPositions(dataset.lattice);
        input.tetrahedra_ = latticeTetrahedra(dataset.lattice.size, gridCut(dataset.domain));
    }
    return input;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 "Not enough memory to decimate '" + dataset.source.name + "'. Take a region of it or fewer samples."};
}

DecimationMesh DecimationInput::mesh() const
{
    DecimationMesh mesh;
    mesh.values = values_;
    mesh.weights = weights_;
    if (dataset_->domain == DomainClass::Irregular) {
        mesh.positions = *dataset_->positions;
        mesh.tetrahedra = *dataset_->tetrahedra;
        return mesh;
    }
    mesh.positions = positions_;
    mesh.tetrahedra = tetrahedra_;
    mesh.box = true;
    if (dataset_->domain == DomainClass::Curvilinear) {
        mesh.lifted = *dataset_->positions;
        mesh.leftHanded = isLeftHanded(*dataset_);
    }
    return mesh;
}

PhysicalSigns physicalSigns(const Dataset& dataset, std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    const auto at = [&](std::uint32_t point) {
        const Eigen::Vector3d& position = (*dataset.positions)[point];
        return std::array<double, 3>{position.x(), position.y(), position.z()};
    };
    const int right = isLeftHanded(dataset) ? -1 : 1;
    PhysicalSigns signs;
    for (const auto& corners : tetrahedra) {
        const int sign = orientationSign(at(corners[0]), at(corners[1]), at(corners[2]), at(corners[3]));
        signs.inverted += sign == -right ? 1 : 0;
        signs.degenerate += sign == 0 ? 1 : 0;
    }
    return signs;
}

} // namespace tetra
