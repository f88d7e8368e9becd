// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"

#include <tan/view.h>

#include <string>
#include <vector>

namespace tetra {

/// Round numbers in [least, largest], rising, evenly spaced by 1, 2 or 5 times a power of ten, at most `most`; none if
/// the range is empty or not finite.
std::vector<double> niceTicks(double least, double largest, int most);

/// The largest of 1, 2 and 5 times a power of ten that is not above `length`; 0 if that is not positive and finite.
double niceLength(double length);

/// Numbers with these signs, all with as many decimals as tell them apart; in powers of ten where they are very large
/// or very small.
std::vector<std::string> tickTexts(const std::vector<double>& values, const NumberSigns& signs = {});

/// One round number as it is, whatever stands beside it: with the digits that it needs, at most twelve significant
/// ones; in powers of ten where it is very large or very small.
std::string ownText(double value, const NumberSigns& signs = {});

/// One number, with the digits that it needs, at most so many significant ones.
std::string shortNumber(double value, const NumberSigns& signs = {}, int digits = 4);

/// A number as it was asked for; one too large to be plain in powers of ten; automatic: as ownText().
std::string formattedNumber(double value, const NumberFormat& format, const NumberSigns& signs = {});

/// A number that stands among these ticks: with a digit more than they have, so that it is seen where between them it
/// lies, and at least four significant ones; no more than it needs.
std::string numberAmong(double value, const std::vector<double>& ticks, const NumberSigns& signs = {});

} // namespace tetra
