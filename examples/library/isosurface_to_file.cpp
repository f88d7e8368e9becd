// SPDX-License-Identifier: GPL-3.0-or-later
// isosurface_to_file MODEL.tan PERCENT ISOVALUE SURFACE.obj: an isosurface of the mesh of this error, as Wavefront OBJ.
#include <tan/query.h>
#include <tan/render.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

int failed(const tetra::Error& error)
{
    std::cerr << error.text() << '\n';
    return 1;
}

void writeObj(const tetra::TriangleMesh& surface, std::ostream& file)
{
    for (const Eigen::Vector3d& place : surface.positions)
        file << "v " << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
    for (const Eigen::Vector3f& normal : surface.normals)
        file << "vn " << normal.x() << ' ' << normal.y() << ' ' << normal.z() << '\n';
    for (const auto& [a, b, c] : surface.triangles) // OBJ counts from 1
        file << "f " << a + 1 << "//" << a + 1 << ' ' << b + 1 << "//" << b + 1 << ' ' << c + 1 << "//" << c + 1
             << '\n';
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 5) {
        std::cerr << "usage: isosurface_to_file MODEL.tan PERCENT ISOVALUE SURFACE.obj\n";
        return 2;
    }
    const auto model = tetra::Model::open(arguments[1]);
    if (!model)
        return failed(model.error());
    tetra::MeshQuery query;
    query.error = std::strtod(arguments[2], nullptr);
    const auto extracted = tetra::MeshExtractor(*model).extract(query);
    if (!extracted)
        return failed(extracted.error());
    const tetra::TetrahedralMesh& mesh = (*extracted)->mesh;
    const auto surface =
        tetra::extractIsosurface(mesh, tetra::vertexGradients(mesh), std::strtod(arguments[3], nullptr));
    if (!surface)
        return failed(surface.error());
    std::ofstream file(arguments[4]);
    writeObj(*surface, file);
    std::cout << surface->triangles.size() << " triangles\n";
    return file.good() ? 0 : 1;
}
