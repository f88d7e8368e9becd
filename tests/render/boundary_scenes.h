// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/render/holed_mesh.h"
#include "tests/core/render/scene_parts.h"

#include <tan/render.h>

#include <QString>
#include <QtGlobal>

namespace tetra::testing {

inline TransferFunction boundaryFunction()
{
    return transferFunctionFromPoints({{-1, {0.1f, 0.2f, 0.8f}, 0.05f},
                                       {0.5, {0.9f, 0.9f, 0.4f}, 0.3f},
                                       {0.5, {0.1f, 0.7f, 0.3f}, 0.1f},
                                       {3, {0.8f, 0.1f, 0.1f}, 0.6f}},
                                      0.5);
}

/// The boundary of a mesh with holes, alone or in its volume: "translucent", "values", "far side", "faint values".
inline SceneParts boundaryScene(unsigned seed, const QString& look, bool withVolume)
{
    const auto mesh = std::make_shared<const TetrahedralMesh>(holedMesh(seed));
    BoundaryCache maker(mesh);
    BoundaryLook wanted;
    wanted.opacity = look == "translucent" ? 0.3f : look == "faint values" ? 0.5f : 1;
    wanted.backFacesOnly = look == "far side" || look == "faint values";
    const auto surface = look == "translucent" ? maker.plain(wanted) : maker.coloured(boundaryFunction(), wanted);
    if (!surface)
        qFatal("%s", surface.error().text().c_str());
    SceneParts scene;
    scene.bounds = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2)};
    scene.surfaces.push_back(*surface);
    if (!withVolume)
        return scene;
    auto volume = VolumeCache(mesh).update(boundaryFunction(), false);
    if (!volume)
        qFatal("%s", volume.error().text().c_str());
    scene.volume = *std::move(volume);
    return scene;
}

inline Camera boundaryCamera(const SceneParts& scene, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, scene.bounds), 0.9);
}

} // namespace tetra::testing
