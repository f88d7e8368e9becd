// SPDX-License-Identifier: GPL-3.0-or-later
// The example of docs/developer/tetrahedral-graphics.md: a ball of fog in a cube of tetrahedra.
#include <tan/render.h>

#include <fstream>

int main(int, char** arguments)
{
    const auto mesh = std::make_shared<tetra::TetrahedralMesh>(); // arrays of positions, values and corners
    mesh->positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2},
                       {2, 0, 2}, {0, 2, 2}, {2, 2, 2}, {1, 1, 1}};
    mesh->values = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    mesh->tetrahedra = {{0, 1, 2, 8}, {3, 2, 1, 8}, {4, 6, 5, 8}, {7, 5, 6, 8}, {0, 2, 4, 8}, {6, 4, 2, 8},
                        {1, 5, 3, 8}, {7, 3, 5, 8}, {0, 4, 1, 8}, {5, 1, 4, 8}, {2, 3, 6, 8}, {7, 6, 3, 8}};
    const tetra::TransferFunction function{
        .colours = {{0.1, {0, 0, 1}}, {1, {1, 0.5f, 0}}}, .opacities = {{0.1, 0}, {1, 0.9f}}, .unitDistance = 1};
    const auto fog = tetra::VolumeCache(mesh).update(function, false);
    if (!fog)
        return 1;

    tetra::Scene scene;
    scene.bounds = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2)};
    scene.drawables.push_back({.id = "fog", .shape = *fog});
    const tetra::PictureOptions options{.width = 320, .height = 240, .background = {0, 0, 0}};
    const auto picture = tetra::makeCpuBackend()->render(scene, tetra::fitted({}, scene.bounds), options);
    if (!picture)
        return 1;

    std::ofstream file(arguments[1], std::ios::binary); // as a PPM file
    file << "P6 " << picture->width << ' ' << picture->height << " 255\n";
    for (const auto& [red, green, blue, alpha] : picture->pixels)
        file << char(red) << char(green) << char(blue);
    return file.good() ? 0 : 1;
}
