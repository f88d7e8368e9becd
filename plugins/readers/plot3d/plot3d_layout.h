// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/plot3d/plot3d_text.h"

#include <tan/base.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The two files of a PLOT3D dataset.
enum class Plot3dKind { Grid, Solution };

/// How a PLOT3D file is laid out. The files do not say it; it follows from their sizes.
///
/// A file is a sequence of records: the number of grids (multi-grid files only); the sizes of all grids, three int32
/// each; then for each grid, of a grid file one record of all x, all y, all z and perhaps an int32 "iblank" a point, of
/// a solution file a record of four numbers and one of five quantities, all points of one after the other. Fortran puts
/// the length of a record in bytes, as int32, before and behind it. A file in text has the same numbers in the same
/// order.
struct Plot3dLayout {
    bool text = false; ///< without byte order, record marks and padding
    std::endian order = std::endian::little;
    bool recordMarks = false;
    bool multiGrid = false;
    std::uint32_t realBytes = 4;                       ///< 4 or 8; of a text the precision that it is written with
    bool iblank = false;                               ///< of a grid file
    std::vector<std::array<std::uint32_t, 3>> sizes{}; ///< of the grids, in points
    std::uint64_t padding = 0;                         ///< zeros behind the data, in bytes
};

/// Where the data of one grid are: offsets in bytes, of a text in numbers.
struct Plot3dBlock {
    std::uint64_t points = 0;
    std::uint64_t reals = 0;  ///< of the coordinates, or of the five quantities
    std::uint64_t iblank = 0; ///< 0 if there is none
    std::uint64_t state = 0;  ///< of a solution its four numbers
};

/// The block of grid number `grid`. The file holds it if it fits the layout.
Plot3dBlock plot3dBlock(const Plot3dLayout& layout, Plot3dKind kind, std::size_t grid);

/// The one layout by which a file of `fileBytes` bytes that begins with `firstBytes` is whole, record marks included as
/// far as `firstBytes` holds them. Up to 511 bytes behind the data may be there if they are zero, or not among
/// `firstBytes`. The error tells what the file could have been: cut short, too long, two-dimensional.
Result<Plot3dLayout> findPlot3dLayout(std::span<const std::byte> firstBytes, std::uint64_t fileBytes, Plot3dKind kind);

/// The one layout by which a text of these numbers is whole; errors as above.
Result<Plot3dLayout> findPlot3dLayout(const Plot3dText& text, Plot3dKind kind);

/// Reads an int32 as it stands in a file.
std::int32_t plot3dInteger(std::span<const std::byte> bytes, std::uint64_t offset, std::endian order);

} // namespace tetra
