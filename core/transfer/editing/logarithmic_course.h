// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/editing/simplification.h"

namespace tetra {

/// Between each two neighbouring selected points as many points more that colour and extinction go with the logarithm
/// of the value, as ParaView's maps over log(value) do, nowhere farther from it than the tolerance. Selected are all of
/// them. The function stays one of straight pieces, which every back end draws exactly, so that this is an edit and no
/// kind of function of its own.
///
/// Over a factor r between two points, n pieces of equal factors q = r^(1/n) deviate by at most e(q) / n of the change,
/// e(q) = ln(x) / ln(q) - (x - 1) / (q - 1) with x = (q - 1) / ln(q); of an opacity not by more than of its optical
/// depth. Points whose values are not positive change nothing between them. O(points).
EditedSelection withLogarithmicCourse(const TransferFunction& function, const TransferSelection& selection,
                                      const LookTolerance& tolerance);

} // namespace tetra
