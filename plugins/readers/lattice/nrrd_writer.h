// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Writes a dataset as NRRD0004 with the data attached, raw or gzip. Reading it gives the same lattice and samples, bit
/// for bit.
class NrrdWriter : public Writer {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path) const override;
    std::vector<Parameter> parameters() const override;
    Status write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                 const Progress& progress) const override;
};

} // namespace tetra
