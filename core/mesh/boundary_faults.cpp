// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary_faults.h"

#include "core/mesh/boundary.h"

#include <algorithm>
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

/// Looks from each component of a surface which side of the others it is on.
class BuriedSearch {
public:
    BuriedSearch(std::span<const Eigen::Vector3d> positions, std::span<const SurfaceTriangle> triangles)
        : positions_(positions), triangles_(triangles), components_(surfaceComponents(triangles))
    {
    }

    std::vector<std::uint32_t> run(const Progress& progress)
    {
        std::vector<std::uint32_t> firsts; // a triangle of each
        std::vector<double> volumes;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (components_[t] == firsts.size()) {
                firsts.push_back(t);
                volumes.push_back(0);
            }
            const Eigen::Vector3d& origin = positions_[triangles_[firsts[components_[t]]][0]];
            const auto& [a, b, c] = triangles_[t];
            volumes[components_[t]] +=
                (positions_[a] - origin).dot((positions_[b] - origin).cross(positions_[c] - origin));
        }
        std::vector<std::uint32_t> buried;
        if (firsts.size() == 1 && volumes[0] >= 0)
            return buried;
        const TriangleBoxes boxes(positions_, triangles_);
        Eigen::AlignedBox3d all;
        for (const Eigen::AlignedBox3d& box : boxes.boxes())
            all.extend(box);
        for (std::uint32_t component = 0; component < firsts.size() && !progress.cancelled(); ++component) {
            // The outside of a cavity's surface is what it encloses, where its own winding number is -1.
            const int own = volumes[component] < 0 ? -1 : 0;
            const Eigen::Vector3d& from = positions_[triangles_[firsts[component]][0]];
            if (own + windingOfOthers(boxes, component, from, 3 * all.diagonal().norm() + 1) != 0)
                buried.push_back(firsts[component]);
        }
        return buried;
    }

private:
    /// How often the other components wind around a point that is not on them.
    int windingOfOthers(const TriangleBoxes& boxes, std::uint32_t component, const Eigen::Vector3d& from,
                        double beyondAll)
    {
        for (;;) {
            Eigen::Vector3d direction;
            for (double& coordinate : direction)
                coordinate = std::uniform_real_distribution(0.3, 1.0)(random_);
            if (const auto winding = windingAlong(boxes, component, from, from + beyondAll * direction))
                return *winding;
        }
    }

    std::optional<int> windingAlong(const TriangleBoxes& boxes, std::uint32_t component, const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to) const
    {
        const Eigen::Vector3d way = to - from;
        const auto near = [&](const Eigen::AlignedBox3d& box) {
            // All its directions rise: where it enters the box is before it leaves. With room for rounding.
            constexpr double tolerance = 1e-9;
            const Eigen::Array3d enters = (box.min() - from).array() / way.array();
            const Eigen::Array3d leaves = (box.max() - from).array() / way.array();
            return enters.maxCoeff() - tolerance <= leaves.minCoeff() + tolerance && leaves.minCoeff() >= -tolerance;
        };
        int winding = 0;
        bool unclear = false;
        boxes.tree().visitNear(near, [&](std::uint32_t t) {
            if (unclear || components_[t] == component || !near(boxes.boxes()[t]))
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
    std::vector<std::uint32_t> components_;
    std::mt19937 random_{1};
};

} // namespace

std::vector<std::uint32_t> findBuried(std::span<const Eigen::Vector3d> positions,
                                      std::span<const SurfaceTriangle> triangles, const Progress& progress)
{
    return triangles.empty() ? std::vector<std::uint32_t>() : BuriedSearch(positions, triangles).run(progress);
}

BoundaryFaults findBoundaryFaults(std::span<const Eigen::Vector3d> positions,
                                  std::span<const SurfaceTriangle> triangles, const Progress& progress)
{
    constexpr std::size_t enoughMeetings = 100000;
    BoundaryFaults faults;
    const TriangleBoxes boxes(positions, triangles);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (progress.cancelled() || faults.meetings.size() > enoughMeetings)
            return faults;
        boxes.visitMeeting(
            triangles[t], [t](std::uint32_t other) { return other > t; },
            [&](std::uint32_t other) {
                faults.meetings.push_back({t, other});
            });
    }
    if (faults.meetings.empty())
        faults.buried = findBuried(positions, triangles, progress);
    return faults;
}

} // namespace tetra
