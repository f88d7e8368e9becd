// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

enum class FoundKind : std::uint8_t { Lattice, Grid, Cells, Points };

/// A cell of a lattice or a grid that is a hole because its own value is not finite.
inline constexpr std::uint8_t blankedForItsValue = 2;

/// What a library read, in plain arrays: not yet checked, it may have stumbled over a damaged file.
struct FileFindings {
    FoundKind kind = FoundKind::Lattice;
    Lattice lattice{.size = {0, 0, 0}}; ///< its size also of a grid
    std::string space{};                ///< as those of a dataset
    std::string lengthUnit{};
    std::vector<std::string> untold{};        ///< as FileContents::untold
    std::vector<Eigen::Vector3d> positions{}; ///< of all but lattices
    SampleType type = SampleType::Float32;
    Buffer<std::byte> samples{}; ///< of `type`, one a point, or a cell if `perCell`; of Cells doubles, whatever `type`
    bool perCell = false;        ///< of Cells only
    std::vector<CellShape> shapes{}; ///< of Cells, with the following as in CellComplex
    std::vector<std::uint64_t> offsets{};
    std::vector<std::uint64_t> corners{};
    std::vector<std::uint8_t> blanked{}; ///< one a cell, nonzero: a hole; empty if there are none; not of Points
    std::string arrayName{};
    std::vector<Message> remarks{};
    std::vector<Taken> taken{}; ///< as those of Source
    std::vector<Message> leftOut{};
};

} // namespace tetra
