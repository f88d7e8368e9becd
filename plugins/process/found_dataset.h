// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "plugins/process/findings.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Geometry>

#include <optional>

namespace tetra {

/// The dataset that the findings make: checked as those of every reader, cells cut into tetrahedra, points on one place
/// merged. `source` says the file; the hash is found here. The error says what is wrong with "it", for the caller to
/// name the file.
/// `region`: CellComplex's. `values`: the user's, of which those of cellsParameters() count.
Result<Dataset> datasetOf(FileFindings findings, const Source& source, const std::optional<Eigen::AlignedBox3d>& region,
                          const Progress& progress, const ParameterValues& values = {});

} // namespace tetra
