// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/queries/error_field.h"

#include <algorithm>

namespace tetra {

/// Of numbers that are not negative, infinity among them. Never decreasing in either of them, also in doubles: so least
/// numbers make a least number.
inline double applied(FieldOperation operation, double first, double second)
{
    switch (operation) {
    case FieldOperation::Sum: return first + second;
    case FieldOperation::Product: return first > 0 && second > 0 ? first * second : 0; // infinity times 0 is 0
    case FieldOperation::Smaller: return std::min(first, second);
    case FieldOperation::Larger: return std::max(first, second);
    }
    return 0;
}

} // namespace tetra
