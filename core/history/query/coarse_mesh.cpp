// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/coarse_mesh.h"

#include "core/history/site_positions.h"

#include <tan/query.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace tetra {

namespace {

constexpr double extractionEnd = 0.3; ///< how far it is when the mesh is there

Error notLoaded(const Model& model, MeshLoading loading)
{
    if (loading == MeshLoading::Cancelled)
        return cancelledError(Message::marked("Extracting the mesh"));
    if (loading == MeshLoading::NoMesh)
        return inconsistentModel(model, Message::say("its coarse tetrahedra do not fit together"));
    return {ErrorKind::WrongUsage, Message::say("'%1' was not made by inserting points into Delaunay meshes, so points "
                                                "cannot be inserted now. Use a closed set, or the automatic choice.",
                                                model.path().string())};
}

} // namespace

Result<TetrahedralMesh> extractLevel(const Model& model, std::uint32_t sites, const Progress& progress,
                                     TetrahedralMesh reuse)
{
    auto mesh = extractPrefix(model, sites, progress, std::move(reuse));
    if (!mesh && mesh.error().kind == ErrorKind::WrongUsage)
        return inconsistentModel(model, Message::say("a level of accuracy has no mesh of its own"));
    return mesh;
}

Status loadCoarse(const Model& model, std::uint32_t sites, const Progress& progress, CoarseMesh& coarse,
                  LocalDelaunay& delaunay)
{
    Result<TetrahedralMesh> mesh = extractLevel(model, sites, progress.part(0, extractionEnd), std::move(coarse.mesh));
    if (!mesh)
        return mesh.error();
    coarse.mesh = *std::move(mesh);
    turnToPhysicalSpace(model, coarse.mesh.tetrahedra); // which turns back, too
    if (!model.check(model.points().first(sites)))
        return model.checkIntact();
    coarse.points.resize(sites);
    std::ranges::transform(model.points().first(sites), coarse.points.begin(),
                           [&](std::uint32_t point) { return delaunay.lattice().pointAt(point); });
    progress.report(extractionEnd, Message::marked("Examining the mesh"));
    const MeshLoading loading = delaunay.load(coarse.mesh.tetrahedra, coarse.points, progress);
    return loading == MeshLoading::Done ? Status() : notLoaded(model, loading);
}

void writeRefined(const Model& model, const TetrahedralMesh& coarse, const LocalDelaunay& delaunay,
                  std::span<const std::uint32_t> addedSites, ExtractedMesh& out)
{
    delaunay.copyTetrahedra(out.mesh.tetrahedra);
    turnToPhysicalSpace(model, out.mesh.tetrahedra);
    const std::size_t before = coarse.positions.size();
    const std::size_t count = before + addedSites.size();
    out.mesh.positions.resize(count);
    out.mesh.values.resize(count);
    out.sites.resize(count);
    std::ranges::copy(coarse.positions, out.mesh.positions.begin());
    std::ranges::copy(coarse.values, out.mesh.values.begin());
    std::iota(out.sites.begin(), out.sites.begin() + before, 0u);
    std::ranges::copy(addedSites, out.sites.begin() + before);
    out.points.clear();
    if (std::ranges::find(addedSites, ExtractedMesh::noSite) != addedSites.end()) {
        out.points.assign(count, ExtractedMesh::noSite);
        for (std::size_t i = 0; i < addedSites.size(); ++i)
            if (addedSites[i] == ExtractedMesh::noSite)
                out.points[before + i] = delaunay.lattice().index(delaunay.added()[i]);
    }
    out.wholeSites = static_cast<std::uint32_t>(count);
    out.wholeTetrahedra = out.mesh.tetrahedra.size();
    out.scale = 1;
    out.reached.reset();
    out.method = VariableMethod::Insertion;
}

Error focusTooLarge()
{
    return {ErrorKind::OutOfResource,
            Message::say("The mesh of the focus became too large. Choose a larger error or a smaller focus.")};
}

} // namespace tetra
