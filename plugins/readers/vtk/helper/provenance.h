// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/helper/selection.h"

#include <tan/data.h>

#include <span>
#include <string>
#include <vector>

namespace tetra {

/// What stands in Source::taken and Source::leftOut (D3) of what VTK reads.
struct Provenance {
    std::vector<Taken> taken; ///< in the order of TakenPart
    std::vector<Message> leftOut;
};

/// Puts it where its part belongs; before what is there of the same part.
void addTaken(Taken one, Provenance& provenance);

/// The array of `all` that was chosen, and its component. It is a guess if the user named none, there are several, and
/// the file marks none; unnamed ones are told only if there are several.
void tellArray(const std::vector<VtkArray>& all, const VtkArray& chosen, const VtkRequest& request,
               Provenance& provenance);

/// The parts that were taken, unless they are all, and those that are not read; of `leaves` only the names count.
void tellParts(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection, Provenance& provenance);

/// Which of several time steps (from 1) was read; `file`: in which file it lies, if each has its own.
void tellTimeStep(std::span<const double> times, const VtkRequest& request, const std::string& file,
                  Provenance& provenance);

/// "a, b, c ...": so many as one can read.
std::string namesToldOf(const std::vector<std::string>& names);

/// The array, the parts, and what of their data is not read.
Provenance provenanceOf(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection, const VtkRequest& request);

} // namespace tetra
