// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

#include <tan/data.h>

#include <string>
#include <string_view>

namespace tetra {

/// Which of a file's arrays becomes the scalar.
struct CellsRequest {
    std::string array;     ///< a name, of .vtu files also a number from 1; empty: the one that suits best
    std::string component; ///< "magnitude", or a number from 0; only for arrays of several components; empty: magnitude
};

/// What a file of cells holds.
struct CellsFile {
    CellComplex complex;
    ComplexValues values;
    std::string arrayName;    ///< of the values, with what was taken of several components
    bool joinsPoints = false; ///< by lines or polygons
    std::vector<Message> remarks{};
    std::vector<Taken> taken{};     ///< Source::taken
    std::vector<Message> leftOut{}; ///< Source::leftOut
};

/// The component that a request names of an array with so many, -1 for the magnitude. Errors: WrongUsage.
Result<int> componentOf(const CellsRequest& request, int components);
/// What was taken of an array, as componentOf() tells the component: "U", "U (magnitude)", "U (component 0)".
std::string takenName(const FileArray& array, int component);
/// The same for Source::taken. `isGuess`: without a choice another array could be meant.
std::vector<Taken> takenOf(const CellsRequest& request, const FileArray& array, int component, bool isGuess);
/// That no array has the name asked for, naming those there are.
Error unknownArray(const std::string& name, const std::vector<FileArray>& arrays);

/// AVS UCD in text (.inp): `bytes` is the whole file. Errors name the line. Memory is bounded by the file's size,
/// whatever its header says.
Result<CellsFile> readUcd(std::string_view bytes, const CellsRequest& request, const Progress& progress);
Result<FileContents> probeUcd(std::string_view bytes, const CellsRequest& request);
/// Whether the first line that says something is five numbers.
bool looksLikeUcd(std::string_view firstBytes);

/// VTK XML unstructured grids (.vtu), in text, base64 or appended raw, plain or packed with zlib, several pieces.
/// Without a choice the array is that which the file calls active, else the first; arrays of points before those of
/// cells, of one component before several, and one that does not vary only if there is no other.
Result<CellsFile> readVtu(std::string_view bytes, const CellsRequest& request, const Progress& progress);
/// Arrays that do not vary are known by the ranges that the file tells; others are not looked at.
Result<FileContents> probeVtu(std::string_view bytes, const CellsRequest& request);
/// The type that a VTK XML file says it has ("UnstructuredGrid"); empty if it begins otherwise.
std::string vtkXmlType(std::string_view firstBytes);
/// Whether such a file is packed by anything but zlib, which readVtu() refuses.
bool isPackedOtherwise(std::string_view firstBytes);

} // namespace tetra
