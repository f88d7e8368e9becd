// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_mesh.h"

#include "core/base/guarded.h"
#include "core/history/error_meaning.h"
#include "core/verify/cell_check.h"
#include "core/verify/error_in_space.h"
#include "core/verify/findings.h"
#include "core/verify/verify_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

Accuracy keptEverywhere(const MeshQuery& query, double scale)
{
    constexpr double all = 100;
    return {.error = std::min(all, keptPercent(query.error.bounds().maximum, scale)),
            .warping = std::min(anyWarping, keptPercent(query.warping.bounds().maximum, scale))};
}

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

/// The dataset's point that each vertex of an extracted mesh is: the point of its site, or the one that the mesh names.
/// Position and value must be the dataset's, the value rounded to float, and no two vertices the same point; what is
/// not so is a failure. Empty if a vertex is no point.
std::vector<std::uint32_t> pointsOfVertices(const Model& model, const Dataset& original, const ExtractedMesh& mesh,
                                            std::vector<std::string>& failures)
{
    Findings noPoint, wrongValue, twice;
    std::vector<std::uint32_t> points;
    std::vector<bool> taken(original.pointCount());
    for (std::uint32_t vertex = 0; vertex < mesh.sites.size(); ++vertex) {
        const std::uint32_t site = mesh.sites[vertex];
        const Eigen::Vector3d& place = mesh.mesh.positions[vertex];
        const auto name = [&] { return "Vertex " + std::to_string(vertex) + " at " + textOf(place); };
        const bool isNamed = site == ExtractedMesh::noSite && vertex < mesh.points.size();
        const std::uint64_t point = site < model.siteCount() ? model.points()[site]
                                    : isNamed                ? mesh.points[vertex]
                                                             : original.pointCount();
        if (point >= original.pointCount() || original.position(point) != place) {
            noPoint.add(vertex, [&] {
                return name() + (site == ExtractedMesh::noSite
                                     ? " is not a point of the dataset."
                                     : " does not lie where site " + std::to_string(site) + " does.");
            });
            continue;
        }
        points.push_back(static_cast<std::uint32_t>(point));
        const double sample = original.values.at(point);
        if (const float value = mesh.mesh.values[vertex]; value != static_cast<float>(sample))
            wrongValue.add(vertex, [&] {
                return name() + " has the value " + textOf(static_cast<double>(value)) + "; the original has " +
                       textOf(sample) + " at that point.";
            });
        if (taken[point])
            twice.add(vertex, [&] { return name() + " is the same point as an earlier one."; });
        taken[point] = true;
    }
    for (Findings* findings : {&noPoint, &wrongValue, &twice})
        findings->moveTo(failures);
    return points.size() == mesh.sites.size() ? points : std::vector<std::uint32_t>();
}

Result<LevelReport> verifyWhole(const Model& model, const Dataset& given, const MeshQuery& query,
                                const ExtractedMesh& mesh, const Progress& progress)
{
    if (const Status right = model.checkPrefix(model.siteCount(), Model::Stars, progress); !right)
        return right.error();
    const Result<Dataset> taken = takenByModel(model, given, progress.withCallback({}));
    if (!taken)
        return taken.error();
    const Dataset& dataset = *taken;
    LevelReport verdict;
    verdict.asked = keptEverywhere(query, mesh.scale);
    verdict.sites = static_cast<std::uint32_t>(mesh.mesh.positions.size());
    verdict.tetrahedra = mesh.mesh.tetrahedra.size();
    if (!verifySource(model, given, dataset, verdict.failures) ||
        verifySites(model, dataset, verdict.failures).empty() || !isWellFormed(mesh, verdict.failures))
        return verdict;
    const Result<Weights> weights = weightsOf(model, dataset, verdict.failures, progress.withCallback({}));
    if (!weights)
        return weights.error();
    const std::vector<std::uint32_t> points = pointsOfVertices(model, dataset, mesh, verdict.failures);
    if (points.empty())
        return verdict;
    const std::vector<LatticePoint> places = placesOf(dataset, points);
    const LevelCells cells(points, places, cellsOf(model, mesh));
    const MeshBounds bounds(query, mesh.scale, dataset);
    const Result<Original> original = Original::make(model, dataset, verdict.failures, progress.withCallback({}));
    if (!original)
        return original.error();
    if (const Status done = verifyCells({model, *original, *weights, cells, bounds}, verdict, progress); !done)
        return done.error();
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact.error();
    return verdict;
}

template <class Position> PointPositions inDoubles(std::span<const Position> positions)
{
    auto all = std::make_shared<std::vector<Eigen::Vector3d>>(positions.size());
    std::ranges::transform(positions, all->begin(),
                           [](const Position& position) { return Eigen::Vector3d(position.template cast<double>()); });
    return all;
}

/// The grid of a model that has its samples and their places, as far as it takes to compare a mesh with them. The model
/// outlives it.
Dataset gridOf(const Model& model)
{
    const ModelDescription& description = model.description();
    Dataset grid;
    grid.domain = DomainClass::Curvilinear;
    grid.lattice = description.lattice;
    grid.positions = model.floatSamplePositions().empty() ? inDoubles(model.doubleSamplePositions())
                                                          : inDoubles(model.floatSamplePositions());
    grid.values = ScalarField(description.sampleType, description.lattice.pointCount(),
                              {std::shared_ptr<const std::byte>(), model.samples().data()});
    return grid;
}

/// Whether there is an error in space to measure, and all that it takes.
bool isMeasuredInPassing(const Model& model, const MeshQuery& query)
{
    const bool isWhole = query.values.empty() && !query.window && !query.range;
    const std::size_t places = model.floatSamplePositions().size() + model.doubleSamplePositions().size();
    const std::uint64_t points = model.description().lattice.pointCount();
    return isWhole && errorMeaning(model.description(), query) == ErrorMeaning::InGrid && !model.samples().empty() &&
           places == points && points <= mostPointsInPassing;
}

Result<std::optional<ErrorInSpace>> measureWhole(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                                                 const Progress& progress)
{
    for (const Status& right :
         {model.check(model.samples(), progress), model.check(model.floatSamplePositions(), progress),
          model.check(model.doubleSamplePositions(), progress), model.check(model.points(), progress)})
        if (!right)
            return right.error();
    const Dataset grid = gridOf(model);
    LevelReport verdict;
    const auto weights = weightsOf(model, grid, verdict.failures, progress.withCallback({}));
    if (!weights)
        return weights.error();
    if (!isWellFormed(mesh, verdict.failures))
        return std::optional<ErrorInSpace>();
    const std::vector<std::uint32_t> points = pointsOfVertices(model, grid, mesh, verdict.failures);
    if (points.empty())
        return std::optional<ErrorInSpace>();
    const std::vector<LatticePoint> places = placesOf(grid, points);
    const LevelCells cells(points, places, cellsOf(model, mesh));
    Original original(grid);
    original.gridPoints.emplace(grid);
    const FaceRule anyFace{.onBoundary = [](const Triangle&) { return true; },
                           .place = [](std::uint32_t) { return std::string(); }};
    std::vector<BoundaryFace> boundary;
    constexpr double facesEnd = 0.3;
    if (const Status done = verifyFaces(cells, anyFace, verdict, progress.part(0, facesEnd), &boundary); !done)
        return done.error();
    const MeshBounds bounds(query, mesh.scale, grid);
    if (const Status done = verifyErrorInSpace({model, original, *weights, cells, bounds}, boundary, verdict,
                                               progress.part(facesEnd, 1));
        !done)
        return done.error();
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    return std::optional(verdict.measured.errorInSpace);
}

} // namespace

Result<LevelReport> verifyMesh(const Model& model, const Dataset& original, const MeshQuery& query,
                               const ExtractedMesh& mesh, const Progress& progress)
{
    if (!query.values.empty() || query.window)
        return Error{ErrorKind::WrongUsage, Message::say("Only a mesh of the whole domain can be verified: extract it "
                                                         "without a range of values and without a crop box.")};
    if (query.range)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A range of accuracies has the tetrahedra of many meshes, each "
                                  "of which can be verified at its own accuracy.")};
    return guarded(
        Message::marked("Not enough memory to verify the mesh. Close other programs, or choose a coarser one."),
        [&] { return verifyWhole(model, original, query, mesh, progress); });
}

Result<std::optional<ErrorInSpace>> measureInSpace(const Model& model, const MeshQuery& query,
                                                   const ExtractedMesh& mesh, const Progress& progress)
{
    if (!isMeasuredInPassing(model, query))
        return std::optional<ErrorInSpace>();
    try {
        return measureWhole(model, query, mesh, progress);
    } catch (const std::bad_alloc&) { // the mesh is there all the same
        return std::optional<ErrorInSpace>();
    }
}

} // namespace tetra
