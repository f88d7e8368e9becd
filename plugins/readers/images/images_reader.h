// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/reading_process.h"
#include "plugins/readers/images/images_format.h"

namespace tetra {

/// The program in which GDCM and libtiff read, at this place, for files of one format.
ReadingProgram imagesReadingProgram(std::filesystem::path program, ImagesFormat format);

/// Reads volumes that are stored as pictures: DICOM by GDCM, TIFF by libtiff, each in a program of their own
/// (plugins/process), with the choice of series, channel and time.
class ImagesReader : public Reader {
public:
    /// With the program at `program`; empty: beside the plugin.
    explicit ImagesReader(std::filesystem::path program = {});

    std::vector<std::string> nameFilters() const override;
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override;
    std::vector<Parameter> parameters() const override;
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override;
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override;

private:
    std::filesystem::path program_;
};

} // namespace tetra
