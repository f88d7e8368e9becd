// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/free/scattered_refinement.h"

#include "core/base/guarded.h"
#include "core/base/rounding.h"
#include "core/refine/free/scattered_delaunay.h"
#include "core/refine/greedy.h"
#include "core/refine/interpolation.h"
#include "core/refine/noted_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t noCell = ScatteredDelaunay::none;

/// What is kept of a cell of the mesh.
struct CellState {
    std::uint32_t history = 0;             ///< its number in the history
    std::array<std::uint32_t, 4> points{}; ///< its corners
    std::vector<std::uint32_t> inside;     ///< points in it that are no sites
    std::uint32_t worst = noCell;          ///< that of the largest error, the first of them; none: no point has one
    float error = 0;                       ///< its error, never rounded down

    void archive(StateArchive& archive) { archive(history, points, inside, worst, error); }
};

/// The worst point of a cell when it was made; outdated if the slot's cell is another one now.
struct Candidate {
    float error = 0;
    std::uint32_t point = 0;
    std::uint32_t slot = 0;
    bool operator<(const Candidate& other) const { return std::tie(error, other.point) < std::tie(other.error, point); }
};

/// The space of points anywhere (core/refine/greedy.h).
class ScatteredSpace {
public:
    ScatteredSpace(const ScatteredPoints& points, double stopError, HistorySink& sink)
        : points_(points), stopError_(stopError), sink_(sink), delaunay_(points.positions),
          siteOfPoint_(points.positions.size(), noCell)
    {
    }

    Status start(const Progress& progress);

    struct Next {
        Candidate candidate;
        float key = 0;
        static constexpr bool complete = true;
    };
    Next next();
    Status insert(const Next& next);
    std::uint64_t work() const { return 16 * (50 + moved_.size()); } // exact predicates take their time
    std::uint64_t pointsAboveStop() const { return pointsAboveStop_; }
    void sweep() {} // the queue is small beside what cells keep

    void archive(StateArchive& archive);

    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::uint64_t tetrahedronCount() const noexcept { return tetrahedronCount_; }

private:
    Status distribute(const Progress& progress);
    Status addHull();
    void addInside(std::uint32_t slot, std::uint32_t point);
    void closeCell(std::uint32_t slot);
    bool counts(float error) const { return static_cast<double>(error) > stopError_; }

    const ScatteredPoints& points_;
    double stopError_;
    HistorySink& sink_;
    ScatteredDelaunay delaunay_;
    std::vector<CellState> cells_; ///< by slot
    std::vector<std::uint32_t> siteOfPoint_;
    std::priority_queue<Candidate> queue_;
    std::uint64_t pointsAboveStop_ = 0; ///< points in cells that must still be refined: what is left to do
    std::uint32_t siteCount_ = 0;
    std::uint64_t tetrahedronCount_ = 0;

    std::vector<std::uint32_t> moved_;
    std::vector<std::uint32_t> destroyedHistory_;
    std::vector<HistoryTetrahedron> star_;
};

/// An error if two points lie on one place: only one of them could be a site.
Status checkDistinct(std::span<const Eigen::Vector3d> positions)
{
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](std::uint32_t point) {
        const Eigen::Vector3d& p = positions[point];
        return std::tuple(p[0], p[1], p[2]);
    };
    std::ranges::sort(order, {}, key);
    const auto same = std::ranges::adjacent_find(order, {}, key);
    if (same == order.end())
        return {};
    return Error{ErrorKind::BadInput,
                 Message::say("Points %1 and %2 (counted from 0) lie at the same place. Merge such points first.",
                              std::min(same[0], same[1]), std::max(same[0], same[1]))};
}

void ScatteredSpace::addInside(std::uint32_t slot, std::uint32_t point)
{
    CellState& cell = cells_[slot];
    InterpolatingCell geometry;
    for (std::size_t i = 0; i < 4; ++i) {
        geometry.corners[i] = points_.positions[cell.points[i]];
        geometry.values[i] = points_.values[cell.points[i]];
    }
    double exact = interpolationError(geometry, points_.positions[point], points_.values[point]);
    if (!points_.weights.empty())
        exact *= static_cast<double>(points_.weights[point]);
    const float error = roundedUp(exact);
    cell.inside.push_back(point);
    if (error > cell.error || (error > 0 && error == cell.error && point < cell.worst)) {
        cell.error = error;
        cell.worst = point;
    }
}

/// All points of the cell are in it.
void ScatteredSpace::closeCell(std::uint32_t slot)
{
    const CellState& cell = cells_[slot];
    if (cell.worst == noCell)
        return;
    queue_.push({cell.error, cell.worst, slot});
    if (counts(cell.error))
        pointsAboveStop_ += cell.inside.size();
}

Status ScatteredSpace::start(const Progress& progress)
{
    progress.report(0, Message::marked("Finding the convex hull"));
    if (Status status = checkDistinct(points_.positions); !status)
        return status;
    if (progress.cancelled())
        return cancelledError(Message::marked("The refinement"));
    if (Status status = delaunay_.start(); !status)
        return status;
    for (const ScatteredDelaunay::Cell& cell : delaunay_.created()) {
        cells_.resize(std::max<std::size_t>(cells_.size(), cell.slot + 1));
        cells_[cell.slot].points = cell.points;
        for (const std::uint32_t point : cell.points)
            siteOfPoint_[point] = 0; // numbered below
    }
    if (Status status = distribute(progress); !status)
        return status;
    return addHull();
}

Status ScatteredSpace::distribute(const Progress& progress)
{
    constexpr std::uint32_t pointsBetweenReports = 16384;
    std::uint32_t slot = delaunay_.created().front().slot;
    for (std::uint32_t point = 0; point < points_.positions.size(); ++point) {
        if (point % pointsBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("The refinement"));
            progress.report(0, Message::marked("Distributing the points"));
        }
        if (siteOfPoint_[point] != noCell)
            continue;
        const std::uint32_t found = delaunay_.locate(point, slot);
        if (found == noCell)
            return Error{ErrorKind::BadInput,
                         Message::say("Point %1 lies outside the computed convex hull. Coordinates of such different "
                                      "magnitudes cannot be used; scale them.",
                                      point)};
        slot = found;
        addInside(slot, point);
    }
    for (const ScatteredDelaunay::Cell& cell : delaunay_.created())
        closeCell(cell.slot);
    return {};
}

/// The corners of the hull are the first sites.
Status ScatteredSpace::addHull()
{
    std::vector<std::uint64_t> corners;
    for (std::uint32_t point = 0; point < siteOfPoint_.size(); ++point)
        if (siteOfPoint_[point] != noCell) {
            siteOfPoint_[point] = static_cast<std::uint32_t>(corners.size());
            corners.push_back(point);
        }
    const std::span<const ScatteredDelaunay::Cell> cells = delaunay_.created();
    std::vector<StartTetrahedron> tetrahedra(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        tetrahedra[i].error = cells_[cells[i].slot].error;
        for (std::size_t corner = 0; corner < 4; ++corner)
            tetrahedra[i].sites[corner] = siteOfPoint_[cells[i].points[corner]];
    }
    const auto numbers = addStart(corners, tetrahedra, sink_);
    if (!numbers)
        return numbers.error();
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells_[cells[i].slot].history = (*numbers)[i];
    siteCount_ = static_cast<std::uint32_t>(corners.size());
    tetrahedronCount_ = tetrahedra.size();
    return {};
}

void ScatteredSpace::archive(StateArchive& archive)
{
    archive(delaunay_, cells_, siteOfPoint_, pointsAboveStop_, siteCount_, tetrahedronCount_);
    if (!archive.isLoading())
        return;
    for (std::uint32_t slot = 0; slot < cells_.size(); ++slot)
        if (cells_[slot].worst != noCell)
            queue_.push({cells_[slot].error, cells_[slot].worst, slot});
}

/// What waits and belongs to a cell that is no more is dropped.
ScatteredSpace::Next ScatteredSpace::next()
{
    const auto isOutdated = [this](const Candidate& candidate) {
        const CellState& cell = cells_[candidate.slot];
        return cell.worst != candidate.point || cell.error != candidate.error;
    };
    while (!queue_.empty() && isOutdated(queue_.top()))
        queue_.pop();
    return queue_.empty() ? Next{} : Next{queue_.top(), queue_.top().error};
}

Status ScatteredSpace::insert(const Next& next)
{
    if (tetrahedronCount_ > std::numeric_limits<std::uint32_t>::max() - (1u << 20))
        return Error{ErrorKind::OutOfResource,
                     Message::say("The history has more than 4 billion tetrahedra. Choose a larger error.")};
    const Candidate candidate = next.candidate;
    queue_.pop();
    delaunay_.insert(candidate.point, candidate.slot);
    siteOfPoint_[candidate.point] = siteCount_;
    moved_.clear();
    destroyedHistory_.clear();
    for (const std::uint32_t slot : delaunay_.destroyed()) {
        CellState& cell = cells_[slot];
        destroyedHistory_.push_back(cell.history);
        moved_.insert(moved_.end(), cell.inside.begin(), cell.inside.end());
        if (cell.worst != noCell && counts(cell.error))
            pointsAboveStop_ -= cell.inside.size();
        cell = {};
    }
    for (const ScatteredDelaunay::Cell& created : delaunay_.created()) {
        cells_.resize(std::max<std::size_t>(cells_.size(), created.slot + 1));
        cells_[created.slot].points = created.points;
    }
    std::uint32_t slot = delaunay_.created().front().slot;
    for (const std::uint32_t point : moved_)
        if (point != candidate.point) {
            slot = delaunay_.locateInStar(point, slot);
            addInside(slot, point);
        }
    star_.clear();
    for (const ScatteredDelaunay::Cell& created : delaunay_.created()) {
        closeCell(created.slot);
        CellState& cell = cells_[created.slot];
        cell.history = static_cast<std::uint32_t>(tetrahedronCount_++);
        star_.push_back(
            {{siteOfPoint_[cell.points[1]], siteOfPoint_[cell.points[2]], siteOfPoint_[cell.points[3]]}, cell.error});
    }
    ++siteCount_;
    return sink_.add({candidate.point, candidate.error, star_, destroyedHistory_});
}

} // namespace

Result<ScatteredRefinementResult> refineScattered(const ScatteredPoints& points, double stopError, HistorySink& sink,
                                                  const Progress& progress, SavedState* state)
{
    if (points.positions.size() >= noCell)
        return Error{ErrorKind::OutOfResource,
                     Message::say("At most 4294967294 scattered points can be refined. Take a part.")};
    const auto refine = [&]() -> Result<ScatteredRefinementResult> {
        NotedHistory history(sink, state);
        ScatteredSpace space(points, stopError, history);
        if (Status started = history.goesOn() ? history.goOn(space, progress) : space.start(progress); !started)
            return started.error();
        const Result<float> key = refineWorstFirst(space, stopError, history, progress, state);
        if (!key)
            return key.error();
        return ScatteredRefinementResult{space.siteCount(), space.tetrahedronCount(), *key};
    };
    return guarded(noMemoryForPoints, refine);
}

} // namespace tetra
