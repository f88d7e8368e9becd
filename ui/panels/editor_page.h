// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

namespace tetra {

class ValuePick;

/// The widget of an editor plugin over the workbench's session and what is picked in the picture. Where the plugin
/// cannot be used, a page named ID.missing says why, and what repairs it. Where the mode has nothing of the type,
/// ID.hint says so above the widget, which is disabled then: but for transfer functions, of which there always is one.
QWidget* makeEditorPage(Workbench& workbench, ValuePick& pick, const std::string& id, const std::string& type);

} // namespace tetra
