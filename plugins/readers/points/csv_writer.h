// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Writes the points of any dataset as a table with the columns x, y, z and value. Numbers are the shortest that are
/// read as the same again. What connects the points is lost.
class CsvWriter : public Writer {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path) const override;
    std::vector<Parameter> parameters() const override;
    Status write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                 const Progress& progress) const override;
};

} // namespace tetra
