// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace tetra {

/// Whether things may glide to their new place: the user has not asked for reduced motion, neither here nor on the
/// desktop.
bool mayGlide(const QWidget& widget);

/// The choice made here, in the user's settings.
bool motionReduced();
void setMotionReduced(bool reduced);

} // namespace tetra
