// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace tetra {

/// What a key (Qt::Key) does on the scale of accuracies: arrows step, page keys step wider, Home and End go to its
/// ends.
std::optional<double> accuracyByKey(double percent, int key);

} // namespace tetra
