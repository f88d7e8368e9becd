// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/scattered_cells.h"

#include "core/base/rounding.h"
#include "core/mesh/topology.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"
#include "core/verify/verify_parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tetra {

namespace {

__extension__ using Quadruple = __float128;

/// Signs of the volumes of the place with each face; all are positive inside a positive cell.
std::array<int, 4> signsAt(const PlacedCell& c, const Eigen::Vector3d& place)
{
    return {volumeSign(place, c[1], c[2], c[3]), volumeSign(c[0], place, c[2], c[3]),
            volumeSign(c[0], c[1], place, c[3]), volumeSign(c[0], c[1], c[2], place)};
}

/// Cramer's rule from corner 0: the interpolation's gradient times the volume, along the way to the place.
template <class Real> struct Interpolation {
    Real numerator = 0; ///< of value - interpolation
    Real volume = 0;
    Real magnitude = 0; ///< what the numerator's rounding error is relative to
    Real volumeMagnitude = 0;

    Interpolation(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                  double value)
    {
        const auto from0 = [&](const Eigen::Vector3d& to) {
            std::array<Real, 3> way{};
            for (std::size_t x = 0; x < 3; ++x)
                way[x] = static_cast<Real>(to[static_cast<int>(x)]) - static_cast<Real>(cell[0][static_cast<int>(x)]);
            return way;
        };
        const std::array<Real, 3> way = from0(place);
        const std::array<std::array<Real, 3>, 3> edges = {from0(cell[1]), from0(cell[2]), from0(cell[3])};
        const auto size = [](Real number) { return number < 0 ? -number : number; };
        const Real start = static_cast<Real>(value) - static_cast<Real>(values[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::array<Real, 3>& b = edges[(i + 1) % 3];
            const std::array<Real, 3>& c = edges[(i + 2) % 3];
            const Real rise = static_cast<Real>(values[i + 1]) - static_cast<Real>(values[0]);
            for (std::size_t x = 0; x < 3; ++x) {
                const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
                const Real first = b[y] * c[z], second = b[z] * c[y];
                numerator -= rise * way[x] * (first - second);
                magnitude += size(rise * way[x]) * (size(first) + size(second));
                if (i == 0) {
                    volume += edges[0][x] * (first - second);
                    volumeMagnitude += size(edges[0][x]) * (size(first) + size(second));
                }
            }
        }
        numerator += start * volume;
        magnitude += size(start) * volumeMagnitude;
    }
};

} // namespace

PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& points)
{
    PlacedCell cell;
    std::ranges::transform(points, cell.begin(), [&](std::uint32_t point) { return positions[point]; });
    return cell;
}

int volumeSign(const PlacedCell& cell)
{
    return volumeSign(cell[0], cell[1], cell[2], cell[3]);
}

bool holds(const PlacedCell& cell, const Eigen::Vector3d& place)
{
    return std::ranges::all_of(signsAt(cell, place), [](int sign) { return sign >= 0; });
}

bool holdsInside(const PlacedCell& cell, const Eigen::Vector3d& place)
{
    return std::ranges::all_of(signsAt(cell, place), [](int sign) { return sign > 0; });
}

CellError quickError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                     double value)
{
    constexpr double unit = 32 * 0x1p-53;
    const Interpolation<double> at(cell, values, place, value);
    const double volume = std::abs(at.volume) - unit * at.volumeMagnitude;
    if (!(volume > 0))
        return {0, std::numeric_limits<double>::infinity()};
    const double error = std::abs(at.numerator) / std::abs(at.volume);
    return {error, unit * (at.magnitude + error * at.volumeMagnitude) / volume};
}

double preciseError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                    double value)
{
    const Interpolation<Quadruple> at(cell, values, place, value);
    return std::abs(static_cast<double>(at.numerator / at.volume));
}

std::string textOf(const Eigen::Vector3d& place)
{
    return "(" + textOf(place[0]) + ", " + textOf(place[1]) + ", " + textOf(place[2]) + ")";
}

std::string textOf(const PlacedCell& cell)
{
    return textOf(cell[0]) + " " + textOf(cell[1]) + " " + textOf(cell[2]) + " " + textOf(cell[3]);
}

TetrahedronPlanes::TetrahedronPlanes(const std::array<Eigen::Vector3d, 4>& corners)
{
    for (std::size_t face = 0; face < 4; ++face) {
        const auto& [first, second, third] = cornersOfFace[face];
        const Eigen::Vector3d& origin = corners[first];
        const Eigen::Vector3d a = corners[third] - origin; // inwards
        const Eigen::Vector3d b = corners[second] - origin;
        origins_[face] = origin;
        normals_[face] = a.cross(b);
        const Eigen::Vector3d p = a.cwiseAbs(), q = b.cwiseAbs();
        magnitudes_[face] = {p[1] * q[2] + p[2] * q[1], p[2] * q[0] + p[0] * q[2], p[0] * q[1] + p[1] * q[0]};
        box_.extend(corners[face]);
    }
}

bool TetrahedronPlanes::mayMeet(const Eigen::AlignedBox3d& box) const
{
    constexpr double margin = 32 * 0x1p-53;
    if (!box_.intersects(box))
        return false;
    for (std::size_t face = 0; face < 4; ++face) {
        double farthest = 0;
        double doubt = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.min()[axis] - origins_[face][axis];
            const double high = box.max()[axis] - origins_[face][axis];
            farthest += std::max(normals_[face][axis] * low, normals_[face][axis] * high);
            doubt += magnitudes_[face][axis] * std::max(std::abs(low), std::abs(high));
        }
        if (farthest < -margin * doubt)
            return false;
    }
    return true;
}

namespace {

constexpr std::size_t scatteredSitesAtOnce = 64;

/// How many cells hold a place inside the domain. Conforming positive cells whose boundary is the domain's cover every
/// place equally often, so one tells of all.
void verifyCoveredOnce(const ScatteredOriginal& original, const LevelCells& cells, LevelReport& verdict)
{
    for (std::size_t number = 0; number < cells.size(); ++number) {
        const PlacedCell cell = placedCell(original.positions, cells, number);
        const Eigen::Vector3d middle = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
        if (volumeSign(cell) <= 0 || !holdsInside(cell, middle))
            continue; // too thin for a double inside it
        std::size_t count = 0;
        for (std::size_t other = 0; other < cells.size(); ++other) {
            const PlacedCell around = placedCell(original.positions, cells, other);
            count += volumeSign(around) > 0 && holds(around, middle);
        }
        if (count != 1)
            verdict.failures.push_back("The place " + textOf(middle) + " lies in " + std::to_string(count) + " cells.");
        verdict.covers = verdict.covers && count == 1;
        return;
    }
    verdict.covers = false;
    verdict.failures.emplace_back("No cell has an inside.");
}

/// Whether all initial sites lie on one side of a face, which is given by its points.
bool onHull(const Model& model, const ScatteredOriginal& original, std::uint32_t initialSites,
            const std::array<std::uint32_t, 3>& face)
{
    const Eigen::Vector3d a = original.positions[face[0]], b = original.positions[face[1]],
                          c = original.positions[face[2]];
    int side = 0;
    for (std::uint32_t site = 0; site < initialSites; ++site) {
        const int sign = volumeSign(a, b, c, original.positions[model.points()[site]]);
        if (sign * side < 0)
            return false;
        side = side == 0 ? sign : side;
    }
    return true;
}

/// The mesh of the first sites.
Result<LevelReport> verifyPrefix(const Model& model, const ScatteredOriginal& original,
                                 const std::vector<LatticePoint>& places, const Weights& weights, std::uint32_t sites,
                                 double claimed, const Progress& progress)
{
    LevelReport verdict;
    verdict.sites = sites;
    const LevelCells cells(model, places, sites);
    if (const Status done =
            verifyScatteredCells(model, original, weights, cells, MeshBounds(claimed, 0), verdict, progress);
        !done)
        return done.error();
    return verdict;
}

} // namespace

ScatteredOriginal::ScatteredOriginal(const Dataset& dataset)
    : positions(*dataset.positions), values(dataset.pointCount()), extent(dataset.values.range().extent()),
      tree(
          positions.size(),
          [this](std::uint32_t point) { return Eigen::AlignedBox3d(positions[point], positions[point]); },
          [this](std::uint32_t point, Eigen::Index axis) { return positions[point][axis]; })
{
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
}

void verifyPlacedVolumes(const ScatteredOriginal& original, const LevelCells& cells, LevelReport& verdict)
{
    Findings wrong;
    tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t number) {
        const PlacedCell cell = placedCell(original.positions, cells, number);
        if (const int sign = volumeSign(cell); sign <= 0)
            wrong.add(number, [&] {
                return std::string(sign == 0 ? "Flat" : "Inverted") + " cell with corners " + textOf(cell) + ".";
            });
    });
    verdict.inverted = wrong.count();
    wrong.moveTo(verdict.failures);
}

Status verifyScatteredCells(const Model& model, const ScatteredOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshBounds& claims, LevelReport& verdict,
                            const Progress& progress)
{
    verdict.covers = true;
    verdict.tetrahedra = cells.size();
    verifyPlacedVolumes(original, cells, verdict);
    const std::uint32_t initialSites = initialSiteCount(model);
    const FaceRule rule{[&](const std::array<std::uint32_t, 3>& face) {
                            return onHull(model, original, initialSites,
                                          {cells.point(face[0]), cells.point(face[1]), cells.point(face[2])});
                        },
                        [&](std::uint32_t vertex) { return textOf(original.positions[cells.point(vertex)]); }};
    if (const Status faces = verifyFaces(cells, rule, verdict, progress.part(0, 0.4)); !faces)
        return faces;
    verifyCoveredOnce(original, cells, verdict);
    PointCheck check(model, original, weights, cells, claims);
    if (const Status done = check.run(progress.part(0.4, 1)); !done)
        return done;
    Findings notCovered;
    Findings beyondOwn;
    for (std::uint32_t point = 0; point < original.positions.size(); ++point) {
        const auto name = [&] { return "oint " + std::to_string(point) + " " + textOf(original.positions[point]); };
        if (!check.isCovered(point))
            notCovered.add(point, [&] { return "P" + name() + " lies in no cell."; });
        else if (!check.isWithinOwn(point))
            beyondOwn.add(point, [&] {
                return "The error at p" + name() + " is larger than the own error of every cell that holds it.";
            });
    }
    verdict.covers = verdict.covers && notCovered.none();
    verdict.largestError = original.percent(check.largestError());
    for (Findings* findings : {&notCovered, &check.tooLarge(), &beyondOwn})
        findings->moveTo(verdict.failures);
    return {};
}

Status verifyPlacedHistory(const Model& model, const ScatteredOriginal& original, std::vector<std::string>& failures,
                           const Progress& progress)
{
    Findings positions;
    Findings volumes;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        if (model.position(site) != original.positions[model.points()[site]])
            positions.add(site, [&] {
                return "Site " + std::to_string(site) + " lies at " + textOf(model.position(site)) +
                       "; the original's point is at " + textOf(original.positions[model.points()[site]]) + ".";
            });
    const auto checkStar = [&](std::size_t creator) {
        for (std::uint64_t number = model.starOffsets()[creator]; number < model.starOffsets()[creator + 1]; ++number) {
            const auto& others = model.otherSites()[number];
            const auto point = [&](std::uint32_t site) { return model.points()[site]; };
            const PlacedCell cell =
                placedCell(original.positions, {point(creator), point(others[0]), point(others[1]), point(others[2])});
            if (const int sign = volumeSign(cell); sign <= 0)
                volumes.add(number, [&] {
                    return "Tetrahedron " + std::to_string(number) + " with corners " + textOf(cell) + " is " +
                           (sign == 0 ? "flat." : "inverted.");
                });
        }
    };
    if (const Status checked =
            verifyEach(model.siteCount(), scatteredSitesAtOnce, "Verifying the history", progress, checkStar);
        !checked)
        return checked;
    positions.moveTo(failures);
    volumes.moveTo(failures);
    return {};
}

Status verifyScatteredHistory(const Model& model, const ScatteredOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress)
{
    if (const Status done = verifyPlacedHistory(model, original, failures, progress.part(0, 0.5)); !done)
        return done;
    const auto first = verifyPrefix(model, original, places, weights, initialSiteCount(model),
                                    std::numeric_limits<double>::infinity(), progress.part(0.5, 1));
    if (!first)
        return first.error();
    for (const std::string& failure : first->failures)
        failures.push_back("The first mesh: " + failure);
    return {};
}

Result<LevelReport> verifyScatteredLevel(const Model& model, const ScatteredOriginal& original,
                                         const std::vector<LatticePoint>& places, const Weights& weights,
                                         const Accuracy& asked, const Progress& progress)
{
    const std::uint32_t sites = firstPassage(model, asked.error / 100 * original.extent);
    Result<LevelReport> verdict =
        verifyPrefix(model, original, places, weights, sites, claimedKey(model, sites), progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

namespace {

constexpr std::size_t cellsPerPointTask = 256;

} // namespace

double PointCheck::ownBound(std::size_t number) const
{
    const auto inHistory = cells_.historyNumber(number);
    return inHistory ? static_cast<double>(halfToFloat(model_.ownErrors()[*inHistory])) * original_.extent
                     : std::numeric_limits<double>::infinity();
}

Status PointCheck::run(const Progress& progress)
{
    return verifyEach(cells_.size(), cellsPerPointTask, "Verifying the error at every point", progress,
                      [this](std::size_t number) { checkCell(number); });
}

void PointCheck::checkCell(std::size_t number)
{
    const PlacedCell cell = placedCell(original_.positions, cells_, number);
    if (volumeSign(cell) <= 0)
        return; // found already, and a flat cell interpolates nothing
    std::array<double, 4> values{};
    std::ranges::transform(cells_.vertices(number), values.begin(),
                           [&](std::uint32_t vertex) { return original_.values[cells_.point(vertex)]; });
    const double tolerance = errorAllowance * original_.extent;
    const double own = ownBound(number);
    std::array<std::uint32_t, 4> corners{};
    std::ranges::transform(cells_.vertices(number), corners.begin(),
                           [&](std::uint32_t vertex) { return cells_.point(vertex); });
    const TetrahedronPlanes planes(cell);
    const auto mayMeet = [&planes](const Eigen::AlignedBox3d& box) { return planes.mayMeet(box); };
    original_.tree.visitNear(mayMeet, [&](std::uint32_t point) {
        if (std::ranges::find(corners, point) != corners.end()) {
            mark(point, Covered | WithinOwnError);
            return;
        }
        const Eigen::Vector3d& place = original_.positions[point];
        if (!holds(cell, place))
            return;
        const double claimed = claims_.error(point);
        const double weight = weights_.empty() ? 1 : static_cast<double>(weights_[point]);
        const CellError quick = quickError(cell, values, place, original_.values[point]);
        const bool clear = (quick.error + quick.doubt) * weight <= std::min(own, claimed);
        const double error =
            weight * (clear ? quick.error : preciseError(cell, values, place, original_.values[point]));
        largest_.local() = std::max(largest_.local(), error);
        mark(point, error <= own + tolerance ? Covered | WithinOwnError : Covered);
        if (error > claimed + tolerance)
            tooLarge_.add(point, [&] {
                return "The error at point " + std::to_string(point) + " " + textOf(place) + " is " +
                       textOf(original_.percent(error)) + " % of the range, more than the claimed " +
                       textOf(original_.percent(claimed)) + " %, in the cell with corners " + textOf(cell) + ".";
            });
    });
}

} // namespace tetra
