// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapse_orders.h"
#include "core/mesh/decimation/vertex_gradients.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace tetra {

namespace {

/// What a collapse is estimated to do, and onto which neighbour.
struct Estimate {
    double measure;
    std::uint32_t vertex;
    std::uint32_t target;
    std::uint32_t version;
    bool operator<(const Estimate& other) const
    {
        return std::tie(other.measure, other.vertex) < std::tie(measure, vertex);
    }
};

class PaperOrder {
public:
    PaperOrder(DecimatedMesh& mesh, double warpingWeight, double stopKey)
        : mesh_(mesh), warpingWeight_(warpingWeight), stopKey_(stopKey), gradients_(mesh.vertexCount()),
          versions_(mesh.vertexCount(), 0)
    {
    }

    Status run(const Progress& progress);

private:
    void findGradient(std::uint32_t vertex)
    {
        gradients_[vertex] = vertexGradient(mesh_.tetrahedra(), mesh_.input().positions, mesh_.input().values, vertex);
    }
    void estimate(std::uint32_t vertex);
    void attempt(const Estimate& estimate);

    DecimatedMesh& mesh_;
    double warpingWeight_;
    double stopKey_;
    std::vector<Eigen::Vector3d> gradients_;
    std::vector<std::uint32_t> versions_; ///< of each vertex's newest estimate
    std::priority_queue<Estimate> queue_;
};

/// The neighbour of the most similar gradient is the target; the difference times the distance is what the field may
/// change by.
void PaperOrder::estimate(std::uint32_t vertex)
{
    const DecimationMesh& input = mesh_.input();
    Estimate best{std::numeric_limits<double>::infinity(), vertex, DecimatedMesh::none, ++versions_[vertex]};
    for (const std::uint32_t slot : mesh_.tetrahedra().star(vertex))
        for (const std::uint32_t other : mesh_.tetrahedra().vertices(slot)) {
            if (other == vertex || !mesh_.mayMove(vertex, other))
                continue;
            const double measure = (gradients_[vertex] - gradients_[other]).norm() *
                                   (input.positions[vertex] - input.positions[other]).norm();
            if (std::tie(measure, other) < std::tie(best.measure, best.target)) {
                best.measure = measure;
                best.target = other;
            }
        }
    if (best.target == DecimatedMesh::none)
        return;
    if (!input.box && mesh_.onBoundary(vertex))
        best.measure = std::max(
            best.measure, warpingWeight_ * distanceFromBoundaryPlane(mesh_.tetrahedra(), input.positions, vertex));
    queue_.push(best);
}

void PaperOrder::attempt(const Estimate& estimated)
{
    // What cannot go is out of the queue, which is the paper's tag, until its star changes.
    const DecimatedMesh::Candidate candidate = mesh_.judge(estimated.vertex, estimated.target);
    if (!candidate.exists() || static_cast<double>(candidate.key) > stopKey_ ||
        !mesh_.collapse(estimated.vertex, candidate.target))
        return;
    ++versions_[estimated.vertex];
    for (const std::uint32_t vertex : mesh_.touched())
        findGradient(vertex);
    for (const std::uint32_t vertex : mesh_.touched())
        estimate(vertex);
}

Status PaperOrder::run(const Progress& progress)
{
    constexpr std::uint32_t workBetweenReports = 1024;
    for (std::uint32_t vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
        findGradient(vertex);
    for (std::uint32_t vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
        estimate(vertex);
    std::uint32_t work = 0;
    while (!queue_.empty()) {
        if (++work % workBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError("The decimation");
            progress.report(static_cast<double>(mesh_.log().collapseCount()) / mesh_.vertexCount(), "Collapsing");
        }
        const Estimate next = queue_.top();
        queue_.pop();
        if (versions_[next.vertex] == next.version)
            attempt(next);
    }
    return {};
}

} // namespace

Status decimateByEstimates(DecimatedMesh& mesh, double warpingWeight, double stopKey, const Progress& progress)
{
    return PaperOrder(mesh, warpingWeight, stopKey).run(progress);
}

} // namespace tetra
