// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapse_orders.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace tetra {

namespace {

class Rounds {
public:
    Rounds(DecimatedMesh& mesh, double stopKey)
        : mesh_(mesh), stopKey_(stopKey), candidates_(mesh.vertexCount()), stale_(mesh.vertexCount(), true)
    {
        for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
            left_.push_back(vertex);
    }

    Status run(const Progress& progress);

private:
    Status lookAtStale(const Progress& progress);
    void collapseUpTo(double bound);
    double leastKey() const;

    DecimatedMesh& mesh_;
    double stopKey_;
    std::vector<std::uint32_t> left_; ///< vertices that were not removed
    std::vector<DecimatedMesh::Candidate> candidates_;
    std::vector<bool> stale_; ///< whether the candidate must be found again
};

Status Rounds::lookAtStale(const Progress& progress)
{
    constexpr std::uint32_t verticesBetweenReports = 1024;
    std::uint32_t looks = 0;
    for (const std::uint32_t vertex : left_) {
        if (!stale_[vertex])
            continue;
        candidates_[vertex] = mesh_.best(vertex);
        stale_[vertex] = false;
        if (++looks % verticesBetweenReports != 0)
            continue;
        if (progress.cancelled())
            return cancelledError("The decimation");
        progress.report(static_cast<double>(mesh_.log().collapseCount()) / mesh_.vertexCount(), "Collapsing in rounds");
    }
    return {};
}

/// What a collapse makes stale waits for the next round, so that no two stars meet.
void Rounds::collapseUpTo(double bound)
{
    std::vector<std::uint32_t> chosen;
    for (const std::uint32_t vertex : left_)
        if (candidates_[vertex].exists() && static_cast<double>(candidates_[vertex].key) <= bound)
            chosen.push_back(vertex);
    std::ranges::sort(chosen, {}, [this](std::uint32_t vertex) { return std::tuple(candidates_[vertex].key, vertex); });
    std::vector<bool> removed(mesh_.vertexCount(), false);
    for (const std::uint32_t vertex : chosen) {
        if (stale_[vertex])
            continue;
        if (!mesh_.collapse(vertex, candidates_[vertex].target)) {
            stale_[vertex] = true;
            continue;
        }
        removed[vertex] = true;
        for (const std::uint32_t touched : mesh_.touched())
            stale_[touched] = true;
    }
    std::erase_if(left_, [&removed](std::uint32_t vertex) { return removed[vertex]; });
}

/// The smallest key of all candidates, infinity if there are none.
double Rounds::leastKey() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t vertex : left_)
        if (candidates_[vertex].exists())
            least = std::min(least, static_cast<double>(candidates_[vertex].key));
    return least;
}

Status Rounds::run(const Progress& progress)
{
    double bound = 0;
    for (;;) {
        if (Status status = lookAtStale(progress); !status)
            return status;
        const double least = leastKey();
        if (least == std::numeric_limits<double>::infinity() || least > stopKey_)
            return {};
        if (least > bound)
            bound = std::min(2 * least, stopKey_);
        collapseUpTo(bound);
    }
}

} // namespace

Status decimateInRounds(DecimatedMesh& mesh, double stopKey, const Progress& progress)
{
    return Rounds(mesh, stopKey).run(progress);
}

} // namespace tetra
