// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/selection.h"

#include <cstdint>

namespace tetra {

/// Which of several numbers all shall have.
enum class Alignment : std::uint8_t { First, Mean, Least, Largest };

EditedSelection alignOpacities(const JoinedFunction& function, const TransferSelection& selection, Alignment alignment);

/// Two points next to each other made the two sides of a step, at the value of the first, the mean one and so on. Any
/// other selection stays as it is: more than two points cannot have one value.
EditedSelection alignValues(const JoinedFunction& function, const TransferSelection& selection, Alignment alignment);

/// In what follows both sides of a step move along. Where a point would come to lie on one that is not selected, it
/// lies a small part of the limits' extent beside it.

/// The values of the selected points evenly spread from the first to the last.
EditedSelection distributeValues(const JoinedFunction& function, const TransferSelection& selection,
                                 const TransferLimits& limits);

/// The values of the selected points mirrored about the middle between the first and the last.
EditedSelection flipValues(const JoinedFunction& function, const TransferSelection& selection,
                           const TransferLimits& limits);

/// Each opacity as much below 1 as it was above 0.
EditedSelection invertOpacities(const JoinedFunction& function, const TransferSelection& selection);

/// Opacities that go with the value in a straight line from the first selected point to the last.
EditedSelection rampOpacities(const JoinedFunction& function, const TransferSelection& selection);

} // namespace tetra
