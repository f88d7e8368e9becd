// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QList>
#include <QPolygonF>

namespace tetra {

/// The program's own line icons.
enum class Glyph {
    Open,
    Build,
    Picture,
    Undo,
    Redo,
    Fit,
    Add,
    Remove,
    Close,
    Warning,
    Information,
    Mesh,
    Sphere,
    Box,
    Window,
    Lens
};

/// Drawn when it is painted, so that it is sharp at any size and scale and has the text colour of a light or a dark
/// palette.
QIcon glyphIcon(Glyph glyph);

/// The same of lines on a square of 24 units.
QIcon lineIcon(const QList<QPolygonF>& lines);

/// The program's own sign: a tetrahedron.
QIcon programIcon();

} // namespace tetra
