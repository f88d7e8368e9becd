// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QToolButton;

namespace tetra {

/// Checks the button, or not, and colours it: some styles hardly show that a button is down, least of all in dark
/// colours. To be called again when the palette changes.
void showChecked(QToolButton& button, bool checked);

} // namespace tetra
