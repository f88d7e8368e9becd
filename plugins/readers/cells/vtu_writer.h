// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Writes irregular datasets as VTK XML unstructured grids: appended raw data, positions in doubles or, where they hold
/// them exactly, in floats. Read again they are the same points, values and tetrahedra.
class VtuWriter : public Writer {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path) const override;
    std::vector<Parameter> parameters() const override;
    Status write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                 const Progress& progress) const override;
};

} // namespace tetra
