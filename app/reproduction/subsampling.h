// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

namespace tetra {

/// Every step-th sample of a regular dataset along each axis, from the first. Error: fewer than two would be left along
/// an axis, or not enough memory.
Result<Dataset> subsampled(const Dataset& dataset, std::uint32_t step);

} // namespace tetra
