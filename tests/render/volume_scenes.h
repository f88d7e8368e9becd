// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/core/render/volume/ray_integrator.h"
#include "tests/core/render/volume/volume_meshes.h"
#include "tests/render/scenes.h"

#include <tan/render.h>

#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <cstdint>
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
inline SceneParts volumeScene(const TetrahedralMesh& mesh, const TransferFunction& function)
{
    SceneParts scene;
    scene.volume = volumeOf(volumeMeshOf(mesh), function);
    scene.bounds = scene.volume->mesh->bounds;
    return scene;
}

/// An isosurface without normals, which looks the same from all sides: what such a colour is lit to.
inline IsoLayer addLayer(SceneParts& scene, double isovalue, const Colour& colour, float opacity)
{
    const TetrahedralMesh& mesh = *scene.volume->mesh->mesh;
    auto surface = extractIsosurface(mesh, vertexGradients(mesh), isovalue);
    if (!surface)
        qFatal("%s", surface.error().text().c_str());
    std::ranges::fill(surface->normals, Eigen::Vector3f::Zero());
    scene.surfaces.push_back({std::make_shared<const TriangleMesh>(std::move(surface).value()), colour, opacity});
    const Colour lit = facing(colour);
    return {isovalue, {lit.red, lit.green, lit.blue}, opacity};
}

/// One of volumeFunctions() for the values and the size of a mesh.
inline NamedFunction functionFor(const TetrahedralMesh& mesh, const std::string& name)
{
    const auto [low, high] = std::ranges::minmax(mesh.values);
    Eigen::AlignedBox3d bounds;
    for (const auto& position : mesh.positions)
        bounds.extend(position);
    const auto functions = volumeFunctions(low, high, bounds.diagonal().norm() / 10);
    return *std::ranges::find(functions, name, &NamedFunction::name);
}

inline std::uint8_t toByte(double channel)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0, 1.0) * 255));
}

inline double valueAt(const TetrahedralMesh& mesh, double share)
{
    const auto [low, high] = std::ranges::minmax(mesh.values);
    return std::lerp(double(low), double(high), share);
}

/// A cube [0, 4]^3 of half a unit of optical depth a unit of length, in one colour.
inline SceneParts fogCube(float opacityOfUnit)
{
    const TetrahedralMesh mesh = latticeMesh(4, 4, Split::Six, [](const Eigen::Vector3d&) { return 0.5; });
    return volumeScene(mesh, transferFunctionFromPoints({{0, {1, 0.5f, 0}, opacityOfUnit}}));
}

/// From far before its middle, so that all rays through it are as long.
inline Camera beforeCube()
{
    Camera camera;
    camera.perspective = false;
    camera.target = {2, 2, 2};
    camera.distance = 8;
    camera.azimuth = 0;
    camera.elevation = 0;
    return camera;
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

} // namespace tetra::testing
