// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/bench_report.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace tetra {

/// Decimates the tetrahedra of a .vtu file to 50, 20 and 10 % of them beside VTK, and judges both by the same code.
/// Nothing, with a word on stderr, without the file or VTK.
std::vector<BenchCase> compareWithVtk(const QString& name, const QString& file);

/// The collapses a second of the lattice in a raw file of n x n x n bytes, down to the coarsest mesh, beside CGAL's
/// bulk insertion of as many points. Nothing, with a word on stderr, without the file.
std::vector<BenchCase> collapsesOfLattice(const QString& file, std::uint32_t n);

/// The synthetic C60 at growing sizes: how the time grows against n log n.
std::vector<BenchCase> growthOfTime(const std::vector<std::uint32_t>& sizes);

} // namespace tetra
