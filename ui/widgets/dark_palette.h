// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

namespace tetra {

/// The colours of a dark desktop, for pictures of the window: the program itself takes those of the desktop.
QPalette darkPalette();

} // namespace tetra
