// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The formats that VTK reads for us.
enum class VtkFormat : std::uint8_t {
    None,
    Xml,    ///< vti, vtr, vts, vtp, the parallel ones, those of vtu too, vtm; vtu that LZ4 or LZMA packs
    Legacy, ///< vtk
    Hdf,
    EnSight,
    Cgns,
    Gambit,
    Fluent,
    OpenFoam,
    Tecplot,
    Series ///< pvd, vtu.series ...: lists of files of the formats of VTK above
};

/// What a file is taken for, and how surely (0 to 1): from its name, and for formats with a signature from its first
/// bytes.
struct VtkGuess {
    VtkFormat format = VtkFormat::None;
    double score = 0;
};

VtkGuess guessVtkFormat(const std::filesystem::path& path, std::span<const std::byte> firstBytes);

/// Name filters of all formats, for the open dialog.
std::vector<std::string> vtkNameFilters();

} // namespace tetra
