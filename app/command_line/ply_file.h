// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/graphics/scene.h"

#include <filesystem>
#include <span>

namespace tetra {

/// The surface where the field has one value.
struct ValuedSurface {
    double value = 0;
    TriangleMesh mesh;
};

/// Writes surfaces into one binary little-endian PLY file, safely (FileWriter). Each vertex has x, y, z, the normal
/// nx, ny, nz and the isovalue as "value", all float; each face is a list of three int indices.
Status writePly(const std::filesystem::path& path, std::span<const ValuedSurface> surfaces, const Progress& progress);

} // namespace tetra
