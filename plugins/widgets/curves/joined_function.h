// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace tetra {

/// A transfer function whose two curves have their points at the same values, for an editor that shows both as one
/// (R18). Edits take and give it as a value; each edit of one whose separated() form checkTransferFunction() accepts
/// gives another such one. A point is named by its index; one that does not exist changes nothing.
struct JoinedFunction {
    std::vector<TransferPoint> points; ///< as of both curves: ascending, at most two of one value
    double unitDistance = 1;
    std::optional<TransferMask> mask{};
    bool operator==(const JoinedFunction&) const = default;
};

/// Looks the same; where only one curve has a point, the other gets one. O(points log points).
JoinedFunction joined(const TransferFunction& function);
/// joined(separated(function)) is `function`, to the bit. O(points).
TransferFunction separated(const JoinedFunction& function);

/// A function and which of its points the edit was about.
struct EditedPoint {
    JoinedFunction function;
    std::size_t point = 0;
};

/// Adds a point without changing how values look. Nothing if two points have the value already, or it is not finite.
std::optional<EditedPoint> withPoint(const JoinedFunction& function, double value);

/// Whether the point is a side of a step.
bool isOnStep(const JoinedFunction& function, std::size_t point);
/// Makes the point a step with two equal sides, and names the lower one. A step stays as it is.
EditedPoint withStep(const JoinedFunction& function, std::size_t point);
/// The step made a point again, which looks as this side did.
EditedPoint withoutStep(const JoinedFunction& function, std::size_t point);

} // namespace tetra
