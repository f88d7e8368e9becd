// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/vtk_format.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What the helper program is asked for.
struct VtkRequest {
    bool contentsOnly = false; ///< probe() instead of read()
    VtkFormat format = VtkFormat::None;
    std::string path;
    std::string array; ///< a name, or a number from 1; "automatic"
    std::string component;
    std::int64_t timeStep = 1;        ///< from 1
    std::string part;                 ///< a name, or a number from 1; empty: what fits together
    std::vector<std::string> given{}; ///< givenPlacement(), which the helper refuses for what the file tells
};

enum class VtkDataKind : std::uint8_t { Lattice, Grid, Cells, Points };

/// A cell of a lattice or a grid that is a hole because its own value is not finite.
inline constexpr std::uint8_t blankedForItsValue = 2;

/// What VTK read, in plain arrays: not yet checked, the helper may have stumbled over a damaged file.
struct VtkFindings {
    VtkDataKind kind = VtkDataKind::Lattice;
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
