// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/decimation.h"
#include "tests/core/history/model_fixture.h"

#include <tan/data.h>

#include <filesystem>
#include <memory>
#include <random>

namespace tetra {

/// A dataset of these tetrahedra. Values are doubles, or floats of the same numbers.
Dataset datasetOfTetrahedra(std::vector<Eigen::Vector3d> positions, const std::vector<double>& values,
                            std::vector<std::array<std::uint32_t, 4>> tetrahedra,
                            SampleType type = SampleType::Float64);

/// Without the points that no tetrahedron uses.
Dataset withoutUnused(const Dataset& dataset);

/// A small mesh with holes, cavities and one or two parts; every third along the axes, others with points moved about.
Dataset randomIrregular(std::uint32_t seed);

/// The same with a list of cells that were left out of it: a hole by its value, a tetrahedron and a hexahedron.
Dataset withFaultyCells(Dataset dataset);

/// The history of its decimation, which may limit the distance of the boundary from both sides (S13). What fails here
/// fails the test.
RecordedSteps decimated(const Dataset& dataset, const std::vector<float>& weights = {}, bool twoSided = false);

/// The same of the cells of a lattice, regular or curvilinear.
RecordedSteps decimatedGrid(const Dataset& dataset);

/// A model of a history, written and opened. What fails here fails the test.
std::shared_ptr<const Model> modelOf(const std::filesystem::path& path, const Dataset& dataset,
                                     const RecordedSteps& history,
                                     std::vector<std::pair<std::string, std::string>> parameters = {});

} // namespace tetra
