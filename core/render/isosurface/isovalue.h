// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

/// One isosurface to show (R19).
struct Isovalue {
    double value = 0;                            ///< in units of the data
    float red = 0.9f, green = 0.6f, blue = 0.2f; ///< sRGB, [0, 1]
    float opacity = 1;                           ///< (0, 1]
    bool visible = true;
    bool operator==(const Isovalue&) const = default;
};

} // namespace tetra
