// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/tool.h"

#include <QFont>
#include <QImage>
#include <QSizeF>

#include <string>
#include <vector>

class QPainter;

namespace tetra {

/// How tools are painted over a picture.
struct ToolInk {
    Camera camera{};
    Colour background{}; ///< lines and texts are dark or light after it, with a rim of it
    QFont font{};
    std::string selected{}; ///< a handle
    std::string hovered{};  ///< likewise
};

/// Paints what a tool shows over a picture of this size, in the painter's units: nothing of what lies behind the eye.
void paintTool(QPainter& painter, const ToolDrawing& drawing, const ToolInk& ink, QSizeF picture);

/// The same over an image, `scale` times as large as in a view of one pixel a unit.
void paintTools(QImage& image, const std::vector<ToolDrawing>& drawings, const ToolInk& ink, double scale);

} // namespace tetra
