// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

namespace tetra {

/// Asks for the values of the first and the last point, and spreads the function over them. Lets the window work on;
/// `state` outlives `parent`.
void askForRange(EditorState& state, QWidget* parent);

} // namespace tetra
