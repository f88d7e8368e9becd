// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"

namespace tetra {

/// takePart() for scattered and irregular data, without name and hash.
Result<Dataset> partOfPoints(const Dataset& dataset, const Eigen::AlignedBox3d& box, const Progress& progress);

} // namespace tetra
