// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

#include <QString>

namespace tetra {

/// A value in the user's locale, with as many digits as tell a thousandth of the seen part apart; of logarithms what it
/// is the logarithm of.
QString textOfValue(double value, const TransferLimits& seen, bool ofLogarithms);

/// What is known of a value: the value, opacity, colour and how often it occurs in the mesh. With a swatch, as rich
/// text.
QString readOutOf(const EditorState& state, double value);
/// The same in words.
QString plainReadOutOf(const EditorState& state, double value);

} // namespace tetra
