// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes and surfaces as arrays; isosurfaces, slices and boundaries of meshes; values at places.
#include "binding.h"
#include "opened_model.h"
#include "point_location.h"

#include <tan/mesh.h>
#include <tan/query.h>
#include <tan/render.h>

#include <cmath>
#include <limits>

namespace tetra::python {

namespace {

using Points = py::array_t<double, py::array::c_style>;

/// A surface that a mesh has given.
struct SurfaceOfMesh {
    std::shared_ptr<const TriangleMesh> surface;
};

py::ssize_t sizeOf(const auto& array)
{
    return static_cast<py::ssize_t>(array.size());
}

py::dict factsOf(const MeshOfModel& held)
{
    const ExtractedMesh& mesh = *held.extracted;
    py::dict facts;
    facts["scale"] = mesh.scale;
    facts["whole_sites"] = mesh.wholeSites;
    facts["whole_tetrahedra"] = mesh.wholeTetrahedra;
    facts["kept_tetrahedra"] = mesh.keptTetrahedra;
    facts["method"] = mesh.method == VariableMethod::Insertion ? "insertion" : "closed-set";
    if (mesh.reached)
        facts["reached"] = py::make_tuple(mesh.reached->error, mesh.reached->warping);
    else
        facts["reached"] = py::none();
    return facts;
}

double volume(const MeshOfModel& held)
{
    const TetrahedralMesh& mesh = held.mesh();
    double sum = 0;
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        const auto edge = [&](std::uint32_t to) -> Eigen::Vector3d { return mesh.positions[to] - mesh.positions[a]; };
        sum += edge(b).dot(edge(c).cross(edge(d)));
    }
    return sum / 6;
}

/// Made when it is first asked for; nothing if that was cancelled.
std::shared_ptr<const PointLocation> locationIn(MeshOfModel& held, const Progress& progress)
{
    const auto lock = locked(held.making, progress);
    if (lock && !held.location)
        if (auto made = PointLocation::of(held.mesh(), progress))
            held.location = std::make_shared<const PointLocation>(*std::move(made));
    return held.location;
}

/// The values of places that may lie in the mesh, not a number for those that lie outside.
py::array_t<double> sample(MeshOfModel& held, const Points& places, const py::object& progress)
{
    if (places.ndim() != 2 || places.shape(1) != 3)
        raise({ErrorKind::WrongUsage, Message::say("Places are an array of shape (n, 3).")});
    const auto count = static_cast<std::size_t>(places.shape(0));
    py::array_t<double> values(places.shape(0));
    const double* from = places.data();
    double* to = values.mutable_data();
    const TetrahedralMesh& mesh = held.mesh();
    const auto fill = [&](const Progress& told) -> Status {
        const auto tree = locationIn(held, told);
        for (std::size_t place = 0; tree && place < count; ++place) {
            if (place % 1024 == 0) {
                if (told.cancelled())
                    break;
                told.report(static_cast<double>(place) / static_cast<double>(count), "Sampling");
            }
            const auto found = tree->find(Eigen::Vector3d(from + 3 * place));
            double value = found ? 0 : std::numeric_limits<double>::quiet_NaN();
            for (std::size_t corner = 0; found && corner < 4; ++corner)
                value += found->weights[corner] * mesh.values[mesh.tetrahedra[found->tetrahedron][corner]];
            to[place] = value;
        }
        return told.cancelled() ? Status(cancelledError("Sampling")) : Status();
    };
    finished(progress, fill);
    return values;
}

std::shared_ptr<SurfaceOfMesh> surfaceOf(TriangleMesh surface)
{
    return std::make_shared<SurfaceOfMesh>(SurfaceOfMesh{std::make_shared<const TriangleMesh>(std::move(surface))});
}

std::shared_ptr<SurfaceOfMesh> isosurface(MeshOfModel& held, double value, const py::object& progress)
{
    const auto make = [&](const Progress& told) -> Result<TriangleMesh> {
        std::shared_ptr<const Buffer<Eigen::Vector3f>> gradients;
        {
            const auto lock = locked(held.making, told);
            if (!lock)
                return cancelledError("Extracting");
            if (!held.gradients)
                held.gradients = std::make_shared<const Buffer<Eigen::Vector3f>>(vertexGradients(held.mesh()));
            gradients = held.gradients;
        }
        auto surface = extractIsosurface(held.mesh(), *gradients, value, told);
        if (surface) // the value is the same at each vertex
            surface->values.assign(surface->positions.size(), static_cast<float>(value));
        return surface;
    };
    return surfaceOf(finished(progress, make));
}

std::shared_ptr<SurfaceOfMesh> slice(const MeshOfModel& held, const std::array<double, 3>& normal, double offset,
                                     const py::object& progress)
{
    const HalfSpace plane{Eigen::Vector3d(normal.data()), offset};
    return surfaceOf(
        finished(progress, [&](const Progress& told) { return cutByPlane(held.mesh(), plane, told); }).surface);
}

std::shared_ptr<SurfaceOfMesh> boundary(const MeshOfModel& held, double featureAngle, const py::object& progress)
{
    return surfaceOf(
        finished(progress, [&](const Progress& told) { return extractBoundary(held.mesh(), featureAngle, told); }));
}

void bindSurface(py::module_& module)
{
    py::class_<SurfaceOfMesh, std::shared_ptr<SurfaceOfMesh>>(module, "Surface")
        .def("points",
             [](const SurfaceOfMesh& held) {
                 return viewOf<double>(held.surface->positions.data(), {sizeOf(held.surface->positions), 3},
                                       held.surface);
             })
        .def("normals",
             [](const SurfaceOfMesh& held) {
                 return viewOf<float>(held.surface->normals.data(), {sizeOf(held.surface->normals), 3}, held.surface);
             })
        .def("triangles",
             [](const SurfaceOfMesh& held) {
                 return viewOf<std::uint32_t>(held.surface->triangles.data(), {sizeOf(held.surface->triangles), 3},
                                              held.surface);
             })
        .def("values", [](const SurfaceOfMesh& held) {
            return viewOf<float>(held.surface->values.data(), {sizeOf(held.surface->values)}, held.surface);
        });
}

} // namespace

void bindMeshes(py::module_& module)
{
    bindSurface(module);
    py::class_<MeshOfModel, std::shared_ptr<MeshOfModel>>(module, "Mesh")
        .def("facts", &factsOf)
        .def(
            "points",
            [](const MeshOfModel& held) {
                return viewOf<double>(held.mesh().positions.data(), {sizeOf(held.mesh().positions), 3}, held.extracted);
            })
        .def("values",
             [](const MeshOfModel& held) {
                 return viewOf<float>(held.mesh().values.data(), {sizeOf(held.mesh().values)}, held.extracted);
             })
        .def("tetrahedra",
             [](const MeshOfModel& held) {
                 return viewOf<std::uint32_t>(held.mesh().tetrahedra.data(), {sizeOf(held.mesh().tetrahedra), 4},
                                              held.extracted);
             })
        .def("sites",
             [](const MeshOfModel& held) {
                 return viewOf<std::uint32_t>(held.extracted->sites.data(), {sizeOf(held.extracted->sites)},
                                              held.extracted);
             })
        .def("volume", &volume)
        .def("sample", &sample)
        .def("isosurface", &isosurface)
        .def("slice", &slice)
        .def("boundary", &boundary);
}

} // namespace tetra::python
