// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/reading_process.h"

namespace tetra {

struct VtkRequest;

/// The program in which VTK reads, at this place.
ReadingProgram vtkReadingProgram(std::filesystem::path helper);

/// Reads what VTK reads (vtk_format.h): grids, irregular meshes and points, with the choice of array, component, time
/// step and part. VTK itself works in a helper program, so that this reader loads at once, also where VTK is missing.
class VtkReader : public Reader {
public:
    /// With the helper program at `helper`; empty: beside the plugin.
    explicit VtkReader(std::filesystem::path helper = {});

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
    Result<Dataset> readAny(const std::optional<Eigen::AlignedBox3d>& region, const std::filesystem::path& path,
                            const ParameterValues& values, const Progress& progress) const;
    Result<FileContents> contentsAsked(VtkRequest request, const Progress& progress) const;

    std::filesystem::path helper_;
};

} // namespace tetra
