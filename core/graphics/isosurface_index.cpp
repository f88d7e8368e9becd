// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/isosurface_index.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace tetra {
namespace {

/// Calls visit(vertex, run) for each corner, on all threads.
template <class Visit> void forEachCorner(const TetrahedralMesh& mesh, Visit&& visit)
{
    const std::size_t count = mesh.tetrahedra.size();
    tbb::parallel_for(std::size_t(0), (count + surfaceRunSize - 1) / surfaceRunSize, [&](std::size_t run) {
        for (std::size_t t = run * surfaceRunSize; t < std::min(count, (run + 1) * surfaceRunSize); ++t)
            for (const std::uint32_t vertex : mesh.tetrahedra[t])
                visit(vertex, static_cast<std::uint32_t>(run));
    });
}

} // namespace

IsosurfaceIndex makeIsosurfaceIndex(const TetrahedralMesh& mesh)
{
    IsosurfaceIndex index;
    index.ranges = chunkRanges(mesh);
    // Whichever run of several comes last, another one sees that it is not alone.
    Buffer<std::uint32_t> runs(mesh.positions.size());
    index.inOneRun.assign(mesh.positions.size(), 1);
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        std::atomic_ref(runs[vertex]).store(run, std::memory_order_relaxed);
    });
    forEachCorner(mesh, [&](std::uint32_t vertex, std::uint32_t run) {
        if (std::atomic_ref(runs[vertex]).load(std::memory_order_relaxed) != run)
            std::atomic_ref(index.inOneRun[vertex]).store(0, std::memory_order_relaxed);
    });
    return index;
}

} // namespace tetra
