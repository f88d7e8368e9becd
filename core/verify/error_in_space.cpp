// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/error_in_space.h"

#include "core/history/build_facts.h"
#include "core/mesh/tetrahedron_planes.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr std::size_t cellsAtOnce = 8; // the first few of a coarse mesh hold all points
constexpr std::size_t pointsAtOnce = 256;

class PlaceErrors {
public:
    PlaceErrors(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary)
        : mesh_(mesh), dataset_(mesh.original.dataset), error_(Residual::error(mesh)),
          isJudged_(mesh.ofHistory() && buildFacts(mesh.model.description()).claimsInSpace),
          residuals_(dataset_.pointCount(), std::numeric_limits<double>::infinity())
    {
        for (const BoundaryFace& face : boundary)
            triangles_.push_back({mesh.cells.point(face.vertices[0]), mesh.cells.point(face.vertices[1]),
                                  mesh.cells.point(face.vertices[2])});
    }

    Status run(LevelReport& verdict, const Progress& progress);

private:
    void measureIn(std::size_t number);
    double errorIn(const PlacedCell& cell, const std::array<double, 4>& values, std::uint64_t point) const;
    void measureOutside(const TriangleTree& tree, std::uint64_t point);
    double leastErrorWithin(const TriangleTree& tree, std::uint64_t point, double radius) const;
    void judge(std::uint64_t point, double error);
    double allowed(std::uint64_t point) const { return error_.claimed(point) + error_.allowance; }

    const MeshToVerify& mesh_;
    const Dataset& dataset_;
    const Residual error_;
    const bool isJudged_;
    std::vector<Triangle> triangles_; ///< the boundary, by points
    PointResiduals residuals_;        ///< infinite where no cell was found yet
    std::atomic<std::uint64_t> outside_ = 0;
    Findings tooLarge_;
};

double PlaceErrors::errorIn(const PlacedCell& cell, const std::array<double, 4>& values, std::uint64_t point) const
{
    constexpr double enough = 1e-12; // of the range
    const Eigen::Vector3d& place = (*dataset_.positions)[point];
    const double sample = dataset_.values.at(point);
    const CellError quick = quickError(cell, values, place, sample);
    return quick.doubt <= enough * mesh_.original.extent ? quick.error : preciseError(cell, values, place, sample);
}

void PlaceErrors::measureIn(std::size_t number)
{
    LevelCells::Cell points = mesh_.cells.points(number);
    for (const std::uint32_t point : points)
        residuals_.lower(point, 0);
    const int sign = volumeSign(placedCell(*dataset_.positions, points));
    if (sign == 0)
        return;
    if (sign < 0)
        std::swap(points[2], points[3]);
    const PlacedCell cell = placedCell(*dataset_.positions, points);
    std::array<double, 4> values{};
    for (std::size_t corner = 0; corner < 4; ++corner)
        values[corner] = dataset_.values.at(points[corner]);
    const TetrahedronPlanes planes(cell);
    const auto mayMeet = [&planes](const Eigen::AlignedBox3d& box) { return planes.mayMeet(box); };
    mesh_.original.gridPoints->visitNear(mayMeet, [&](std::uint64_t point) {
        const Eigen::Vector3d& place = (*dataset_.positions)[point];
        if (residuals_.at(point) > 0 && mayMeet({place, place}) && holds(cell, place))
            residuals_.lower(point, mesh_.weight(point) * errorIn(cell, values, point));
    });
}

void PlaceErrors::judge(std::uint64_t point, double error)
{
    if (!(error > allowed(point)))
        return;
    const auto [i, j, k] = dataset_.lattice.coordinates(point);
    tooLarge_.add(point, [&] {
        return error_.moreThanClaimed(point, "the place in space of sample " + textOf(LatticePoint{i, j, k}), error) +
               ".";
    });
}

double PlaceErrors::leastErrorWithin(const TriangleTree& tree, std::uint64_t point, double radius) const
{
    const double sample = dataset_.values.at(point);
    double least = std::numeric_limits<double>::infinity();
    tree.visitWithin((*dataset_.positions)[point], radius, [&](std::uint32_t triangle) {
        const Triangle& t = triangles_[triangle];
        const std::array<double, 3> values = {dataset_.values.at(t[0]), dataset_.values.at(t[1]),
                                              dataset_.values.at(t[2])};
        if (const auto range = valuesWithin(tree.corners(triangle), values, (*dataset_.positions)[point], radius))
            least = std::min(least, mesh_.weight(point) * std::max({0.0, (*range)[0] - sample, sample - (*range)[1]}));
    });
    return least;
}

void PlaceErrors::measureOutside(const TriangleTree& tree, std::uint64_t point)
{
    ++outside_;
    if (triangles_.empty()) { // of no mesh, which was said
        residuals_.lower(point, 0);
        return;
    }
    const TriangleTree::Nearest nearest = tree.nearest((*dataset_.positions)[point]);
    double there = 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
        there += nearest.place.weights[corner] * dataset_.values.at(triangles_[nearest.triangle][corner]);
    double error = mesh_.weight(point) * std::abs(there - dataset_.values.at(point));
    residuals_.lower(point, error);
    if (!isJudged_ || !(error > allowed(point)))
        return;
    const double radius = std::max(nearest.place.distance,
                                   mesh_.bounds.warping(point) / mesh_.weight(point) + mesh_.original.warpingAllowance);
    judge(point, std::min(error, leastErrorWithin(tree, point, radius)));
}

Status PlaceErrors::run(LevelReport& verdict, const Progress& progress)
{
    constexpr double cellsEnd = 0.7; // how far it is after this
    const MarkedText activity = Message::marked("Measuring the error in space");
    if (const Status done = verifyEach(mesh_.cells.size(), cellsAtOnce, activity, progress.part(0, cellsEnd),
                                       [this](std::size_t number) { measureIn(number); });
        !done)
        return done;
    const TriangleTree tree(*dataset_.positions, triangles_);
    const auto finish = [&](std::size_t point) {
        if (std::isinf(residuals_.at(point)))
            measureOutside(tree, point);
        else if (isJudged_)
            judge(point, residuals_.at(point));
    };
    if (const Status done = verifyEach(residuals_.size(), pointsAtOnce, activity, progress.part(cellsEnd, 1), finish);
        !done)
        return done;
    verdict.measured.errorInSpace = {residuals_.statistics(error_.percent(1)), outside_};
    tooLarge_.moveTo(verdict.failures);
    return {};
}

} // namespace

Status verifyErrorInSpace(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary, LevelReport& verdict,
                          const Progress& progress)
{
    return PlaceErrors(mesh, boundary).run(verdict, progress);
}

} // namespace tetra
