// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Writes a dataset on a grid, curvilinear or regular, as two binary PLOT3D files: the grid under the name given
/// (.xyz), the solution beside it (.q), with the values as its density and nothing else in it. Little-endian, one grid,
/// no record marks, no iblank; single precision if that holds positions and values exactly. Reading gives the same
/// positions and values.
class Plot3dWriter : public Writer {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path) const override;
    std::vector<Parameter> parameters() const override { return {}; }
    Status write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                 const Progress& progress) const override;
};

} // namespace tetra
