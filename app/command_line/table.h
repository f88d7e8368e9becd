// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// Rows of cells as text in columns, aligned to the right, the first row being the heads. Rows have equally many cells.
std::string table(std::vector<std::vector<std::string>> rows);

/// The number with at most `digits` significant digits, whatever the locale: for people, not for programs.
std::string rounded(double number, int digits = 4);

/// "101325.0 to 101325.4": both ends, with as many digits as tell a thousandth of what lies between them apart.
std::string rangeText(double least, double largest);

/// "1.26", a factor that is hardly more than 1 with two digits of the difference.
std::string factorText(double factor);

/// "1.5 MB".
std::string byteText(std::uint64_t bytes);

/// "less than 1 s", "12 s", "4 min 40 s", "2 h 5 min": rounded up.
std::string durationText(double seconds);

} // namespace tetra
