// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_irregular.h"

#include "core/base/disjoint_sets.h"
#include "core/history/build_facts.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace tetra {

namespace {

/// The boundary of a mesh of irregular data, by points of the original.
struct MeshBoundary {
    MeshBoundary(const IrregularOriginal& original, const LevelCells& levelCells, std::span<const BoundaryFace> faces)
        : triangles(trianglesOf(levelCells, faces)), cells(faces.size()), surfaces(boundarySurfaces(triangles)),
          tree(original.points.positions, triangles)
    {
        std::ranges::transform(faces, cells.begin(), &BoundaryFace::cell);
    }
    MeshBoundary(const MeshBoundary&) = delete; // the tree looks at the triangles
    MeshBoundary& operator=(const MeshBoundary&) = delete;

    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> cells; ///< of each triangle
    BoundarySurfaces surfaces;
    TriangleTree tree;

private:
    static std::vector<Triangle> trianglesOf(const LevelCells& cells, std::span<const BoundaryFace> faces)
    {
        std::vector<Triangle> triangles;
        for (const auto& [face, cell] : faces)
            triangles.push_back({cells.point(face[0]), cells.point(face[1]), cells.point(face[2])});
        return triangles;
    }
};

constexpr std::size_t trianglesAtOnce = 256;

/// The boundary is a manifold but where the original's is none, and there it is none in the same way; it has, surface
/// for surface, the vertices and the Euler characteristic of one of the original's; it does not meet itself; the cells
/// have the original's components; and they hold what is inside once only. Where the original's own faces meet they may
/// go on doing so (C10). For cells that conform.
class BoundaryCheck {
public:
    BoundaryCheck(const IrregularOriginal& original, const LevelCells& cells, const MeshBoundary& boundary)
        : original_(original), cells_(cells), boundary_(boundary)
    {
    }

    Status run(LevelReport& verdict, const Progress& progress);

private:
    void checkManifold();
    void checkComponents();
    void checkSurfaces();
    Status checkMeetings(const Progress& progress);
    void checkCoveredOnce();
    bool isUndivided(std::size_t cell) const;
    std::vector<std::uint32_t> surfacesAt(std::uint32_t point) const;
    std::vector<std::vector<std::uint32_t>> untouchedPieces() const;
    PlacedCell placed(std::size_t cell) const { return placedCell(original_.points.positions, cells_.points(cell)); }
    std::string name(std::uint32_t point) const
    {
        return std::to_string(point) + " " + textOf(original_.points.positions[point]);
    }
    std::string name(const Triangle& t) const
    {
        const auto& places = original_.points.positions;
        return textOf(places[t[0]]) + " " + textOf(places[t[1]]) + " " + textOf(places[t[2]]);
    }

    const IrregularOriginal& original_;
    const LevelCells& cells_;
    const MeshBoundary& boundary_;
    std::vector<std::uint8_t> touched_; ///< of each triangle: it meets others, as it does in the original
    Findings manifold_;
    Findings components_;
    Findings surfaces_;
    Findings meetings_;
    Findings coverage_;
};

/// What is in the first sorted list and not in the second one.
template <class Item> std::vector<Item> onlyIn(const std::vector<Item>& first, const std::vector<Item>& second)
{
    std::vector<Item> result;
    std::ranges::set_difference(first, second, std::back_inserter(result));
    return result;
}

void BoundaryCheck::checkManifold()
{
    const BoundarySurfaces &here = boundary_.surfaces, &there = original_.surfaces;
    for (const auto& [edge, sides] : onlyIn(here.seams, there.seams))
        manifold_.add(edge[0], [&] {
            return "The boundary's edge from point " + name(edge[0]) + " to " + name(edge[1]) + " belongs to " +
                   std::to_string(sides) + " of its faces, which is not so in the data.";
        });
    for (const auto& [vertex, fans] : onlyIn(here.pinches, there.pinches))
        manifold_.add(vertex, [&] {
            return "The boundary touches itself at point " + name(vertex) + " otherwise than that of the data.";
        });
    for (const auto& [edge, sides] : onlyIn(there.seams, here.seams))
        manifold_.add(edge[0], [&] {
            return "The data's boundary touches itself in the edge from point " + name(edge[0]) + " to " +
                   name(edge[1]) + ", and that of the mesh does not in the same way.";
        });
    for (const auto& [vertex, fans] : onlyIn(there.pinches, here.pinches))
        manifold_.add(vertex, [&] {
            return "The data's boundary touches itself at point " + name(vertex) +
                   ", and that of the mesh does not in the same way.";
        });
}

void BoundaryCheck::checkComponents()
{
    const std::size_t points = original_.componentOf.size();
    DisjointSets joined(points);
    std::vector<bool> used(points);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        const LevelCells::Cell& c = cells_.vertices(cell);
        const std::uint32_t first = cells_.point(c[0]);
        for (const std::uint32_t vertex : c) {
            const std::uint32_t point = cells_.point(vertex);
            joined.join(first, point);
            used[point] = true;
            if (original_.componentOf[point] != original_.componentOf[first])
                components_.add(cell, [&] {
                    return "A cell joins points " + name(first) + " and " + name(point) +
                           " of two components of the data.";
                });
        }
    }
    std::int64_t parts = 0;
    std::int64_t components = 0;
    for (std::uint32_t point = 0; point < points; ++point) {
        parts += used[point] && joined.root(point) == point ? 1 : 0;
        components += original_.componentOf[point] == point ? 1 : 0;
    }
    if (parts != components)
        components_.add(0, [&] {
            return "The mesh has " + std::to_string(parts) + " components, and the data have " +
                   std::to_string(components) + ".";
        });
}

/// Those of the original that the point lies on, sorted.
std::vector<std::uint32_t> BoundaryCheck::surfacesAt(std::uint32_t point) const
{
    if (!original_.isOnBoundary(point))
        return {};
    if (!original_.surfaces.isPinched(point))
        return {original_.surfaceOf[point]};
    std::vector<std::uint32_t> surfaces;
    for (auto at = std::ranges::lower_bound(original_.atPinches, std::array{point, 0U});
         at != original_.atPinches.end() && (*at)[0] == point; ++at)
        surfaces.push_back((*at)[1]);
    return surfaces;
}

/// Each surface is one of the original's and of its kind.
void BoundaryCheck::checkSurfaces()
{
    const auto& surfaces = boundary_.surfaces.surfaces;
    const auto& originals = original_.surfaces.surfaces;
    if (surfaces.size() != originals.size())
        surfaces_.add(0, [&] {
            return "The boundary has " + std::to_string(surfaces.size()) + " surfaces, and that of the data has " +
                   std::to_string(originals.size()) + ".";
        });
    // Of each surface those of the original that all its points lie on: one, unless it ends in seams everywhere.
    std::vector<std::optional<std::vector<std::uint32_t>>> meant(surfaces.size());
    for (std::uint32_t triangle = 0; triangle < boundary_.triangles.size(); ++triangle)
        for (const std::uint32_t point : boundary_.triangles[triangle]) {
            auto& candidates = meant[boundary_.surfaces.surfaceOf[triangle]];
            if (candidates && candidates->size() == 1 && original_.surfaceOf[point] == candidates->front())
                continue; // as nearly always
            std::vector<std::uint32_t> common = surfacesAt(point);
            if (candidates) {
                std::vector<std::uint32_t> both;
                std::ranges::set_intersection(*candidates, common, std::back_inserter(both));
                common = std::move(both);
            }
            if (common.empty()) {
                surfaces_.add(triangle, [&] {
                    return "The boundary goes through point " + name(point) +
                           (original_.isOnBoundary(point) ? ", which lies on another surface of the data."
                                                          : ", which lies inside the data.");
                });
                continue; // said, and looked at with what there was
            }
            candidates = std::move(common);
        }
    std::vector<std::uint32_t> order(surfaces.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(
        order, {}, [&](std::uint32_t surface) { return meant[surface] ? meant[surface]->size() : std::size_t(0); });
    std::vector<bool> taken(originals.size());
    for (const std::uint32_t surface : order) {
        if (!meant[surface])
            continue; // said already
        const auto isFree = [&](std::uint32_t original) { return !taken[original]; };
        const auto isOfItsKind = [&](std::uint32_t original) {
            return isFree(original) && originals[original].euler == surfaces[surface].euler;
        };
        auto found = std::ranges::find_if(*meant[surface], isOfItsKind);
        const bool isKind = found != meant[surface]->end();
        if (!isKind)
            found = std::ranges::find_if(*meant[surface], isFree);
        if (found == meant[surface]->end()) {
            surfaces_.add(surfaces[surface].firstTriangle, [&] {
                return "A surface of the data's boundary became two, one of them with the face " +
                       name(boundary_.triangles[surfaces[surface].firstTriangle]) + ".";
            });
            continue;
        }
        taken[*found] = true;
        if (!isKind)
            surfaces_.add(surfaces[surface].firstTriangle, [&] {
                return "The surface of the boundary with the face " +
                       name(boundary_.triangles[surfaces[surface].firstTriangle]) + " has Euler characteristic " +
                       std::to_string(surfaces[surface].euler) + ", and that of the data has " +
                       std::to_string(originals[*found].euler) + ": a hole was opened or closed.";
            });
    }
}

Status BoundaryCheck::checkMeetings(const Progress& progress)
{
    const auto& triangles = boundary_.triangles;
    touched_.assign(triangles.size(), 0);
    const auto touch = [this](std::uint32_t number) {
        std::atomic_ref(touched_[number]).store(1, std::memory_order_relaxed);
    };
    const auto checkTriangle = [&](std::uint32_t number) {
        boundary_.tree.visitMeeting(boundary_.tree.boxOf(number), [&](std::uint32_t other) {
            if (other <= number || !facesMeet(original_.points.positions, triangles[number], triangles[other]))
                return;
            if (original_.isFace(triangles[number]) && original_.isFace(triangles[other])) {
                touch(number);
                touch(other);
                return;
            }
            meetings_.add(number, [&] {
                return "The boundary meets itself: the faces " + name(triangles[number]) + " and " +
                       name(triangles[other]) + " have more in common than their corners.";
            });
        });
    };
    return verifyEach(triangles.size(), trianglesAtOnce, "Verifying the boundary", progress,
                      [&](std::size_t number) { checkTriangle(static_cast<std::uint32_t>(number)); });
}

/// The triangles that nothing touches, in pieces that hang together by edges.
std::vector<std::vector<std::uint32_t>> BoundaryCheck::untouchedPieces() const
{
    std::vector<std::uint32_t> numbers;
    std::vector<Triangle> triangles;
    for (std::uint32_t number = 0; number < touched_.size(); ++number)
        if (touched_[number] == 0) {
            numbers.push_back(number);
            triangles.push_back(boundary_.triangles[number]);
        }
    const BoundarySurfaces found = boundarySurfaces(triangles);
    std::vector<std::vector<std::uint32_t>> pieces(found.surfaces.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        pieces[found.surfaceOf[i]].push_back(numbers[i]);
    return pieces;
}

/// Whether no face of the boundary goes into a cell, but for those that touch others in the original, too. With cells
/// that conform none goes even through its faces.
bool BoundaryCheck::isUndivided(std::size_t cell) const
{
    const PlacedCell corners = placed(cell);
    const LevelCells::Cell& c = cells_.vertices(cell);
    std::array<Triangle, 4> faces;
    for (std::size_t face = 0; face < 4; ++face)
        for (std::size_t i = 0; i < 3; ++i)
            faces[face][i] = cells_.point(c[cornersOfFace[face][i]]);
    bool undivided = true;
    boundary_.tree.visitMeeting(boxOf(corners), [&](std::uint32_t number) {
        if (touched_[number] != 0)
            return;
        const Triangle& other = boundary_.triangles[number];
        undivided = undivided &&
                    std::ranges::none_of(boundary_.tree.corners(number),
                                         [&](const Eigen::Vector3d& place) { return holdsInside(corners, place); });
        for (const Triangle& face : faces)
            undivided = undivided && (std::ranges::is_permutation(face, other) ||
                                      !facesMeet(original_.points.positions, face, other));
    });
    return undivided;
}

/// How many cells hold a place changes only at the boundary, and there by one. So it is at most one everywhere if it is
/// one just inside each of the surfaces, which do not meet but where the original's do.
void BoundaryCheck::checkCoveredOnce()
{
    for (const std::vector<std::uint32_t>& piece : untouchedPieces()) {
        const auto hasRoom = [this](std::uint32_t triangle) {
            return placeInside(placed(boundary_.cells[triangle])).has_value();
        };
        const auto triangle = std::ranges::find_if(piece, hasRoom);
        if (triangle != piece.end()) { // just inside the surface there is its cell alone
            const std::size_t cell = boundary_.cells[*triangle];
            if (countHolding(original_.points.positions, cells_, *placeInside(placed(cell))) == 1 && isUndivided(cell))
                continue;
        }
        coverage_.add(piece.front(), [&] {
            return (triangle != piece.end() ? "Cells lie on one another"
                                            : std::string("No cell has room for a number in doubles")) +
                   " inside the surface of the boundary with the face " + name(boundary_.triangles[piece.front()]) +
                   ".";
        });
    }
}

Status BoundaryCheck::run(LevelReport& verdict, const Progress& progress)
{
    checkManifold();
    checkComponents();
    if (manifold_.none()) {
        checkSurfaces();
        if (const Status done = checkMeetings(progress); !done)
            return done;
    }
    if (manifold_.none() && meetings_.none())
        checkCoveredOnce();
    verdict.conforming = verdict.conforming && manifold_.none();
    verdict.covers = verdict.covers && components_.none() && surfaces_.none() && meetings_.none() && coverage_.none();
    for (Findings* findings : {&manifold_, &components_, &surfaces_, &meetings_, &coverage_})
        findings->moveTo(verdict.failures);
    return {};
}

constexpr std::uint32_t relatedPointsAtOnce = 64;

class RelatedCheck {
public:
    RelatedCheck(const MeshToVerify& mesh, const MeshBoundary& boundary, CellFindings& inside)
        : mesh_(mesh), boundary_(boundary), original_(*mesh.original.irregular), inside_(inside),
          isVertex_(original_.points.positions.size()), error_(Residual::error(mesh)),
          warping_(Residual::warping(mesh)), warpings_(isVertex_.size(), 0), atNearest_(isVertex_.size(), 0)
    {
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
            for (const std::uint32_t point : mesh.cells.points(cell))
                isVertex_[point] = true;
        for (const std::uint32_t cell : boundary.cells)
            largestOwnWarping_ = std::max(largestOwnWarping_, warping_.own(cell));
    }

    Status run(const Progress& progress);
    void moveTo(LevelReport& verdict);

private:
    /// A point, and what is next to it on the boundary.
    struct Related {
        std::uint32_t point;
        const Eigen::Vector3d& place;
        double value;
        double weight;
        TriangleTree::Nearest nearest;
    };

    void checkPoint(std::uint32_t point);
    void checkWarping(const Related& related);
    void checkOutside(const Related& related);
    void checkOwn(const Related& related, bool covered);
    bool isGrantedNextToIt(const Related& related) const;
    double errorAtNearest(const Related& related) const;
    double leastErrorWithin(const Related& related, double radius) const;
    double errorOn(const Related& related, std::uint32_t triangle, double radius) const;
    std::array<double, 3> valuesOf(std::uint32_t triangle) const
    {
        const Triangle& t = boundary_.triangles[triangle];
        return {original_.points.values[t[0]], original_.points.values[t[1]], original_.points.values[t[2]]};
    }
    std::string name(const Related& related) const
    {
        return "point " + std::to_string(related.point) + " " + textOf(related.place);
    }

    const MeshToVerify& mesh_;
    const MeshBoundary& boundary_;
    const IrregularOriginal& original_;
    CellFindings& inside_;
    std::vector<bool> isVertex_;
    Residual error_;
    Residual warping_;
    double largestOwnWarping_ = 0; ///< of cells on the boundary
    PointResiduals warpings_;
    PointResiduals atNearest_; ///< the errors of points outside at the nearest place
    std::atomic<std::uint64_t> outside_ = 0;
    Findings tooFar_;
    Findings tooLarge_;
    Findings beyondOwn_;
};

Status RelatedCheck::run(const Progress& progress)
{
    return verifyEach(original_.points.positions.size(), relatedPointsAtOnce,
                      "Verifying the boundary's distance at every vertex", progress, [this](std::size_t point) {
                          if (!isVertex_[point])
                              checkPoint(static_cast<std::uint32_t>(point));
                      });
}

void RelatedCheck::checkPoint(std::uint32_t point)
{
    const bool covered = inside_.isCovered(point);
    const bool beyondOwn = mesh_.ofHistory() && !inside_.isWithinOwn(point);
    if (covered && !original_.isOnBoundary(point) && !beyondOwn)
        return;
    const Eigen::Vector3d& place = original_.points.positions[point];
    const Related related{point, place, original_.points.values[point], mesh_.weight(point),
                          boundary_.tree.nearest(place)};
    if (original_.isOnBoundary(point))
        checkWarping(related);
    if (!covered)
        checkOutside(related);
    if (mesh_.ofHistory())
        checkOwn(related, covered);
}

void RelatedCheck::checkWarping(const Related& related)
{
    const double warping = related.weight * related.nearest.place.distance;
    const double claimed = warping_.claimed(related.point);
    warpings_.raise(related.point, warping);
    if (warping > claimed + warping_.allowance)
        tooFar_.add(related.point,
                    [&] { return warping_.moreThanClaimed(related.point, name(related), warping) + "."; });
}

/// The difference, weighted, from the point's value to that of the place of the triangle within the radius that comes
/// closest to it; infinity if there is none.
double RelatedCheck::errorOn(const Related& related, std::uint32_t triangle, double radius) const
{
    const auto range = valuesWithin(boundary_.tree.corners(triangle), valuesOf(triangle), related.place, radius);
    if (!range)
        return std::numeric_limits<double>::infinity();
    return related.weight * std::max({0.0, (*range)[0] - related.value, related.value - (*range)[1]});
}

double RelatedCheck::leastErrorWithin(const Related& related, double radius) const
{
    double least = std::numeric_limits<double>::infinity();
    boundary_.tree.visitWithin(related.place, radius, [&](std::uint32_t triangle) {
        least = std::min(least, errorOn(related, triangle, radius));
    });
    return least;
}

/// Of several places that are equally near, as a symmetric boundary has them, the one that comes closest counts.
double RelatedCheck::errorAtNearest(const Related& related) const
{
    constexpr double rounding = 1e-12;
    const double radius = related.nearest.place.distance * (1 + rounding);
    const auto errorAt = [&](std::uint32_t triangle, const std::array<double, 3>& weights) {
        const std::array<double, 3> values = valuesOf(triangle);
        const double there = weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
        return related.weight * std::abs(there - related.value);
    };
    double least = errorAt(related.nearest.triangle, related.nearest.place.weights);
    boundary_.tree.visitWithin(related.place, radius, [&](std::uint32_t triangle) {
        const auto place = nearestPlace(boundary_.tree.corners(triangle), related.place);
        if (place.distance <= radius)
            least = std::min(least, errorAt(triangle, place.weights));
    });
    return least;
}

void RelatedCheck::checkOutside(const Related& related)
{
    double error = errorAtNearest(related);
    atNearest_.raise(related.point, error);
    const double claimed = error_.claimed(related.point);
    if (error > claimed + error_.allowance) {
        const double radius = std::max(related.nearest.place.distance,
                                       warping_.claimed(related.point) / related.weight + warping_.allowance);
        error = std::min(error, leastErrorWithin(related, radius));
    }
    ++outside_;
    inside_.residuals.raise(related.point, error);
    if (error > claimed + error_.allowance)
        tooLarge_.add(related.point, [&] {
            return error_.moreThanClaimed(related.point, name(related) + ", outside the mesh,", error) + ".";
        });
}

/// A point that lies on a face or an edge, but for rounding, may count for a cell on its other side, whose
/// interpolation there is the same; so may one that rounding has put outside of an edge of the boundary. Looks at all
/// cells, for the few that need it.
bool RelatedCheck::isGrantedNextToIt(const Related& related) const
{
    for (std::size_t number = 0; number < mesh_.cells.size(); ++number) {
        const std::array<std::uint32_t, 4> points = mesh_.cells.points(number);
        const PlacedCell cell = placedCell(original_.points.positions, points);
        const auto isBefore = [&](const std::array<std::uint8_t, 3>& face) {
            const Eigen::Vector3d normal = (cell[face[1]] - cell[face[0]]).cross(cell[face[2]] - cell[face[0]]);
            return normal.dot(related.place - cell[face[0]]) > warping_.allowance * normal.norm();
        };
        if (std::ranges::any_of(cornersOfFace, isBefore))
            continue;
        std::array<double, 4> values{};
        std::ranges::transform(points, values.begin(),
                               [&](std::uint32_t point) { return original_.points.values[point]; });
        if (related.weight * preciseError(cell, values, related.place, related.value) <=
            error_.own(number) + error_.allowance)
            return true;
    }
    return false;
}

/// The point counts for a cell: the one that holds it, or one on the boundary that is near enough.
void RelatedCheck::checkOwn(const Related& related, bool covered)
{
    const bool needsError = !inside_.isWithinOwn(related.point);
    const auto grants = [&](std::uint32_t triangle) {
        const std::uint32_t cell = boundary_.cells[triangle];
        const double radius = warping_.own(cell) / related.weight + warping_.allowance;
        if (!needsError)
            return nearestPlace(boundary_.tree.corners(triangle), related.place).distance <= radius;
        return errorOn(related, triangle, radius) <= error_.own(cell) + error_.allowance;
    };
    if (grants(related.nearest.triangle))
        return;
    const bool onCells = covered || related.nearest.place.distance <= warping_.allowance;
    bool granted = needsError && onCells && isGrantedNextToIt(related);
    const double farthest = largestOwnWarping_ / related.weight + warping_.allowance;
    boundary_.tree.visitWithin(related.place, farthest,
                               [&](std::uint32_t triangle) { granted = granted || grants(triangle); });
    if (!granted)
        beyondOwn_.add(related.point, [&] {
            return "The error or the warping at " + name(related) + " is larger than the own ones of every cell " +
                   (covered ? "that holds it." : "on the boundary near it.");
        });
}

void RelatedCheck::moveTo(LevelReport& verdict)
{
    verdict.measured.error = inside_.residuals.statistics(error_.percent(1));
    verdict.measured.errorInSpace = {verdict.measured.error, outside_};
    for (std::size_t point = 0; point < atNearest_.size(); ++point)
        atNearest_.raise(point, inside_.residuals.at(point)); // of those outside no more than at the nearest place
    verdict.measured.errorAtNearest = atNearest_.statistics(error_.percent(1));
    verdict.measured.warping = warpings_.statistics(warping_.percent(1), [this](std::size_t point) {
        return original_.isOnBoundary(static_cast<std::uint32_t>(point));
    });
    for (Findings* findings : {&tooLarge_, &tooFar_, &beyondOwn_})
        findings->moveTo(verdict.failures);
}

/// What the boundary's places farthest from the original's say; weights are of points, so none is judged with them.
void verifyTwoSides(const MeshToVerify& mesh, const MeshBoundary& boundary, LevelReport& verdict)
{
    const BoundaryDistances distances = distancesToOriginal(*mesh.original.irregular, boundary.triangles);
    const double percent = 100 / mesh.original.diagonal;
    verdict.twoSidedWarping = std::max(verdict.measured.warping.largest, percent * distances.found);
    verdict.twoSidedBound = std::max(verdict.measured.warping.largest, percent * distances.bound);
    const double claimed = mesh.bounds.areUniform() ? mesh.bounds.warping(0) : std::numeric_limits<double>::infinity();
    if (buildFacts(mesh.model.description()).claimsTwoSides && mesh.weights.empty() &&
        distances.found > claimed + mesh.original.warpingAllowance)
        verdict.failures.push_back("The boundary goes " + textOf(percent * distances.found) +
                                   " % of the diagonal away from that of the data, more than the claimed " +
                                   textOf(percent * claimed) + " %.");
}

} // namespace

Status verifyIrregular(const MeshToVerify& mesh, CellFindings& inside, std::span<const BoundaryFace> faces,
                       LevelReport& verdict, const Progress& progress)
{
    const IrregularOriginal& original = *mesh.original.irregular;
    const MeshBoundary boundary(original, mesh.cells, faces);
    const bool sound = verdict.conforming && verdict.inverted == 0;
    if (sound)
        if (const Status done = BoundaryCheck(original, mesh.cells, boundary).run(verdict, progress.part(0, 0.4));
            !done)
            return done;
    verdict.covers = verdict.covers && sound && verdict.conforming;
    inside.beyondClaim.moveTo(verdict.failures);
    if (boundary.triangles.empty())
        return {}; // said already
    RelatedCheck check(mesh, boundary, inside);
    if (const Status done = check.run(progress.part(0.4, 1)); !done)
        return done;
    check.moveTo(verdict);
    if (!original.boundary.empty())
        verifyTwoSides(mesh, boundary, verdict);
    return {};
}

} // namespace tetra
