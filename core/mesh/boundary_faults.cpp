// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary_faults.h"

#include "core/mesh/boundary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace tetra {

namespace {

std::vector<Eigen::AlignedBox3d> boxesOf(std::span<const Eigen::Vector3d> positions,
                                         std::span<const SurfaceTriangle> triangles)
{
    std::vector<Eigen::AlignedBox3d> boxes(triangles.size());
    std::ranges::transform(triangles, boxes.begin(),
                           [&](const SurfaceTriangle& triangle) { return TriangleBoxes::boxOf(positions, triangle); });
    return boxes;
}

} // namespace

TriangleBoxes::TriangleBoxes(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles)
    : positions_(positions), triangles_(triangles), boxes_(boxesOf(positions, triangles)),
      tree_(
          boxes_.size(), [this](std::uint32_t t) -> const Eigen::AlignedBox3d& { return boxes_[t]; },
          [this](std::uint32_t t, Eigen::Index axis) { return boxes_[t].center()[axis]; })
{
}

Eigen::AlignedBox3d TriangleBoxes::boxOf(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle)
{
    Eigen::AlignedBox3d box;
    for (const std::uint32_t vertex : triangle)
        box.extend(positions[vertex]);
    return box;
}

namespace {

/// Looks from each piece of a surface what is on its outer side.
class BuriedSearch {
public:
    BuriedSearch(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles)
        : positions_(positions), triangles_(triangles)
    {
    }

    std::vector<std::uint32_t> run(const std::vector<bool>& touched, const Progress& progress)
    {
        const std::vector<std::uint32_t> pieces = surfacePieces(triangles_, touched);
        std::vector<std::uint32_t> probes; // of each piece: its largest triangle, where there is most room
        std::vector<double> areas;
        double volume = 0;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (pieces[t] == probes.size()) {
                probes.push_back(t);
                areas.push_back(0);
            }
            if (const double area = normalOf(t).norm(); area > areas[pieces[t]]) {
                areas[pieces[t]] = area;
                probes[pieces[t]] = t;
            }
            const Eigen::Vector3d& origin = positions_[triangles_[0][0]];
            volume += (positions_[triangles_[t][0]] - origin).dot(normalOf(t));
        }
        std::vector<std::uint32_t> buried;
        if (probes.size() == 1 && volume > 0)
            return buried;
        const TriangleBoxes boxes(positions_, triangles_);
        Eigen::AlignedBox3d all;
        for (const Eigen::AlignedBox3d& box : boxes.boxes())
            all.extend(box);
        const double beyondAll = 8 * all.diagonal().norm() + 1;
        for (const std::uint32_t probe : probes)
            if (!progress.cancelled() && (touched.empty() || !touched[probe]) &&
                windingOutside(boxes, probe, beyondAll) != 0)
                buried.push_back(probe);
        return buried;
    }

private:
    Eigen::Vector3d normalOf(std::uint32_t t) const
    {
        const auto& [a, b, c] = triangles_[t];
        return (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]);
    }

    /// How often the surface winds around the place just outside the middle of a triangle that nothing touches.
    int windingOutside(const TriangleBoxes& boxes, std::uint32_t triangle, double beyondAll)
    {
        const auto& [a, b, c] = triangles_[triangle];
        const Eigen::Vector3d from = (positions_[a] + positions_[b] + positions_[c]) / 3;
        const Eigen::Vector3d normal = normalOf(triangle).normalized();
        for (;;) {
            Eigen::Vector3d direction;
            for (double& coordinate : direction)
                coordinate = std::uniform_real_distribution(-1.0, 1.0)(random_);
            constexpr double steepEnough = 0.25;
            if (std::abs(direction.dot(normal)) < steepEnough)
                continue;
            if (direction.dot(normal) < 0)
                direction = -direction;
            if (const auto winding = windingAlong(boxes, triangle, from, from + beyondAll * direction))
                return *winding;
        }
    }

    std::optional<int> windingAlong(const TriangleBoxes& boxes, std::uint32_t leftOut, const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to) const
    {
        const Eigen::Array3d way = (to - from).array();
        const auto near = [&](const Eigen::AlignedBox3d& box) {
            // Where the line enters the box is before it leaves. With room for rounding.
            constexpr double tolerance = 1e-9;
            const Eigen::Array3d one = (box.min() - from).array() / way, other = (box.max() - from).array() / way;
            const double enters = one.min(other).maxCoeff(), leaves = one.max(other).minCoeff();
            return enters - tolerance <= leaves + tolerance && leaves >= -tolerance;
        };
        int winding = 0;
        bool unclear = false;
        boxes.tree().visitNear(near, [&](std::uint32_t t) {
            if (unclear || t == leftOut || !near(boxes.boxes()[t]))
                return;
            const auto& [a, b, c] = triangles_[t];
            const Crossing crossing = crossingOf(from, to, positions_[a], positions_[b], positions_[c]);
            unclear = crossing == Crossing::Unclear;
            winding += crossing == Crossing::Leaving ? 1 : crossing == Crossing::Entering ? -1 : 0;
        });
        return unclear ? std::nullopt : std::optional(winding);
    }

    std::span<const Eigen::Vector3d> positions_;
    std::span<const SurfaceTriangle> triangles_;
    std::mt19937 random_{1};
};

} // namespace

std::vector<std::uint32_t> findBuried(std::span<const Eigen::Vector3d> positions,
                                      std::span<const SurfaceTriangle> triangles, const std::vector<bool>& touched,
                                      const Progress& progress)
{
    return triangles.empty() ? std::vector<std::uint32_t>() : BuriedSearch(positions, triangles).run(touched, progress);
}

std::vector<bool> findTouched(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles,
                              const Progress& progress)
{
    constexpr std::size_t enoughMeetings = 100000;
    std::vector<bool> touched(triangles.size());
    const TriangleBoxes boxes(positions, triangles);
    std::size_t meetings = 0;
    for (std::uint32_t t = 0; t < triangles.size() && !progress.cancelled(); ++t) {
        boxes.visitMeeting(
            triangles[t], [t](std::uint32_t other) { return other > t; },
            [&](std::uint32_t other) {
                ++meetings;
                touched[t] = touched[other] = true;
            });
        if (meetings > enoughMeetings)
            return std::vector<bool>(triangles.size(), true);
    }
    return touched;
}

} // namespace tetra
