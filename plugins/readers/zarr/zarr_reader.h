// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/process/reading_process.h"

namespace tetra {

/// The program in which chunks are unpacked, at this place.
ReadingProgram zarrReadingProgram(std::filesystem::path helper);

/// Reads arrays of Zarr, versions 2 and 3, and images of OME-Zarr: with the choice of array, image, level, channel,
/// time and number along further axes. What is opened is the folder itself, of which this reader is certain, or one of
/// the files in it that say what it is. Everything is read in a program of its own, so that this reader loads at once,
/// also where libraries are missing.
class ZarrReader : public Reader {
public:
    /// With the program at `helper`; empty: beside the plugin.
    explicit ZarrReader(std::filesystem::path helper = {});

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
