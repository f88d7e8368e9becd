// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// Which points of a dataset are taken.
struct DatasetPart {
    /// Grids: the first and the last point along each axis, whole numbers from 0, both taken. Other data: a box in
    /// space; of irregular meshes it holds whole tetrahedra. Nothing: all points.
    std::optional<Eigen::AlignedBox3d> region{};
    /// Grids: every n-th point along each axis, beginning with the region's first; positive.
    std::array<std::uint32_t, 3> stride{1, 1, 1};

    bool isWhole() const noexcept { return !region && stride == std::array<std::uint32_t, 3>{1, 1, 1}; }
};

/// The grid that a part of `lattice` is: its size and, where neighbours lie a stride apart, its spacing and origin.
/// Errors (WrongUsage): a region that is not in it, or is no whole numbers; fewer than two points along an axis.
TAN_INTERNAL Result<Lattice> partOfLattice(const Lattice& lattice, const DatasetPart& part);

/// The part as a dataset of its own, whose source is named after it and has a hash of its own. Samples of a lattice
/// that lie next to each other in a mapped file stay there, others are read from it and copied, so that no more memory
/// is taken than the part needs. Linear in the part's points; of scattered and irregular data in all of them.
///
/// Irregular: the tetrahedra whose four corners lie in the box, restrictToManifold().
///
/// Errors (WrongUsage): those of partOfLattice(); a stride of data that are no grid; nothing in the box. Not enough
/// memory; cancelled.
TAN_INTERNAL Result<Dataset> takePart(const Dataset& dataset, const DatasetPart& part, const Progress& progress = {});

/// "0,0,0,31,31,15": the region's corners, as parseRegion() reads them. Empty without a region.
TAN_INTERNAL std::string regionText(const DatasetPart& part);
/// "2" if all three are equal, else "1,1,2". Empty for 1.
TAN_INTERNAL std::string strideText(const DatasetPart& part);

/// Six numbers separated by commas, or nothing for an empty text. The error (WrongUsage) says what is wrong with it.
TAN_INTERNAL Result<std::optional<Eigen::AlignedBox3d>> parseRegion(std::string_view text);
/// One whole number or three separated by commas; 1 for an empty text.
TAN_INTERNAL Result<std::array<std::uint32_t, 3>> parseStride(std::string_view text);

} // namespace tetra
