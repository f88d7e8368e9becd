// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace tetra {

/// A mesh to save, as it is seen.
struct MeshOrder {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const ExtractedMesh> mesh; ///< that is there already; else it is extracted
    MeshQuery query;                           ///< that it answers
    std::filesystem::path target;
};

/// Writes the mesh with its values and the sites of its vertices, and as facts where it is from and what errors it
/// keeps. The format is that of the file's ending. Errors as of saveMesh().
Status writeMesh(PluginHost& host, const MeshOrder& order, const Progress& progress);

/// Isosurfaces to save, of the mesh that is seen or is extracted first.
struct SurfaceOrder {
    MeshOrder mesh;
    std::vector<Isovalue> isovalues; ///< those that are visible are written
};

/// Writes the surfaces with their colours, as far as the format has any; it is that of the file's ending. Errors as of
/// saveSurface(), and WrongUsage if no isovalue is visible.
Status writeSurfaces(PluginHost& host, const SurfaceOrder& order, const Progress& progress);

} // namespace tetra
