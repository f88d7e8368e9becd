// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Reads meshes with values by meshio, a library in Python: Gmsh, MED, XDMF, Nastran, Abaqus, Medit. It works in a
/// program of its own (tan-read-meshio.py) with limits, so that this reader loads at once, also where there is no
/// Python or no meshio; then it says what to install.
class MeshioReader : public Reader {
public:
    /// With the program at `script`; empty: beside the plugin.
    explicit MeshioReader(std::filesystem::path script = {});

    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<Dataset> readAround(const Eigen::AlignedBox3d& region, const std::filesystem::path& path,
                               const ParameterValues& values, const Progress& progress) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;

private:
    std::filesystem::path script_;
};

/// What meshio calls the format of a file, by its name and first bytes: "gmsh"; empty for others.
std::string meshioFormat(const std::filesystem::path& path, std::string_view firstBytes);

} // namespace tetra
