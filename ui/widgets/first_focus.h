// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tetra {

/// Gives the keys to the first control of a dialog that is shown again: else the last one that was used would have
/// them, and Enter would press it if it is a button.
void focusFirst(QWidget& dialog);

} // namespace tetra
