// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/core/render/volume/volume_meshes.h"
#include "tests/render/picture_check.h"
#include "tests/render/scenes.h"

#include <tan/render.h>

#include <QString>

#include <algorithm>
#include <cmath>

namespace tetra::testing {

inline const std::vector<NamedMesh>& meshes()
{
    static const std::vector<NamedMesh> all = volumeMeshes();
    return all;
}

inline std::vector<NamedFunction> functionsFor(const VolumeMesh& mesh)
{
    const auto [low, high] = std::ranges::minmax(mesh.mesh->values);
    return volumeFunctions(low, high, mesh.bounds.diagonal().norm() / 10);
}

inline Volume volumeOf(const TetrahedralMesh& tetrahedra, const std::string& functionName)
{
    auto mesh = makeVolumeMesh(std::make_shared<const TetrahedralMesh>(tetrahedra));
    if (!mesh)
        qFatal("%s", mesh.error().text().c_str());
    const auto functions = functionsFor(*mesh);
    const auto function = std::ranges::find(functions, functionName, &NamedFunction::name);
    auto transfer = makeVolumeTransfer(tetrahedra, function->function);
    if (!transfer)
        qFatal("%s", transfer.error().text().c_str());
    return {std::make_shared<VolumeMesh>(std::move(*mesh)), std::make_shared<VolumeTransfer>(std::move(*transfer))};
}

inline Volume volumeNamed(const std::string& meshName, const std::string& functionName)
{
    return volumeOf(std::ranges::find(meshes(), meshName, &NamedMesh::name)->mesh, functionName);
}

inline SceneParts sceneNamed(const QString& meshName, const QString& functionName)
{
    SceneParts scene;
    scene.volume = volumeNamed(meshName.toStdString(), functionName.toStdString());
    scene.bounds = scene.volume->mesh->bounds;
    return scene;
}

inline Camera cameraFor(const SceneParts& scene, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, scene.bounds), 0.8);
}

/// Surfaces in and around the volume.
inline void addSurfaces(SceneParts& scene, const QString& which)
{
    const Eigen::Vector3d centre = scene.bounds.center();
    const Eigen::Vector3d size = scene.bounds.sizes();
    const float radius = size.minCoeff() / 3;
    if (which == "opaque")
        scene.surfaces.push_back({sphere(centre, radius, 60), {0.9f, 0.6f, 0.1f}, 1});
    if (which == "translucent") {
        scene.surfaces.push_back({sphere(centre, radius, 40), {0.9f, 0.2f, 0.1f}, 0.4f});
        scene.surfaces.push_back({sphere(centre + 0.2f * size, radius, 40), {0.1f, 0.4f, 0.9f}, 0.6f});
        scene.surfaces.push_back({sphere(centre - 0.3f * size, radius / 2, 40), {0.1f, 0.9f, 0.2f}, 1});
    }
    if (which == "crossing") {
        const auto sheet = [&](const Eigen::Vector3d& along, const Eigen::Vector3d& across, const Colour& colour) {
            scene.surfaces.push_back({quad(centre - (along + across) / 2, along, across), colour, 0.5f});
        };
        sheet({2 * size.x(), 0, 0}, {0, size.y(), size.z()}, {1, 0, 0});
        sheet({2 * size.x(), 0, 0}, {0, -size.y(), size.z()}, {0, 0, 1});
    }
    if (which == "isosurfaces") {
        const TetrahedralMesh& mesh = *scene.volume->mesh->mesh;
        const auto gradients = vertexGradients(mesh);
        const auto [low, high] = std::ranges::minmax(mesh.values);
        for (const float share : {0.3f, 0.6f}) {
            auto surface = extractIsosurface(mesh, gradients, std::lerp(low, high, share));
            if (!surface)
                qFatal("%s", surface.error().text().c_str());
            scene.surfaces.push_back(
                {std::make_shared<TriangleMesh>(std::move(*surface)), {0.9f, share, 0.1f}, 0.8f - share});
        }
    }
}

/// Cubes one behind the other along y, of `count` * 6 cells.
inline TetrahedralMesh column(std::uint32_t count)
{
    TetrahedralMesh mesh;
    for (std::uint32_t j = 0; j <= count; ++j)
        for (const auto& [x, z] : {std::array{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            const float y = static_cast<float>(j) / static_cast<float>(count);
            mesh.positions.emplace_back(static_cast<float>(x), y, static_cast<float>(z));
            mesh.values.push_back(y);
        }
    for (std::uint32_t j = 0; j < count; ++j)
        for (const auto& [a, b] : {std::array{1u, 5u}, {5u, 4u}, {4u, 6u}, {6u, 2u}, {2u, 3u}, {3u, 1u}})
            mesh.tetrahedra.push_back({4 * j, 4 * j + b, 4 * j + a, 4 * j + 7}); // around the diagonal from 0 to 7
    return mesh;
}

/// The part of the pixels that are not `colour`: something is seen there.
inline double shareOfOther(const Picture& picture, const std::array<std::uint8_t, 4>& colour)
{
    const auto same = std::ranges::count(picture.pixels, colour);
    return 1 - static_cast<double>(same) / static_cast<double>(picture.pixels.size());
}

} // namespace tetra::testing
