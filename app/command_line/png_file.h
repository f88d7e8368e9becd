// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/render.h>

#include <filesystem>

class QImage;

namespace tetra {

/// Writes a picture as PNG, safely (FileWriter).
Status writePng(const std::filesystem::path& path, const Picture& picture);
Status writePng(const std::filesystem::path& path, const QImage& image);

} // namespace tetra
