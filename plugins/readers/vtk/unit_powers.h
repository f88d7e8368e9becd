// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// A product of units, each to the power at the same place: "kg/(m s^2)". Empty of a quantity without a unit.
std::string unitOfPowers(std::span<const std::string_view> units, std::span<const double> powers);

} // namespace tetra
