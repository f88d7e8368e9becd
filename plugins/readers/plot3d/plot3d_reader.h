// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Reads curvilinear grids in PLOT3D files, binary and in text, a grid and a solution file: either is opened and finds
/// the other by its name. Byte order, precision, record marks and iblank follow from the files. Grids with points that
/// are blanked out become irregular meshes without them, and several grids, unless one is chosen, one mesh. What is
/// read and what is refused: docs/user/formats.md.
class Plot3dReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<Dataset> readAround(const Eigen::AlignedBox3d& region, const std::filesystem::path& path,
                               const ParameterValues& values, const Progress& progress) const override;
    std::vector<std::filesystem::path> companions(const std::filesystem::path& path,
                                                  const ParameterValues& values) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;
};

} // namespace tetra
