// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/isosurface.h"
#include "core/graphics/scene.h"
#include "core/graphics/shading.h"
#include "core/graphics/volume/volume_mesh.h"
#include "tests/core/graphics/volume/ray_integrator.h"
#include "tests/core/graphics/volume/volume_meshes.h"

#include <QtGlobal>

#include <algorithm>
#include <memory>

namespace tetra::testing {

inline std::shared_ptr<const VolumeMesh> volumeMeshOf(const TetrahedralMesh& mesh)
{
    return std::make_shared<const VolumeMesh>(makeVolumeMesh(std::make_shared<const TetrahedralMesh>(mesh)).value());
}

inline Volume volumeOf(const std::shared_ptr<const VolumeMesh>& mesh, const TransferFunction& function)
{
    return {mesh, std::make_shared<const VolumeTransfer>(makeVolumeTransfer(*mesh->mesh, function).value())};
}

/// A scene of a mesh's volume.
inline Scene volumeScene(const TetrahedralMesh& mesh, const TransferFunction& function)
{
    Scene scene;
    scene.volume = volumeOf(volumeMeshOf(mesh), function);
    scene.bounds = scene.volume->mesh->bounds;
    return scene;
}

/// An isosurface without normals, which looks the same from all sides: what such a colour is lit to.
inline IsoLayer addLayer(Scene& scene, double isovalue, const Colour& colour, float opacity)
{
    const TetrahedralMesh& mesh = *scene.volume->mesh->mesh;
    auto surface = extractIsosurface(mesh, vertexGradients(mesh), isovalue);
    if (!surface)
        qFatal("%s", surface.error().text.c_str());
    std::ranges::fill(surface->normals, Eigen::Vector3f::Zero());
    scene.surfaces.push_back({std::make_shared<const TriangleMesh>(std::move(surface).value()), colour, opacity});
    const Colour lit = shaded(colour, 1, 1);
    return {isovalue, {lit.red, lit.green, lit.blue}, opacity};
}

/// A camera that shows the mesh from the side.
inline Camera cameraAround(const Eigen::AlignedBox3d& bounds, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, bounds), 0.8);
}

/// The camera with its eye at a place, looking where it looked.
inline Camera withEyeAt(const Camera& camera, const Eigen::Vector3d& place)
{
    Camera result = camera;
    result.target += place - eyePosition(camera);
    return result;
}

} // namespace tetra::testing
