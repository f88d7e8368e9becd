// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/rendering_scenes.h"

#include "plugins/samples/samples.h"
#include "tests/core/refine/plot3d_data.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// The points of a grid, x fastest, and its cells cut into five tetrahedra each, mirrored in every other.
TetrahedralMesh cutInFive(const std::array<std::uint32_t, 3>& size, std::vector<Eigen::Vector3d> positions,
                          std::vector<float> values)
{
    TetrahedralMesh mesh;
    for (const Eigen::Vector3d& position : positions)
        mesh.positions.push_back(position);
    mesh.values.assign(values.begin(), values.end());
    const auto add = [&](std::array<std::uint32_t, 4> cell) {
        const auto edge = [&](std::size_t corner) -> Eigen::Vector3d {
            return positions[cell[corner]] - positions[cell[0]];
        };
        if (edge(1).dot(edge(2).cross(edge(3))) < 0)
            std::swap(cell[2], cell[3]);
        mesh.tetrahedra.push_back(cell);
    };
    for (std::uint32_t k = 0; k + 1 < size[2]; ++k)
        for (std::uint32_t j = 0; j + 1 < size[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < size[0]; ++i) {
                std::array<std::uint32_t, 8> c{};
                for (std::uint32_t bits = 0; bits < 8; ++bits)
                    c[bits] = ((k + (bits >> 2)) * size[1] + j + (bits >> 1 & 1)) * size[0] + i + (bits & 1);
                const std::size_t flip = (i + j + k) % 2;
                add({c[0 ^ flip], c[3 ^ flip], c[5 ^ flip], c[6 ^ flip]});
                for (const std::size_t corner : {1u, 2u, 4u, 7u})
                    add({c[corner ^ flip], c[corner ^ 1 ^ flip], c[corner ^ 2 ^ flip], c[corner ^ 4 ^ flip]});
            }
    return mesh;
}

TetrahedralMesh cubeOf(const RowFunction& signal, std::uint32_t size)
{
    std::vector<Eigen::Vector3d> positions;
    std::vector<float> values;
    std::vector<double> row(size);
    for (std::uint32_t k = 0; k < size; ++k)
        for (std::uint32_t j = 0; j < size; ++j) {
            signal(j, k, row);
            for (std::uint32_t i = 0; i < size; ++i) {
                positions.emplace_back(i, j, k);
                values.push_back(static_cast<float>(row[i]));
            }
        }
    return cutInFive({size, size, size}, std::move(positions), std::move(values));
}

/// Blue, cyan, green, yellow, red, and opacity that rises faster and faster; both linear between their own points.
TransferFunction colourful(float smallest, float largest, double unitDistance)
{
    std::vector<TransferPoint> points{{0, {0, 0, 1}, 0},         {0.05, {0, 0.2f, 1}, 0.02f}, {0.2, {0, 0.8f, 1}, 0.1f},
                                      {0.25, {0, 1, 1}, 0.125f}, {0.5, {0, 1, 0}, 0.25f},     {0.75, {1, 1, 0}, 0.525f},
                                      {1, {1, 0, 0}, 0.8f}};
    for (TransferPoint& point : points)
        point.value = std::lerp(double(smallest), double(largest), point.value);
    return transferFunctionFromPoints(points, unitDistance);
}

/// Our cameras have z up, VTK's y: turned like this, both show the same by default.
void turnUp(TetrahedralMesh& mesh)
{
    for (Eigen::Vector3d& position : mesh.positions)
        position = {position.x(), -position.z(), position.y()};
}

RenderingScene sceneOf(const QString& name, TetrahedralMesh mesh, int frames)
{
    turnUp(mesh);
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& position : mesh.positions)
        bounds.extend(Eigen::Vector3d(position.cast<double>()));
    const auto [smallest, largest] = std::ranges::minmax(mesh.values);
    RenderingScene scene;
    scene.name = name;
    scene.function = colourful(smallest, largest, bounds.diagonal().norm() / 40);
    scene.mesh = std::make_shared<const TetrahedralMesh>(std::move(mesh));
    for (Camera camera = fitted({}, bounds); std::ssize(scene.cameras) < frames; camera = turned(camera, 7, 0))
        scene.cameras.push_back(camera);
    return scene;
}

} // namespace

std::vector<BenchMesh> benchMeshes(std::uint32_t cells)
{
    std::vector<BenchMesh> meshes;
    const auto add = [&](const QString& name, TetrahedralMesh mesh) {
        meshes.push_back({name, std::make_shared<const TetrahedralMesh>(std::move(mesh))});
    };
    if (const auto bluntFin = readPlot3d("bluntfin"))
        add("BluntFin", cutInFive(bluntFin->size, bluntFin->positions, bluntFin->values));
    add(QString("C60 %1^3").arg(cells), cubeOf(c60Density(cells + 1), cells + 1));
    add(QString("Marschner-Lobb %1^3").arg(cells), cubeOf(marschnerLobbSignal(cells + 1), cells + 1));
    return meshes;
}

std::vector<RenderingScene> renderingScenes(std::uint32_t cells, int frames)
{
    std::vector<RenderingScene> scenes;
    if (const auto bluntFin = readPlot3d("bluntfin"))
        scenes.push_back(sceneOf("BluntFin", cutInFive(bluntFin->size, bluntFin->positions, bluntFin->values), frames));
    scenes.push_back(
        sceneOf(QString("Marschner-Lobb %1^3").arg(cells), cubeOf(marschnerLobbSignal(cells + 1), cells + 1), frames));
    return scenes;
}

} // namespace tetra
