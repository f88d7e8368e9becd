// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/reading_process.h"

namespace tetra {

/// The program in which the HDF5 library reads, at this place.
ReadingProgram hdf5ReadingProgram(std::filesystem::path helper);

/// Reads arrays of three dimensions and more by their paths in HDF5 files, whatever program wrote them. Formats that
/// have rules of their own inside HDF5 (NetCDF-4, VTK HDF, CGNS, MED) are left to their readers. The library itself
/// works in a program of its own, so that this reader loads at once, also where it is missing.
class Hdf5Reader : public Reader {
public:
    /// With the program at `helper`; empty: beside the plugin.
    explicit Hdf5Reader(std::filesystem::path helper = {});

    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;

private:
    std::filesystem::path helper_;
};

} // namespace tetra
