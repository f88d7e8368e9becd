// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/widgets/curves/selection.h"

#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// The selected points as a text for the clipboard: a transfer function in our own JSON (transfer_text.h).
std::string copyOfSelected(const JoinedFunction& function, const TransferSelection& selection);

/// With the points of a text as copyOfSelected() makes it, which are selected then; the first of them at the value
/// `at`, if there is one. They are as dense as where they come from, whatever the unit distance there. Those that would
/// come to lie on points that are there lie a small part of the limits' extent beside them, and those that no value is
/// left for are left out. The error says what is wrong with the text and where. O(points log points).
Result<EditedSelection> pasted(const JoinedFunction& function, std::string_view text, std::optional<double> at,
                               const TransferLimits& limits);

/// The selected points once more, farther up by a value, and selected there.
EditedSelection duplicated(const JoinedFunction& function, const TransferSelection& selection, double farther,
                           const TransferLimits& limits);

} // namespace tetra
