// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"

#include <tan/transfer.h>
#include <tan/view.h>

#include <string>
#include <vector>

namespace tetra {

struct AnnotationContent;

/// The axis of a colour bar.
struct BarAxis {
    TransferLimits ends{};
    bool logarithmic = false; ///< equal steps are equal factors; both ends are positive then
    /// The values are logarithms to base 10: ticks are where what they are of is round, and texts tell that.
    bool ofLogarithms = false;

    /// Where on the axis a value lies, 0 at the smaller end and 1 at the larger one; beyond them outside of [0, 1].
    double shareOf(double value) const;
    /// The inverse, for shares in [0, 1].
    double valueAt(double share) const;
    bool contains(double value) const { return value >= ends.least && value <= ends.largest; }
};

/// From the ends that are chosen, else over the range of the data; logarithmic where the colours follow the logarithm.
/// O(points of the transfer function).
BarAxis barAxisOf(const AnnotationContent& content);

/// Whether the colours between two values go with the logarithm of the value rather than with the value, as those of
/// ParaView's maps over log(value), which are read as many short straight pieces: whether fewer chords between the
/// function's own points are enough over the logarithms. What is straight over the values far enough leaves its chord
/// there, and so do colours that are only crowded at small values. Not of less than a decade, nor if a value is zero or
/// less. O(points).
bool followsLogarithm(const TransferFunction& function, const TransferLimits& ends);

/// Round numbers of the axis, rising, at most `most` (of logarithms, those of round numbers): evenly spaced by values,
/// or on a logarithmic axis of more than one decade powers of ten, with 2 and 5 times them where there is room for all.
std::vector<double> barTicks(const BarAxis& axis, int most);

/// Their texts, which differ unless a format was asked for. On a logarithmic axis each has the digits that it needs
/// itself.
std::vector<std::string> barTickTexts(const BarAxis& axis, const std::vector<double>& ticks,
                                      const NumberSigns& signs = {}, const NumberFormat& format = {});

/// A value's text beside ticks: more precise than the two that it lies between, or in the format that was asked for.
std::string barValueText(const BarAxis& axis, double value, const std::vector<double>& ticks,
                         const NumberSigns& signs = {}, const NumberFormat& format = {});

} // namespace tetra
