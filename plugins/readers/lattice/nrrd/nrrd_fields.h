// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The header of a NRRD file, taken apart but not yet understood. (Format: "Definition of NRRD File Format",
/// https://teem.sourceforge.net/nrrd/format.html.)
struct NrrdFields {
    std::map<std::string, std::string> values; ///< by field name in lower case and in its present-day spelling
    std::vector<std::string> listedFiles;      ///< that stand below 'data file: LIST', to the end of the header
    std::size_t headerBytes = 0;               ///< up to and with the empty line that ends the header

    /// Empty if the field is not there.
    std::string_view operator[](const std::string& name) const
    {
        const auto found = values.find(name);
        return found != values.end() ? std::string_view(found->second) : std::string_view();
    }
    bool has(const std::string& name) const { return values.contains(name); }
};

/// True if a file begins as NRRD files do.
bool looksLikeNrrd(std::string_view firstBytes);

/// "LIST" or "LIST 2": the names of the files are the last lines of the header.
bool namesListOfFiles(std::string_view dataFile);

/// Reads the header at the beginning of `file`: magic, fields, comments and key/value pairs, lines ending in LF or CR
/// LF. It ends at the first empty line or with the file. Errors: no NRRD, a later version, a line that is no field, an
/// unknown field (it could be the misspelt spacing), a field given twice, no end within 1 MiB.
Result<NrrdFields> parseNrrdFields(std::string_view file);

} // namespace tetra
