// SPDX-License-Identifier: GPL-3.0-or-later
// query_at_accuracy MODEL.tan PERCENT: the mesh whose error is nowhere above so much of the value range, and its size
// without a window and within one.
#include <tan/query.h>

#include <cstdlib>
#include <iostream>

int main(int count, char** arguments)
{
    if (count != 3) {
        std::cerr << "usage: query_at_accuracy MODEL.tan PERCENT\n";
        return 2;
    }
    const auto model = tetra::Model::open(arguments[1]);
    if (!model) {
        std::cerr << model.error().text() << '\n';
        return 1;
    }
    tetra::MeshExtractor extractor(*model);
    tetra::MeshQuery query;
    query.error = std::strtod(arguments[2], nullptr);
    const Eigen::AlignedBox3d& bounds = (*model)->description().bounds;
    for (const bool windowed : {false, true}) {
        if (windowed) // the first eighth of the domain
            query.window = tetra::Window{{bounds.min(), bounds.center()}};
        const auto mesh = extractor.extract(query);
        if (!mesh) {
            std::cerr << mesh.error().text() << '\n';
            return 1;
        }
        std::cout << (*mesh)->mesh.positions.size() << " vertices, " << (*mesh)->mesh.tetrahedra.size() << " tetrahedra"
                  << (windowed ? " in the window\n" : "\n");
    }
    const tetra::MeshSize size = tetra::meshSizeAt(**model, {.error = std::strtod(arguments[2], nullptr)});
    std::cout << "an error of " << size.error << " % at most\n";
}
