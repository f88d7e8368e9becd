// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/reading_process.h"

namespace tetra {

/// The program in which the NetCDF library reads, at this place.
ReadingProgram netCdfReadingProgram(std::filesystem::path helper);

/// Reads NetCDF files, grids by the conventions CF and of WRF, and Exodus, which is a convention of NetCDF: with the
/// choice of variable, time step, further dimensions and element block. What a file is its content says, not its name.
/// The library itself works in a program of its own, so that this reader loads at once, also where it is missing.
class NetCdfReader : public Reader {
public:
    /// With the program at `helper`; empty: beside the plugin.
    explicit NetCdfReader(std::filesystem::path helper = {});

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

    std::filesystem::path helper_;
};

} // namespace tetra
