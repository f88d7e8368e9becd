// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPushButton;
class QWidget;

namespace tetra {

/// A dialog that is shown again begins anew: its first control has the keys, and Enter presses `meant`. Else the button
/// that was used last would have both.
void focusFirst(QWidget& dialog, QPushButton& meant);

} // namespace tetra
