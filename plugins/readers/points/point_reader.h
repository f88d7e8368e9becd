// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Reads tables of scattered points with one value each: CSV, TSV, blank-separated text (R1). Points on one place are
/// merged, and the dataset's remarks say so (S20).
class PointReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;
};

} // namespace tetra
