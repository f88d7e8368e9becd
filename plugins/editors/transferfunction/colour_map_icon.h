// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/colour_map.h"

#include <QIcon>
#include <QString>

namespace tetra {

/// The colours from left to right, in the size of a menu's icons and twice that.
QIcon colourMapIcon(const ColourMap& map);

/// What the map is called in the user's language: names that are known everywhere stay.
QString colourMapName(const std::string& id);

} // namespace tetra
