// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

struct Actions;
class ValuePick;
class Viewport;

/// A right click in the picture picks the value there and opens menu.picture: what can be made of the value, where to
/// look from, and what becomes of the picture. The actions are those of the window's menus.
void givePictureMenu(Viewport& viewport, ValuePick& pick, const Actions& actions);

} // namespace tetra
