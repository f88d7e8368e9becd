// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/workbench.h"

namespace tetra {

/// The widget of the editor plugin `id` over the workbench's session. Where the plugin cannot be used, a page named
/// "transfer.missing" says why, and what mends it.
QWidget* makeEditorPage(Workbench& workbench, const std::string& id);

} // namespace tetra
