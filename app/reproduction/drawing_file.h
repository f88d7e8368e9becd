// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QSizeF>

#include <filesystem>
#include <functional>
#include <vector>

class QPainter;

namespace tetra {

/// Draws itself into the rectangle from (0, 0) to its size.
using Drawing = std::function<void(QPainter&)>;

/// Both write safely (FileWriter). The PNG has two pixels a unit of the drawing.
Status writeDrawingAsPng(const std::filesystem::path& path, const QSizeF& size, const Drawing& drawing);
Status writeDrawingAsSvg(const std::filesystem::path& path, const QSizeF& size, const Drawing& drawing);

/// Both, "FILE.png" and "FILE.svg"; gives their names.
Result<std::vector<std::filesystem::path>> writeDrawing(const std::filesystem::path& file, const QSizeF& size,
                                                        const Drawing& drawing);

} // namespace tetra
