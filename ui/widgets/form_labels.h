// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tetra {

/// Gives the labels of all form layouts in `parent` the same width, so that their fields begin below each other.
void alignFormLabels(const QWidget& parent);

} // namespace tetra
