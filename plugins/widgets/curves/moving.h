// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/axes.h"
#include "plugins/widgets/curves/selection.h"

#include <cstdint>

namespace tetra {

/// What happens at points that are not selected and in the way.
enum class NeighbourRule : std::uint8_t {
    Stop, ///< the selection stops before them
    Push, ///< they go ahead of it, as far as the limits allow
    Pass  ///< the selection goes past them; points change places
};

/// By how much points move along the axes of values and of opacities, which is what a pointer moves by.
struct SelectionMove {
    double value = 0; ///< a difference of places on its axis (placeOnAxis())
    double height = 0;
    OpacityAxis axis = OpacityAxis::Linear;
    ValueAxis valueAxis = ValueAxis::Linear; ///< by logarithms nothing moves in value unless all values are positive
};

/// The selected points moved. Along the values all move by the same, as much of it as limits and neighbours allow; what
/// lies outside of the limits may come in and go no farther out. In height each goes as far as the axis does. Both
/// sides of a step move along in value, and each has an opacity of its own. Points keep a small distance from each
/// other, so nothing is lost by coming near. Numbers that are not finite count as 0. O(points log points).
///
/// A drag is made of moves of the function as it was when the drag began, so that what stopped on the way does not add
/// up.
EditedSelection moveSelected(const JoinedFunction& function, const TransferSelection& selection,
                             const SelectionMove& move, NeighbourRule rule, const TransferLimits& limits);

/// Moved so that the first selected point has this value, the others by as much.
EditedSelection withValue(const JoinedFunction& function, const TransferSelection& selection, double value,
                          NeighbourRule rule, const TransferLimits& limits);

} // namespace tetra
