// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace tetra {

/// Numbers as the user's locale writes them. Only for reading: files and options use their own, fixed way.
QString countText(std::uint64_t count);
/// "1.5 %"; as many digits as needed, at most three significant ones.
QString percentText(double percent);
/// "0.8 ms", "12 ms", "1.4 s", "3 min 20 s".
QString durationText(double seconds);
/// "12.4 MiB".
QString bytesText(std::uint64_t bytes);
/// Enough digits to tell values apart in a range of this extent.
QString valueText(double value, double extent);
/// A number in this range, an end of it, say: at least six significant digits, and as many as tell a thousandth of the
/// range apart.
QString numberInRange(double value, double least, double largest);
/// What a logarithm to base 10 is of: three significant digits, and as many as tell a thousandth of a range of
/// logarithms of this extent apart.
QString antilogarithmText(double logarithm, double extent);
/// Decimals after the point that resolve a thousandth of `extent`; none for integers over a wide range.
int decimalsFor(double extent);

} // namespace tetra
