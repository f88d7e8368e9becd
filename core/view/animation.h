// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/view.h>

namespace tetra {

// How the keys of a film are edited, beside withKey() in tan/view.h. What is no key's index changes nothing.

TAN_INTERNAL Animation withoutKey(Animation animation, int index);
/// With the key at another time; it stands where that belongs. The time moves to the nearest that is free.
TAN_INTERNAL Animation withKeyAt(Animation animation, int index, double time);
/// With the contents of two neighbours exchanged, their times left: the key moves by one (steps -1 or 1).
TAN_INTERNAL Animation withKeyMoved(Animation animation, int index, int steps);

} // namespace tetra
