// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_mesh.h"

#include "core/verify/findings.h"
#include "core/verify/lattice_cells.h"
#include "core/verify/scattered_cells.h"
#include "core/verify/verify_irregular.h"
#include "core/verify/verify_parts.h"

#include <algorithm>
#include <new>
#include <optional>

namespace tetra {

namespace {

using Cell = LevelCells::Cell;

/// Whether arrays and indices fit each other, so that they can be followed.
bool isWellFormed(const ExtractedMesh& mesh, std::vector<std::string>& failures)
{
    const std::size_t vertices = mesh.mesh.positions.size();
    if (vertices == 0 || mesh.mesh.tetrahedra.empty()) {
        failures.emplace_back("The mesh is empty.");
        return false;
    }
    if (mesh.mesh.values.size() != vertices || mesh.sites.size() != vertices) {
        failures.push_back("The mesh has " + std::to_string(vertices) + " vertices, " +
                           std::to_string(mesh.mesh.values.size()) + " values and " +
                           std::to_string(mesh.sites.size()) + " numbers of sites.");
        return false;
    }
    const auto outside = std::ranges::find_if(mesh.mesh.tetrahedra, [&](const Cell& cell) {
        return std::ranges::any_of(cell, [&](std::uint32_t vertex) { return vertex >= vertices; });
    });
    if (outside == mesh.mesh.tetrahedra.end())
        return true;
    failures.push_back("Tetrahedron " + std::to_string(outside - mesh.mesh.tetrahedra.begin()) +
                       " has a corner beyond the last vertex.");
    return false;
}

/// The cells, positive in the space that the mesh was made in.
std::vector<Cell> cellsOf(const Model& model, const ExtractedMesh& mesh)
{
    std::vector<Cell> cells(mesh.mesh.tetrahedra.begin(), mesh.mesh.tetrahedra.end());
    if (model.description().leftHanded)
        for (Cell& cell : cells)
            std::swap(cell[2], cell[3]);
    return cells;
}

std::vector<LatticePoint> placesOf(const Dataset& original, const std::vector<std::uint32_t>& points)
{
    std::vector<LatticePoint> places;
    places.reserve(points.size());
    for (const std::uint32_t point : points) {
        const auto c = original.lattice.coordinates(point);
        places.push_back({c[0], c[1], c[2]});
    }
    return places;
}

Result<LevelReport> verifyWhole(const Model& model, const Dataset& original, const MeshQuery& query,
                                const ExtractedMesh& mesh, const Progress& progress)
{
    if (const Status right = model.checkPrefix(model.siteCount(), Model::Stars, progress); !right)
        return right.error();
    LevelReport verdict;
    verdict.asked = keptEverywhere(query, mesh.scale);
    verdict.sites = static_cast<std::uint32_t>(mesh.mesh.positions.size());
    verdict.tetrahedra = mesh.mesh.tetrahedra.size();
    if (!verifySource(model, original, verdict.failures) || verifySites(model, original, verdict.failures).empty() ||
        !isWellFormed(mesh, verdict.failures))
        return verdict;
    const Result<Weights> weights = weightsOf(model, original, verdict.failures, progress.withCallback({}));
    if (!weights)
        return weights.error();
    const std::vector<std::uint32_t> points = pointsOfVertices(model, original, mesh, verdict.failures);
    if (points.empty())
        return verdict;
    const std::vector<LatticePoint> places = placesOf(original, points);
    const LevelCells cells(points, places, cellsOf(model, mesh));
    const MeshBounds claims(query, mesh.scale, original);
    std::optional<CurvilinearOriginal> lifted;
    if (original.domain == DomainClass::Curvilinear) {
        auto made = CurvilinearOriginal::make(original, model.description().leftHanded, verdict.failures,
                                              progress.withCallback({}));
        if (!made)
            return made.error();
        lifted = *std::move(made);
    }
    const auto verifyCells = [&] {
        if (original.domain == DomainClass::Irregular)
            return verifyIrregularCells(model, IrregularOriginal(original, verdict.failures), *weights, cells, claims,
                                        verdict, progress);
        if (original.domain == DomainClass::Scattered)
            return verifyScatteredCells(model, ScatteredOriginal(original), *weights, cells, claims, verdict, progress);
        return verifyLatticeCells({model, original, *weights, cells, claims, lifted ? &*lifted : nullptr}, verdict,
                                  progress);
    };
    const Status done = verifyCells();
    if (!done)
        return done.error();
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    if (const Status intact = original.checkIntact(); !intact)
        return intact.error();
    return verdict;
}

} // namespace

Result<LevelReport> verifyMesh(const Model& model, const Dataset& original, const MeshQuery& query,
                               const ExtractedMesh& mesh, const Progress& progress)
{
    if (!query.values.empty() || query.window)
        return Error{ErrorKind::WrongUsage, "Only a mesh of the whole domain can be verified: ask for it without a "
                                            "range of values and without a window."};
    try {
        return verifyWhole(model, original, query, mesh, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to verify the mesh. Close other programs, or ask for a coarser one."};
    }
}

namespace {

Eigen::Vector3f floatPosition(const Dataset& original, std::uint64_t point)
{
    return original.position(point).cast<float>();
}

class VertexCheck {
public:
    VertexCheck(const Model& model, const Dataset& original, const ExtractedMesh& mesh)
        : model_(model), original_(original), mesh_(mesh), taken_(original.pointCount())
    {
    }

    std::vector<std::uint32_t> run(std::vector<std::string>& failures)
    {
        std::vector<std::uint32_t> points;
        points.reserve(mesh_.sites.size());
        for (std::uint32_t vertex = 0; vertex < mesh_.sites.size(); ++vertex)
            if (const auto point = pointOf(vertex)) {
                points.push_back(*point);
                checkPoint(vertex, *point);
            }
        noPoint_.moveTo(failures);
        wrongValue_.moveTo(failures);
        twice_.moveTo(failures);
        return points.size() == mesh_.sites.size() ? points : std::vector<std::uint32_t>();
    }

private:
    std::optional<std::uint32_t> pointOf(std::uint32_t vertex)
    {
        const std::uint32_t site = mesh_.sites[vertex];
        std::optional<std::uint32_t> point;
        if (site < model_.siteCount())
            point = model_.points()[site];
        else if (site == ExtractedMesh::noSite && vertex < mesh_.points.size())
            point = mesh_.points[vertex];
        if (point &&
            (*point >= original_.pointCount() || floatPosition(original_, *point) != mesh_.mesh.positions[vertex]))
            point.reset();
        if (!point)
            noPoint_.add(vertex, [&] {
                return name(vertex) + (site == ExtractedMesh::noSite
                                           ? " is no point of the dataset."
                                           : " does not lie where site " + std::to_string(site) + " does.");
            });
        return point;
    }

    void checkPoint(std::uint32_t vertex, std::uint32_t point)
    {
        const double sample = original_.values.at(point);
        if (mesh_.mesh.values[vertex] != static_cast<float>(sample))
            wrongValue_.add(vertex, [&] {
                return name(vertex) + " has the value " + textOf(static_cast<double>(mesh_.mesh.values[vertex])) +
                       "; the original has " + textOf(sample) + " at that point.";
            });
        if (taken_[point])
            twice_.add(vertex, [&] { return name(vertex) + " is the same point as an earlier one."; });
        taken_[point] = true;
    }

    std::string name(std::uint32_t vertex) const
    {
        return "Vertex " + std::to_string(vertex) + " at " +
               textOf(Eigen::Vector3d(mesh_.mesh.positions[vertex].cast<double>()));
    }

    const Model& model_;
    const Dataset& original_;
    const ExtractedMesh& mesh_;
    std::vector<bool> taken_;
    Findings noPoint_;
    Findings wrongValue_;
    Findings twice_;
};

} // namespace

std::vector<std::uint32_t> pointsOfVertices(const Model& model, const Dataset& original, const ExtractedMesh& mesh,
                                            std::vector<std::string>& failures)
{
    return VertexCheck(model, original, mesh).run(failures);
}

} // namespace tetra
