// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tetra {

/// The numbers of a PLOT3D file in text ("formatted"), one after the other.
struct Plot3dText {
    std::vector<double> numbers;
    bool singlePrecision = true; ///< written with at most nine digits each, which is all that single precision has
};

/// Whether a file that begins so is text, its first word a whole number.
bool isPlot3dText(std::span<const std::byte> firstBytes);

/// Whether it is nothing but numbers, first one or three whole ones in a line. (Tables of points have four in each;
/// chemical structures have names in the third line.)
bool looksLikePlot3dText(std::span<const std::byte> firstBytes);

/// All numbers of a text, as Fortran writes them: 1.5D+03, 1.5-103, and 4*0.5 for four that are equal. Memory is
/// bounded by the size of the text. May throw std::bad_alloc. Errors, about "it": something else among the numbers,
/// with its line; an end that may cut the last number; cancelled.
Result<Plot3dText> readPlot3dText(std::span<const std::byte> bytes, const Progress& progress);

} // namespace tetra
