// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

namespace tetra::python {

/// A dataset that was made of arrays. Values of a lattice or a grid may lie in the memory of the array that they came
/// in, which the dataset keeps.
struct HeldDataset {
    Dataset dataset;
};

} // namespace tetra::python
