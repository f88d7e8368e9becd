// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/arrays.h"
#include "plugins/readers/vtk/helper/leaves.h"
#include "plugins/readers/vtk/vtk_findings.h"

#include <cstddef>
#include <vector>

namespace tetra {

/// A part of a file, as far as that decides whether it is read.
struct VtkPart {
    std::vector<VtkArray> arrays{};
    bool isVolume = false; ///< it has cells of three dimensions
    bool isMesh = false;   ///< it is irregular, with cells listed one by one
};

/// Which parts of a file are read, and which array of them.
struct VtkSelection {
    std::vector<std::size_t> parts;               ///< numbers of leaves: one, or several volumes that are joined
    std::vector<std::size_t> partsWithoutArray{}; ///< volumes that would be joined if they had the array
    VtkArray array;                               ///< of the first of `parts`
    bool joinsVolumes = false;                    ///< they become one irregular mesh
    bool isGuess = false;                         ///< it is one of several that could be meant
};

/// The part that the request names; else all volumes that have the array of the first one with one; without a volume
/// the first part. Errors: no points; no such part or array.
Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const VtkRequest& request);

/// The same where only headers were looked at: of `leaves` only the names count, `parts` are what they hold.
Result<VtkSelection> selectParts(const std::vector<VtkLeaf>& leaves, const std::vector<VtkPart>& parts,
                                 const VtkRequest& request);

/// Whether it has cells of three dimensions.
bool isVolume(vtkDataSet& data);

/// Whether it is irregular, with cells listed one by one.
bool isMesh(vtkDataSet& data);

/// The array of the same name, of points or of cells as that one; nothing if there is none.
std::optional<VtkArray> sameArray(vtkDataSet& data, const VtkArray& wanted);

} // namespace tetra
