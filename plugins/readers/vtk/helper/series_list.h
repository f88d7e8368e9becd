// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// A file of a list of files, with the name of the block that it is.
struct SeriesPart {
    std::string name;
    std::filesystem::path file;
};

/// All files of one time.
struct SeriesStep {
    double time = 0;
    std::vector<SeriesPart> parts;
};

/// The files that a ParaView list names, by time, ascending: a .pvd, whose files of one time are parts of a whole, or a
/// JSON text (.vtu.series), of which each file is a step. The files need not be there, but lie in the folder of the
/// list or below it. The errors say what is wrong with the list, which is then not used.
Result<std::vector<SeriesStep>> readSeries(const std::filesystem::path& path);

} // namespace tetra
