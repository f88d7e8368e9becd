// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace tetra {

/// Whether the text is a chemical XYZ file: a line with the number of atoms, a comment, and a line an atom, with the
/// symbol of its element and its position. Such files share the ending .xyz with tables of points, and have no values.
bool isChemicalStructure(std::string_view text);

} // namespace tetra
