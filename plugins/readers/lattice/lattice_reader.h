// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

namespace tetra {

/// Reads volumes on regular lattices: NRRD with the data attached (.nrrd) or in a file of their own (.nhdr), raw, gzip
/// or text; MetaImage, NIfTI, MRC; arrays of NumPy, Gaussian cubes, OpenDX and BOV; and raw files that the user
/// describes. What is read and what is refused: docs/user/formats.md.
class LatticeReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    std::vector<std::filesystem::path> companions(const std::filesystem::path& path,
                                                  const ParameterValues& values) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;
};

} // namespace tetra
