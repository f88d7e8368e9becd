// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/mesh_cases.h"

#include "tests/bench/vtk_yardstick.h"

#include "core/mesh/spatial_order.h"
#include "core/render/isosurface/isosurface.h"
#include "core/render/order/visibility_order.h"
#include "core/render/volume/volume_mesh.h"

#include <tan/mesh.h>
#include <tan/render.h>

#include <tbb/task_arena.h>

#include <algorithm>

namespace tetra {
namespace {

/// The median seconds of several runs of `work` on so many threads, after one that does not count.
double medianSeconds(int threads, int runs, const std::function<void()>& work)
{
    tbb::task_arena arena(threads);
    std::vector<double> seconds;
    for (int run = 0; run <= runs; ++run) {
        const double one = secondsOn(threads, [&] { arena.execute(work); });
        if (run > 0)
            seconds.push_back(one);
    }
    return median(seconds);
}

QString nameOf(const char* what, const BenchMesh& mesh, int threads)
{
    return QString("%1 %2, %3 thread%4").arg(what, mesh.name).arg(threads).arg(threads == 1 ? "" : "s");
}

} // namespace

std::vector<BenchCase> isosurfaceCases(const BenchMesh& mesh, int runs, bool vtk)
{
    const auto [smallest, largest] = std::ranges::minmax(mesh.mesh->values);
    const double isovalue = (double(smallest) + double(largest)) / 2;
    const TetrahedralMesh ordered = inSpatialOrder(*mesh.mesh).value();
    const auto gradients = vertexGradients(ordered);
    const IsosurfaceIndex index = makeIsosurfaceIndex(ordered);
    const auto crossed =
        std::ranges::count_if(index.ranges, [&](const ChunkRange& range) { return range.crossedAt(isovalue); });
    std::vector<BenchCase> cases;
    for (const int threads : {1, 2}) {
        std::size_t triangles = 0;
        BenchCase one;
        one.name = nameOf("isosurface", mesh, threads);
        one.seconds = medianSeconds(threads, runs, [&] {
            triangles = extractIsosurface(ordered, index, gradients, isovalue).value().triangles.size();
        });
        const double plain = medianSeconds(threads, runs, [&] {
            triangles = extractIsosurface(ordered, gradients, isovalue).value().triangles.size();
        });
        one.more = {{"triangles", double(triangles)},
                    {"chunks_crossed", double(crossed) / double(std::max<std::size_t>(index.ranges.size(), 1))},
                    {"without_index_seconds", plain},
                    {"gradients_seconds", medianSeconds(threads, 3, [&] { vertexGradients(ordered); })},
                    {"index_seconds", medianSeconds(threads, 3, [&] { makeIsosurfaceIndex(ordered); })}};
        const auto yardsticks = vtk ? timeVtkContour(*mesh.mesh, isovalue, runs, threads) : std::map<QString, double>();
        addCompared(one, yardsticks, cases);
    }
    return cases;
}

std::vector<BenchCase> orderCases(const BenchMesh& mesh, int runs)
{
    const double millions = double(mesh.mesh->tetrahedra.size()) / 1e6;
    const auto ordered = std::make_shared<const TetrahedralMesh>(inSpatialOrder(*mesh.mesh).value());
    std::vector<BenchCase> cases;
    for (const int threads : {1, 2}) {
        const auto orderSeconds = [&](const std::shared_ptr<const TetrahedralMesh>& tetrahedra) {
            const VolumeMesh volume = makeVolumeMesh(tetrahedra).value();
            const EyePoint eye{eyePosition(turned(fitted({}, volume.bounds), 33, 11)), true};
            return medianSeconds(threads, runs, [&] { orderByAdjacency(*tetrahedra, volume.adjacency, eye); });
        };
        BenchCase one;
        one.name = nameOf("order", mesh, threads);
        one.seconds = orderSeconds(ordered);
        const double match = medianSeconds(threads, 3, [&] { matchFaces(ordered->tetrahedra); });
        const double matchUnordered = medianSeconds(threads, 3, [&] { matchFaces(mesh.mesh->tetrahedra); });
        const double spatial = medianSeconds(threads, 3, [&] { inSpatialOrder(*mesh.mesh).value(); });
        one.more = {{"million_tetrahedra_per_second", millions / one.seconds},
                    {"as_given_million_tetrahedra_per_second", millions / orderSeconds(mesh.mesh)},
                    {"match_million_tetrahedra_per_second", millions / match},
                    {"match_as_given_million_tetrahedra_per_second", millions / matchUnordered},
                    {"spatial_order_million_tetrahedra_per_second", millions / spatial}};
        cases.push_back(one);
    }
    return cases;
}

} // namespace tetra
