// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_complex.h"
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/cut_cells.h"

#include <cstdint>
#include <vector>

namespace tetra {

/// A value for each point of the complex that a tetrahedron uses, others hold anything: its own, the mean of those on
/// its place, or the mean of the cells around it. `repairs` is told.
std::vector<double> pointValues(const CellComplex& complex, const ComplexValues& values, const CleanCells& cells,
                                const CutCells& cut, Repairs& repairs);

/// The type that holds such values: means of whole numbers are none, and a float cannot hold every double.
SampleType typeOfPointValues(const ComplexValues& values, const Repairs& repairs,
                             const std::vector<double>& usedValues);

} // namespace tetra
