// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>
#include <tan/transfer.h>

#include <vector>

namespace tetra {

/// What lies between two looks, for `part` in [0, 1]: linear, continuous in `part`, exactly the first at 0 and the
/// second at 1, and the same throughout if both are.

/// Functions of as many points: the points move. Otherwise colour and extinction of each value are between those of the
/// two functions, whose points the result has together. Both pass checkTransferFunction(), and so does the result.
/// O(points).
TransferFunction blended(const TransferFunction& first, const TransferFunction& second, double part);

/// The surfaces of both lists are paired in their order; one without a partner, or hidden in the other list, appears or
/// disappears by its opacity, at the value that it has where it is seen.
std::vector<Isovalue> blended(const std::vector<Isovalue>& first, const std::vector<Isovalue>& second, double part);

} // namespace tetra
