// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// A level of detail as the paper's Tables 1 to 3 print it.
struct PaperLevel {
    double error = 0;   ///< % of the value range
    double warping = 0; ///< % of the bounding box's diagonal; 0 in convex domains
    std::uint64_t tetrahedra = 0;
    std::uint64_t sites = 0;
    double sitesPercent = 0; ///< of the dataset's, as printed: cut, not rounded
};

/// A model of Tables 1 to 3.
struct PaperModel {
    std::string dataset;
    std::array<std::uint32_t, 3> size{};
    std::uint64_t blockEdge = 0;  ///< 0: refined as a whole
    std::uint64_t tetrahedra = 0; ///< all that ever lived
    std::uint64_t bytes = 0;      ///< of memory, the most that the build took
    double seconds = 0;           ///< of a MIPS R4000 at 100 MHz
    std::vector<PaperLevel> levels;
};

/// A row of Table 4.
struct PaperSurface {
    std::string dataset;
    double isovalue = 0;
    double error = 0;   ///< %
    double warping = 0; ///< %
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0;
    std::uint64_t triangles = 0;
    double volumeSeconds = 0; ///< of direct volume rendering on a MIPS R4000
};

/// The models of table 1, 2 or 3 in a folder that holds table1.csv and so on, each with its levels in the order of the
/// file. Error: the file cannot be read or lacks a column, with the line.
Result<std::vector<PaperModel>> readPaperModels(const std::filesystem::path& folder, int table);

/// The rows of table4.csv.
Result<std::vector<PaperSurface>> readPaperSurfaces(const std::filesystem::path& folder);

} // namespace tetra
