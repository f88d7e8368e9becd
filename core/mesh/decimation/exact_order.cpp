// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapse_orders.h"

#include "core/mesh/decimation/collapse_queue.h"

#include <limits>
#include <vector>

namespace tetra {

namespace {

/// How much larger the key at hand is when vertices are looked at again that could not go.
constexpr float patience = 1.02F;

constexpr std::uint32_t workBetweenReports = 1024;

using Entry = CollapseQueue::Entry; // the best collapse of a vertex, when it was looked at

class ExactOrder {
public:
    ExactOrder(DecimatedMesh& mesh, double stopKey) : mesh_(mesh), stopKey_(stopKey), states_(mesh.vertexCount()) {}

    Status run(const Progress& progress);

private:
    struct VertexState {
        std::uint32_t version = 0; ///< of the vertex's newest entry
        bool queued = true;        ///< whether that is in the queue, or the first look is still to come
        bool changed = false;      ///< whether something around the vertex has changed since it was made
    };

    Entry evaluated(std::uint32_t vertex, DecimatedMesh::Legality legality);
    void collapse(const Entry& entry);
    void fetchAhead() const;

    void look(std::uint32_t vertex);
    void takeFirst();
    float leastKey();
    Status lookAtAll(const Progress& progress);

    DecimatedMesh& mesh_;
    double stopKey_;
    std::vector<VertexState> states_;
    CollapseQueue queue_;
    bool allLookedAt_ = false;
};

/// The vertex is queued then if it can go; the entry is still to be pushed.
Entry ExactOrder::evaluated(std::uint32_t vertex, DecimatedMesh::Legality legality)
{
    const DecimatedMesh::Candidate candidate = mesh_.best(vertex, legality);
    VertexState& state = states_[vertex];
    ++state.version;
    state.changed = false;
    state.queued = candidate.exists() && static_cast<double>(candidate.key) <= stopKey_;
    return {candidate.key, vertex, candidate.target, state.version};
}

void ExactOrder::collapse(const Entry& entry)
{
    if (!mesh_.collapse(entry.vertex, entry.target)) {
        const Entry other = evaluated(entry.vertex, DecimatedMesh::Legality::Whole);
        if (states_[entry.vertex].queued)
            queue_.push(other);
        return;
    }
    states_[entry.vertex].queued = false;
    for (const std::uint32_t vertex : mesh_.touched())
        __builtin_prefetch(&states_[vertex]);
    for (const std::uint32_t vertex : mesh_.touched()) {
        VertexState& state = states_[vertex];
        state.changed = true;
        if (state.queued)
            continue;
        // What could not go may be able to now. Its turn to be looked at comes a little later, after more has changed.
        state.queued = true;
        queue_.push({patience * entry.key, vertex, DecimatedMesh::none, ++state.version});
    }
}

/// What the entries to come need, each time what the last time's told where to find.
void ExactOrder::fetchAhead() const
{
    const auto at = [this](std::size_t distance) { return queue_.vertexAhead(distance, DecimatedMesh::none); };
    if (const std::uint32_t vertex = at(7); vertex != DecimatedMesh::none)
        __builtin_prefetch(&states_[vertex]);
    for (int step = 0; step < DecimatedMesh::fetchSteps; ++step) {
        const std::uint32_t vertex = at(static_cast<std::size_t>(DecimatedMesh::fetchSteps - step));
        if (vertex != DecimatedMesh::none && states_[vertex].queued)
            mesh_.fetchAhead(vertex, step);
    }
}

/// No collapse that is known has a smaller key. While some were not looked at, they may have any.
float ExactOrder::leastKey()
{
    if (!allLookedAt_)
        return 0;
    return queue_.empty() ? std::numeric_limits<float>::infinity() : queue_.leastKey();
}

/// Looks at a vertex whose entry has come to the head, and does what it may if nothing else should come first.
void ExactOrder::look(std::uint32_t vertex)
{
    const Entry entry = evaluated(vertex, DecimatedMesh::Legality::OfStar);
    if (!states_[vertex].queued)
        return;
    if (entry.key <= leastKey())
        collapse(entry);
    else
        queue_.push(entry);
}

/// What does no harm goes at once: then what is around it is looked at once.
Status ExactOrder::lookAtAll(const Progress& progress)
{
    const std::uint32_t vertices = mesh_.vertexCount();
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
        if (vertex % workBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError("The decimation");
            progress.report(.2 * vertex / vertices, "Evaluating vertices");
        }
        const Entry entry = evaluated(vertex, DecimatedMesh::Legality::OfStar);
        if (!states_[vertex].queued)
            continue;
        if (entry.key == 0)
            collapse(entry);
        else
            queue_.push(entry);
        while (!queue_.empty() && queue_.leastKey() == 0)
            takeFirst();
    }
    allLookedAt_ = true;
    return {};
}

/// Does what the first entry asks for, if it still holds.
void ExactOrder::takeFirst()
{
    const Entry entry = queue_.pop();
    fetchAhead();
    const VertexState& state = states_[entry.vertex];
    if (state.version != entry.version || !state.queued)
        return;
    if (state.changed)
        look(entry.vertex);
    else
        collapse(entry);
}

Status ExactOrder::run(const Progress& progress)
{
    if (Status status = lookAtAll(progress); !status)
        return status;
    const std::uint32_t vertices = mesh_.vertexCount();
    std::uint32_t work = 0;
    while (!queue_.empty()) {
        if (++work % workBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError("The decimation");
            progress.report(.2 + .8 * mesh_.log().collapseCount() / vertices, "Collapsing");
        }
        takeFirst();
    }
    return {};
}

} // namespace

Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress)
{
    return ExactOrder(mesh, stopKey).run(progress);
}

} // namespace tetra
