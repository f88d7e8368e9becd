// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/checks/checked_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

// What each format is held against before VTK reads it; each check is told whole in the source of its name. Errors are
// of bad input, and say what is missing. Any thread.

/// The path of a file that another one in `folder` names, if it lies in the folder `home` of the file that was opened,
/// or below it: so nobody's files are read because somebody else's list names them. Links in folders are followed.
Result<std::filesystem::path> fileBelow(const std::filesystem::path& home, const std::filesystem::path& folder,
                                        const std::string& name);

/// What VTK does not look at in a file of its XML formats before it works on it: elements nested or with attributes
/// without end, numbers of components that no array has, files that are missing, appended data that are cut; and of
/// grids (ImageData, RectilinearGrid, StructuredGrid) pieces that leave out part of the whole, a spacing or an origin
/// that are not three numbers, in place of which it takes zeros, and directions that are not nine, in place of which it
/// takes those of the world. Files that it names must lie in its folder or below it, and must not name each other in a
/// circle. Reads the file up to its appended data, and those that it names, each once, however often they are named:
/// `bytes` counts them once, too, so that a small file cannot ask for the work of a large one.
Result<CheckedFile> checkXml(const std::filesystem::path& path);

/// What stands in the attribute "type" of the element VTKFile; empty without one in the first bytes of the file.
std::string xmlType(const std::filesystem::path& path);

/// Tells of a legacy VTK file what VTK's own message does not: that it holds tables, trees or graphs and nothing to
/// show. Remarks a text that ends within its last number, or right behind it. Reads the first lines and the last byte.
Result<CheckedFile> checkLegacy(const std::filesystem::path& path);

/// Goes through the text files of an EnSight case (6 and Gold) that VTK would read for a time step (from 1): geometry,
/// measured points, variables. Every number that sizes and parts ask for must be there, and every file. VTK's reader
/// takes the last line again and again where a file ends too early, and reads for ever where a keyword is unknown to
/// it. Binary files are only measured: VTK counts those by itself. Linear in the files; keeps sizes of parts, no
/// numbers.
Result<CheckedFile> checkEnSight(const std::filesystem::path& path, std::int64_t timeStep);

/// Looks whether each section of a Fluent case (.cas), and of its data (.dat) beside it, ends. VTK leaves out a text
/// section that does not, and reads for ever in a binary one. Linear.
Result<CheckedFile> checkFluent(const std::filesystem::path& path);

/// Looks whether all that VTK opens of an OpenFOAM case (.foam, or system/controlDict) are regular files, and whether
/// the files that #include names lie in the folder of the case. Of large files the front and the end are looked at, of
/// packed ones the front. `bytes` are those of all.
Result<CheckedFile> checkFoam(const std::filesystem::path& opened);

/// Tells which HDF files are none of VTK's, or of a kind that VTK 9.1 does not know, by the names of groups and types
/// that stand in them; VTK's own messages say only what it looked for first. Whether a file is whole, the library of
/// HDF5 sees. Reads up to the name that decides, at most the first megabytes.
Result<CheckedFile> checkVtkHdf(const std::filesystem::path& path);

/// An HDF5 file must have no virtual arrays: their values lie in other files, which allowOneFile() keeps closed, and
/// the library gives zeros for them without a word. Linear.
Status checkHdfIsWhole(std::string_view bytes);

} // namespace tetra
