// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/reading_program.h"
#include "plugins/readers/images/dicom/dicom_header.h"

#include <tan/base.h>

#include <string>
#include <vector>

namespace tetra {

/// One series of a folder.
struct DicomSeries {
    Message name{}; ///< "T1 axial (SeriesNumber 3, MR, 176 pictures)"
    std::vector<DicomHeader> headers{};
};

/// The series of which pictures lie in a folder, by their numbers.
struct DicomFolder {
    std::vector<DicomSeries> series{};
    std::size_t opened = 0;            ///< in `series`
    std::vector<Message> unreadable{}; ///< sentences about files that are no good
};

/// Reads the headers of all DICOM files beside `path`. The error says what is wrong with "it", the file itself.
Result<DicomFolder> dicomFolder(const std::filesystem::path& path, const TellProgress& progress);

/// The number from 0 of the series that is asked for: by its number from 1, its SeriesInstanceUID, or its description
/// if no other one has that; empty: that of the opened file.
Result<std::size_t> chosenSeries(const DicomFolder& folder, const std::string& wanted);

} // namespace tetra
