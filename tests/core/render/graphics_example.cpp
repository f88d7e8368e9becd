// SPDX-License-Identifier: GPL-3.0-or-later
// The example of docs/tetrahedral-graphics.md: a ball of fog in a cube of tetrahedra.
#include "core/render/volume/volume_renderer.h"

#include <algorithm>
#include <fstream>

int main(int, char** arguments)
{
    tetra::TetrahedralMesh mesh; // arrays of positions, values and corners
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2},
                      {2, 0, 2}, {0, 2, 2}, {2, 2, 2}, {1, 1, 1}};
    mesh.values = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    mesh.tetrahedra = {{0, 1, 2, 8}, {3, 2, 1, 8}, {4, 6, 5, 8}, {7, 5, 6, 8}, {0, 2, 4, 8}, {6, 4, 2, 8},
                       {1, 5, 3, 8}, {7, 3, 5, 8}, {0, 4, 1, 8}, {5, 1, 4, 8}, {2, 3, 6, 8}, {7, 6, 3, 8}};
    const tetra::TransferFunction function{{{0.1, {0, 0, 1}, 0}, {1, {1, 0.5f, 0}, 0.9f}}, 1};
    const tetra::VolumeOptions options{.width = 320, .height = 240};

    const auto volume = tetra::makeVolumeMesh(std::make_shared<const tetra::TetrahedralMesh>(mesh));
    const auto transfer = tetra::makeVolumeTransfer(mesh, function);
    if (!volume || !transfer)
        return 1;
    const tetra::Camera camera = tetra::fitted({}, volume->bounds);
    const auto order = tetra::orderForCamera(*volume, camera, options);
    if (!order)
        return 1;
    const auto picture = tetra::drawVolume(*volume, *transfer, order->cells, camera, options);
    if (!picture)
        return 1;

    std::ofstream file(arguments[1], std::ios::binary); // over black, as a PPM file
    file << "P6 " << picture->width << ' ' << picture->height << " 255\n";
    for (const auto& sample : picture->samples)
        for (std::size_t channel = 0; channel < 3; ++channel)
            file.put(static_cast<char>(std::clamp(sample[channel], 0.0f, 1.0f) * 255));
    return file.good() ? 0 : 1;
}
