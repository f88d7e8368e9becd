// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/plot3d/plot3d_layout.h"

#include <tan/base.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace tetra {

/// A PLOT3D file, not yet known as a grid or a solution.
struct Plot3dSource {
    std::shared_ptr<const MappedFile> file;
    std::shared_ptr<const Plot3dText> text; ///< its numbers if it is text, else null
};

/// Opens the file, and reads it if it is text. May throw std::bad_alloc. Errors name the file.
Result<Plot3dSource> loadPlot3d(const std::filesystem::path& path, const Progress& progress);

/// The layout by which it is a file of this kind. Errors do not name the file.
Result<Plot3dLayout> findPlot3dLayout(const Plot3dSource& source, Plot3dKind kind);

/// A PLOT3D file whose layout is known.
struct Plot3dFile {
    Plot3dSource source;
    Plot3dKind kind = Plot3dKind::Grid;
    Plot3dLayout layout;

    const std::filesystem::path& path() const { return source.file->path(); }
};

/// Checks that the file is whole: sizes, record marks, nothing but zeros behind the data. Errors name the file.
Result<Plot3dFile> openPlot3d(const Plot3dSource& source, Plot3dKind kind);

/// The number of the grid that `wanted` (1 for the first; 0 if the user said nothing) means in this file.
Result<std::size_t> chooseGrid(const Plot3dFile& file, std::int64_t wanted);

/// Component `number` of a grid's reals: of a grid file 0 to 2 are x, y, z, of a solution file 0 to 4 density, the
/// three momenta and energy. May throw std::bad_alloc. Errors: damaged while it was read, cancelled.
Result<std::vector<double>> readComponent(const Plot3dFile& file, std::size_t grid, std::size_t number,
                                          const Progress& progress);

/// One number a point of a grid file, not 0 for those with iblank 0, which are no part of the domain. Empty if there
/// are none. May throw std::bad_alloc.
std::vector<std::uint8_t> blankedPoints(const Plot3dFile& file, std::size_t grid);

/// An error about the file at `path`, for the user. WrongUsage if other parameters can help.
Error inPlot3dFile(const std::filesystem::path& path, const Message& text, ErrorKind kind = ErrorKind::BadInput);

} // namespace tetra
