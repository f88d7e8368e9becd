// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <functional>

namespace tetra {

/// The size of the mesh whose errors are asked for times a number, which the call makes.
using SizeAtScale = std::function<Result<std::uint64_t>(double scale)>;

/// Looks for the least scale, at least 1, whose mesh has at most `budget` tetrahedra, with a few meshes: ends when one
/// uses nine tenths of the budget or the next would hardly differ. The last mesh made is that of the scale returned.
/// `first`: where to begin. Errors: WrongUsage if no mesh up to `largest` is small enough; sizeAt's.
Result<double> scaleWithin(std::uint64_t budget, double first, double largest, const SizeAtScale& sizeAt);

} // namespace tetra
