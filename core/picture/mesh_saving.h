// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/scene_pipeline.h"
#include "core/picture/surface_making.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>

#include <filesystem>
#include <memory>
#include <optional>
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
Result<FileRemarks> writeMesh(PluginHost& host, const MeshOrder& order, const Progress& progress);

/// Surfaces to save: those of a scene that say so (Drawable::saved).
struct SurfaceOrder {
    SceneRequest scene;
    std::optional<BuiltScene> built; ///< of the request, if that is there already; else it is made
    std::filesystem::path target;
};

/// Isosurfaces of a mesh to save, made for more than to be seen.
struct SolidOrder {
    MeshOrder mesh; ///< of what mesh, and where to
    std::vector<Isovalue> isovalues;
    SurfaceMaking making;
    bool deviation = false; ///< is measured, too
};

/// Writes them with their values and colours, in the format of the file's ending, and says what they are: closed or
/// not, how large, how true. Errors as of saveSurface() and of measureDeviations(), and WrongUsage if no isovalue is
/// visible.
Result<Message> writeSolids(PluginHost& host, const SolidOrder& order, const Progress& progress);

/// Whether a scene has a surface to save.
bool hasSurfaceToSave(const Scene& scene);

/// Writes the surfaces under their labels, with their values and their colours, as far as the format has any; it is
/// that of the file's ending. Errors as of saveSurface(), and WrongUsage if there is no surface to save.
Result<FileRemarks> writeSurfaces(PluginHost& host, const SurfaceOrder& order, const Progress& progress);

} // namespace tetra
