// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/boundary_check.h"

#include "core/cells/boundary_manifold.h"
#include "core/cells/box_tree.h"
#include "core/cells/triangle_meeting.h"

#include <optional>
#include <random>
#include <vector>

namespace tetra {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint64_t enoughMeetings = 100000;

class BoundaryChecking {
public:
    BoundaryChecking(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles)
        : positions_(positions), triangles_(triangles), boxes_(boxesOf(positions, triangles)), tree_(boxes_)
    {
        for (const Eigen::AlignedBox3d& box : boxes_)
            all_.extend(box);
    }

    BoundaryFaults run(const Progress& progress)
    {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (progress.cancelled() || faults_.meetings > enoughMeetings)
                return faults_;
            findMeetings(t);
        }
        if (faults_.meetings == 0)
            findBuried(progress);
        return faults_;
    }

private:
    static std::vector<Eigen::AlignedBox3d> boxesOf(std::span<const Eigen::Vector3d> positions,
                                                    std::span<const Triangle> triangles)
    {
        std::vector<Eigen::AlignedBox3d> boxes(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t vertex : triangles[t])
                boxes[t].extend(positions[vertex]);
        return boxes;
    }

    void findMeetings(std::uint32_t t)
    {
        const auto near = [&](const Eigen::AlignedBox3d& box) { return box.intersects(boxes_[t]); };
        tree_.forEach(near, [&](std::uint32_t other) {
            if (other <= t || !trianglesMeet(positions_, triangles_[t], triangles_[other]))
                return;
            if (faults_.meetings++ == 0)
                faults_.meeting = {t, other};
        });
    }

    void findBuried(const Progress& progress)
    {
        const std::vector<std::uint32_t> components = surfaceComponents(triangles_);
        std::vector<std::uint32_t> firsts; // a triangle of each
        std::vector<double> volumes;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (components[t] == firsts.size()) {
                firsts.push_back(t);
                volumes.push_back(0);
            }
            const Eigen::Vector3d& origin = positions_[triangles_[firsts[components[t]]][0]];
            const auto& [a, b, c] = triangles_[t];
            volumes[components[t]] +=
                (positions_[a] - origin).dot((positions_[b] - origin).cross(positions_[c] - origin));
        }
        for (std::uint32_t component = 0; component < firsts.size() && !progress.cancelled(); ++component) {
            // The outside of a cavity's surface is what it encloses, where its own winding number is -1.
            const int own = volumes[component] < 0 ? -1 : 0;
            if (firsts.size() == 1 && own == 0)
                return;
            if (own + windingOfOthers(component, positions_[triangles_[firsts[component]][0]], components) == 0)
                continue;
            if (faults_.buried++ == 0)
                faults_.buriedTriangle = firsts[component];
        }
    }

    /// How often the other components wind around a point that is not on them.
    int windingOfOthers(std::uint32_t component, const Eigen::Vector3d& from,
                        const std::vector<std::uint32_t>& components)
    {
        for (;;) {
            Eigen::Vector3d direction;
            for (double& coordinate : direction)
                coordinate = std::uniform_real_distribution(0.3, 1.0)(random_);
            const Eigen::Vector3d to = from + (3 * all_.diagonal().norm() + 1) * direction;
            if (const auto winding = windingAlong(component, from, to, components))
                return *winding;
        }
    }

    std::optional<int> windingAlong(std::uint32_t component, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                    const std::vector<std::uint32_t>& components) const
    {
        const Eigen::Vector3d way = to - from;
        const auto near = [&](const Eigen::AlignedBox3d& box) {
            // All its directions rise: where it enters the box is before it leaves. With room for rounding.
            constexpr double room = 1e-9;
            const Eigen::Array3d enters = (box.min() - from).array() / way.array();
            const Eigen::Array3d leaves = (box.max() - from).array() / way.array();
            return enters.maxCoeff() - room <= leaves.minCoeff() + room && leaves.minCoeff() >= -room;
        };
        int winding = 0;
        bool unclear = false;
        tree_.forEach(near, [&](std::uint32_t t) {
            if (unclear || components[t] == component)
                return;
            const auto& [a, b, c] = triangles_[t];
            const Crossing crossing = crossingOf(from, to, positions_[a], positions_[b], positions_[c]);
            unclear = crossing == Crossing::Unclear;
            winding += crossing == Crossing::Leaving ? 1 : crossing == Crossing::Entering ? -1 : 0;
        });
        return unclear ? std::nullopt : std::optional(winding);
    }

    std::span<const Eigen::Vector3d> positions_;
    std::span<const Triangle> triangles_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    BoxTree tree_;
    Eigen::AlignedBox3d all_;
    std::mt19937 random_{1};
    BoundaryFaults faults_;
};

} // namespace

BoundaryFaults checkBoundary(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles,
                             const Progress& progress)
{
    return BoundaryChecking(positions, triangles).run(progress);
}

} // namespace tetra
