// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/helper/hdf5_id.h"

#include <string>
#include <vector>

namespace tetra {

// Attributes of a group or an array. What is missing, of another kind, or longer than such things are, is empty.

bool hasAttribute(hid_t object, const char* name);

/// Texts of fixed or of any length, without what pads them.
std::vector<std::string> attributeTexts(hid_t object, const char* name);

/// The first of them.
std::string attributeText(hid_t object, const char* name);

/// A text of which each letter is an entry of its own, as Imaris has them; of other texts the first.
std::string attributeLetters(hid_t object, const char* name);

/// Whole or floating-point numbers, which `long double` holds exactly.
std::vector<long double> attributeNumbers(hid_t object, const char* name);

/// Whether its numbers are floating-point ones of 32 bits or fewer.
bool isSingleAttribute(hid_t object, const char* name);

/// The attribute DIMENSION_LIST: for each dimension of an array the arrays of coordinates that are attached to it.
std::vector<std::vector<Hdf5Id>> dimensionScales(hid_t array);

} // namespace tetra
