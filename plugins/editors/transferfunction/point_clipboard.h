// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

namespace tetra {

/// The selected points to the clipboard, as text.
void copyPoints(const EditorState& state);
/// Points from there, the first of them at the value `at` if there is one; what is wrong with the text is told.
void pastePoints(EditorState& state, std::optional<double> at);
/// The selected points once more, a little to the right.
void duplicatePoints(EditorState& state);

} // namespace tetra
