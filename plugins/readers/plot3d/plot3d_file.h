// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/plot3d/plot3d_layout.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
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

/// The numbers of the grids that `wanted` (1 for the first; 0 for all) means in this file; alone, one is a volume.
Result<std::vector<std::size_t>> chooseGrids(const Plot3dFile& file, std::int64_t wanted);

/// How many points a grid has.
std::uint64_t pointCountOf(const Plot3dFile& file, std::size_t grid);

/// Of some points from `first` on component `number` of a grid's reals: of a grid file 0 to 2 are x, y, z, of a
/// solution file 0 to 4 density, the three momenta and energy. Error: damaged while it was read.
Status readComponent(const Plot3dFile& file, std::size_t grid, std::size_t number, std::uint64_t first,
                     std::span<double> to);

/// What a solution says of a grid's flow: Mach number, angle of attack, Reynolds number, time.
std::array<double, 4> flowState(const Plot3dFile& solution, std::size_t grid);

/// Calls visit(first, count), which gives a Status, for all points of a grid, some at a time. Errors: its first one,
/// cancelled.
template <class Visit> Status forPieces(std::uint64_t points, const Progress& progress, const Visit& visit)
{
    constexpr std::uint64_t pointsAtOnce = 1 << 16;
    for (std::uint64_t first = 0; first < points; first += pointsAtOnce) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        progress.report(static_cast<double>(first) / static_cast<double>(points), Message::marked("Reading"));
        if (const Status visited = visit(first, std::min(pointsAtOnce, points - first)); !visited)
            return visited;
    }
    return {};
}

/// One number a point of a grid file, not 0 for those with iblank 0, which are no part of the domain. Empty if there
/// are none. May throw std::bad_alloc.
std::vector<std::uint8_t> blankedPoints(const Plot3dFile& file, std::size_t grid);

/// An error about the file at `path`, for the user. WrongUsage if other parameters can help.
Error inPlot3dFile(const std::filesystem::path& path, const Message& text, ErrorKind kind = ErrorKind::BadInput);

} // namespace tetra
