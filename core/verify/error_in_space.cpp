// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/error_in_space.h"

#include "core/mesh/topology.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr std::size_t cellsAtOnce = 8; // the first few of a coarse mesh hold all points
constexpr std::size_t pointsAtOnce = 256;

class SpaceErrors {
public:
    SpaceErrors(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary)
        : mesh_(mesh), dataset_(mesh.original.dataset),
          residuals_(dataset_.pointCount(), std::numeric_limits<double>::infinity())
    {
        for (const BoundaryFace& face : boundary)
            triangles_.push_back({mesh.cells.point(face.vertices[0]), mesh.cells.point(face.vertices[1]),
                                  mesh.cells.point(face.vertices[2])});
    }

    Status run(ErrorInSpace& found, const Progress& progress);

private:
    void measureIn(std::size_t number);
    double errorIn(const PlacedCell& cell, const std::array<double, 4>& values, std::uint64_t point) const;
    double errorOutside(const TriangleTree& tree, std::uint64_t point) const;

    const MeshToVerify& mesh_;
    const Dataset& dataset_;
    std::vector<Triangle> triangles_; ///< the boundary, by points
    PointResiduals residuals_;        ///< infinite where no cell was found yet
};

double SpaceErrors::errorIn(const PlacedCell& cell, const std::array<double, 4>& values, std::uint64_t point) const
{
    constexpr double enough = 1e-12; // of the range
    const Eigen::Vector3d& place = (*dataset_.positions)[point];
    const double sample = dataset_.values.at(point);
    const CellError quick = quickError(cell, values, place, sample);
    return quick.doubt <= enough * mesh_.original.extent ? quick.error : preciseError(cell, values, place, sample);
}

void SpaceErrors::measureIn(std::size_t number)
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

double SpaceErrors::errorOutside(const TriangleTree& tree, std::uint64_t point) const
{
    const TriangleTree::Nearest nearest = tree.nearest((*dataset_.positions)[point]);
    double there = 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
        there += nearest.place.weights[corner] * dataset_.values.at(triangles_[nearest.triangle][corner]);
    return mesh_.weight(point) * std::abs(there - dataset_.values.at(point));
}

Status SpaceErrors::run(ErrorInSpace& found, const Progress& progress)
{
    constexpr double cellsEnd = 0.7; // how far it is after this
    const MarkedText activity = Message::marked("Measuring the error in space");
    if (const Status done = verifyEach(mesh_.cells.size(), cellsAtOnce, activity, progress.part(0, cellsEnd),
                                       [this](std::size_t number) { measureIn(number); });
        !done)
        return done;
    const TriangleTree tree(*dataset_.positions, triangles_);
    std::atomic<std::uint64_t> outside = 0;
    const auto measureOutside = [&](std::size_t point) {
        if (std::isfinite(residuals_.at(point)))
            return;
        ++outside;
        residuals_.lower(point, triangles_.empty() ? 0 : errorOutside(tree, point));
    };
    if (const Status done =
            verifyEach(residuals_.size(), pointsAtOnce, activity, progress.part(cellsEnd, 1), measureOutside);
        !done)
        return done;
    found = {residuals_.statistics(Residual::error(mesh_).percent(1)), outside};
    return {};
}

} // namespace

Status measureErrorInSpace(const MeshToVerify& mesh, std::span<const BoundaryFace> boundary, ErrorInSpace& found,
                           const Progress& progress)
{
    return SpaceErrors(mesh, boundary).run(found, progress);
}

} // namespace tetra
