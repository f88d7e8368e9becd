// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/camera.h"
#include "core/graphics/scene.h"

#include <filesystem>

namespace tetra {

/// A picture to save, in the still resolution.
struct PictureOrder {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    Colour background;
    int width = 0;
    int height = 0;
    std::filesystem::path target;
};

/// Draws with the CPU back end, finely, and writes a PNG file, whole or not at all.
Status writePicture(const PictureOrder& order, const Progress& progress);

} // namespace tetra
