// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

namespace tetra {

/// Goes through the text files of an EnSight case (6 and Gold) that VTK would read for a time step (from 1): geometry,
/// measured points, variables. Every number that sizes and parts ask for must be there, and every file. VTK's reader
/// takes the last line again and again where a file ends too early, and reads for ever where a keyword is unknown to
/// it. Binary files are only measured: VTK counts those by itself. Linear in the files; keeps sizes of parts, no
/// numbers.
Result<CheckedFile> checkEnSight(const std::filesystem::path& path, std::int64_t timeStep);

} // namespace tetra
