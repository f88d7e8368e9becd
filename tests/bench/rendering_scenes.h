// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QString>

#include <memory>
#include <vector>

namespace tetra {

/// What the rendering benchmark draws.
struct RenderingScene {
    QString name;
    std::shared_ptr<const TetrahedralMesh> mesh;
    TransferFunction function;
    std::vector<Camera> cameras; ///< one a frame, 7 degrees apart
};

/// A mesh that isosurfaces and orders are made of.
struct BenchMesh {
    QString name;
    std::shared_ptr<const TetrahedralMesh> mesh;
};

/// C60 and the Marschner-Lobb signal on `cells` cubed cells, each cut in five, and the BluntFin dataset likewise where
/// its files are at hand.
std::vector<BenchMesh> benchMeshes(std::uint32_t cells);

/// The Marschner-Lobb signal on `cells` cubed cells, each cut in five, and the BluntFin dataset likewise where its
/// files are at hand.
std::vector<RenderingScene> renderingScenes(std::uint32_t cells, int frames);

} // namespace tetra
