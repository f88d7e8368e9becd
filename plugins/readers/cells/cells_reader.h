// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Reads meshes of cells into irregular datasets (R1): VTK XML unstructured grids (.vtu), of points alone into
/// scattered ones, and AVS UCD in text (.inp), likewise, without a library of others. What irregularDataset() repairs
/// is among the remarks.
class CellsReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<Dataset> readAround(const Eigen::AlignedBox3d& region, const std::filesystem::path& path,
                               const ParameterValues& values, const Progress& progress) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;
};

} // namespace tetra
