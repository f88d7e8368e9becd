// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_orders.h"

#include "core/base/sort_unique.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetra {

namespace {

bool comesAfter(const CollapseQueue::Entry& one, const CollapseQueue::Entry& other)
{
    return one.comesAfter(other);
}

} // namespace

std::size_t CollapseQueue::classOf(float key)
{
    return std::bit_cast<std::uint32_t>(key) >> classBits & (classCount - 1);
}

void CollapseQueue::push(const Entry& entry)
{
    ++size_;
    const std::size_t own = classOf(entry.key);
    if (own > open_) {
        classes_[own].push_back(entry);
        return;
    }
    late_.push_back(entry);
    std::ranges::push_heap(late_, comesAfter);
}

float CollapseQueue::leastKey()
{
    if (sorted_.empty() && late_.empty())
        openNextClass();
    return lateIsFirst() ? late_.front().key : sorted_.back().key;
}

CollapseQueue::Entry CollapseQueue::pop()
{
    if (sorted_.empty() && late_.empty())
        openNextClass();
    --size_;
    std::vector<Entry>& from = lateIsFirst() ? late_ : sorted_;
    if (&from == &late_)
        std::ranges::pop_heap(late_, comesAfter);
    const Entry first = from.back();
    from.pop_back();
    return first;
}

/// One of the two is not empty.
bool CollapseQueue::lateIsFirst() const
{
    return sorted_.empty() || (!late_.empty() && sorted_.back().comesAfter(late_.front()));
}

void CollapseQueue::openNextClass()
{
    while (classes_[open_].empty())
        ++open_;
    sorted_ = std::move(classes_[open_]);
    classes_[open_] = {};
    std::ranges::sort(sorted_, comesAfter);
}

namespace {

/// How much larger the key at hand is when vertices are looked at again that could not go.
constexpr float patience = 1.02F;

constexpr std::uint32_t workBetweenReports = 1024;

using Entry = CollapseQueue::Entry; // the best collapse of a vertex, when it was looked at

/// What an order does between collapses now and then, and where it begins.
class Pauses {
public:
    Pauses(const Progress& progress, SavedState* state) : progress_(progress), state_(state) {}

    /// Whether there is an earlier build to go on from; the order is then where that was.
    template <class Order> Result<bool> goneOn(Order& order)
    {
        if (state_ == nullptr || !state_->found())
            return false;
        progress_.report(0, Message::marked("Restoring the interrupted build"));
        if (const Status loaded = state_->load(order); !loaded)
            return loaded.error();
        return true;
    }
    template <class Order> Status pause(Order& order, double fraction, MarkedText activity)
    {
        const bool cancelled = progress_.cancelled();
        if (state_ != nullptr)
            state_->pause(order, cancelled);
        if (cancelled)
            return cancelledError(Message::marked("The decimation"));
        progress_.report(fraction, activity);
        return {};
    }

private:
    const Progress& progress_;
    SavedState* state_;
};

class ExactOrder {
public:
    ExactOrder(DecimatedMesh& mesh, double stopKey) : mesh_(mesh), stopKey_(stopKey), states_(mesh.vertexCount()) {}

    Status run(Pauses& pauses);
    void archive(StateArchive& archive) { archive(mesh_, states_, queue_, lookedAt_); }

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
    Status lookAtAll(Pauses& pauses);

    DecimatedMesh& mesh_;
    double stopKey_;
    std::vector<VertexState> states_;
    CollapseQueue queue_;
    std::uint32_t lookedAt_ = 0; ///< vertices, the first ones
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
    if (!mesh_.collapse(entry.vertex, {entry.target, entry.key})) {
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
    if (lookedAt_ < mesh_.vertexCount())
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
Status ExactOrder::lookAtAll(Pauses& pauses)
{
    const std::uint32_t vertices = mesh_.vertexCount();
    for (; lookedAt_ < vertices; ++lookedAt_) {
        if (lookedAt_ % workBetweenReports == 0)
            if (Status status = pauses.pause(*this, .2 * lookedAt_ / vertices, Message::marked("Evaluating vertices"));
                !status)
                return status;
        const Entry entry = evaluated(lookedAt_, DecimatedMesh::Legality::OfStar);
        if (!states_[lookedAt_].queued)
            continue;
        if (entry.key == 0)
            collapse(entry);
        else
            queue_.push(entry);
        while (!queue_.empty() && queue_.leastKey() == 0)
            takeFirst();
    }
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

Status ExactOrder::run(Pauses& pauses)
{
    if (const auto goneOn = pauses.goneOn(*this); !goneOn.ok())
        return goneOn.error();
    if (Status status = lookAtAll(pauses); !status)
        return status;
    const std::uint32_t vertices = mesh_.vertexCount();
    std::uint32_t work = 0;
    while (!queue_.empty()) {
        if (++work % workBetweenReports == 0)
            if (Status status = pauses.pause(*this, .2 + .8 * mesh_.log().collapseCount() / vertices,
                                             Message::marked("Collapsing"));
                !status)
                return status;
        takeFirst();
    }
    return {};
}

} // namespace

Status decimateByExactError(DecimatedMesh& mesh, double stopKey, const Progress& progress, SavedState* state)
{
    Pauses pauses(progress, state);
    return ExactOrder(mesh, stopKey).run(pauses);
}

namespace {

/// The neighbours of a boundary vertex along the boundary, each once.
std::vector<std::uint32_t> neighboursOnBoundary(const DecimatedMesh& mesh, std::uint32_t vertex)
{
    std::vector<std::uint32_t> around;
    const CollapsibleMesh& tetrahedra = mesh.tetrahedra();
    const auto addFace = [&](std::span<const std::uint32_t> corners) {
        std::ranges::copy_if(corners, std::back_inserter(around), [vertex](auto corner) { return corner != vertex; });
    };
    for (const std::uint32_t slot : tetrahedra.star(vertex)) {
        const std::size_t own = indexOf(tetrahedra.vertices(slot), vertex);
        for (std::size_t opposite = 0; opposite < 4; ++opposite)
            if (opposite != own && mesh.isOnBoundary(slot, opposite))
                addFace(tetrahedra.cornersOfFaceOf(slot, opposite));
    }
    sortUnique(around);
    return around;
}

/// How far a boundary vertex lies from the plane that fits its neighbours on the boundary best.
double distanceFromPlane(const DecimatedMesh& mesh, std::uint32_t vertex)
{
    const std::vector<std::uint32_t> around = neighboursOnBoundary(mesh, vertex);
    if (around.empty())
        return 0;
    const DecimationMesh& input = mesh.input();
    const std::span<const Eigen::Vector3d> positions = input.physical.empty() ? input.positions : input.physical;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t other : around)
        middle += positions[other];
    middle /= static_cast<double>(around.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::uint32_t other : around)
        spread += (positions[other] - middle) * (positions[other] - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    return std::abs(axes.eigenvectors().col(0).dot(positions[vertex] - middle));
}

} // namespace

Eigen::Vector3d vertexGradient(const DecimatedMesh& mesh, std::uint32_t vertex)
{
    const std::span<const Eigen::Vector3d> positions = mesh.input().positions;
    const std::span<const double> values = mesh.input().values;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double angles = 0;
    for (const std::uint32_t slot : mesh.tetrahedra().star(vertex)) {
        const auto& vertices = mesh.tetrahedra().vertices(slot);
        const auto& others = cornersOfFace[indexOf(vertices, vertex)];
        Eigen::Matrix3d edges;
        Eigen::Vector3d steps;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t other = vertices[others[static_cast<std::size_t>(i)]];
            edges.row(i) = positions[other] - positions[vertex];
            steps[i] = values[other] - values[vertex];
        }
        const Eigen::Vector3d a = edges.row(0), b = edges.row(1), c = edges.row(2);
        const double angle =
            2 * std::atan2(std::abs(edges.determinant()), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                              a.dot(c) * b.norm() + b.dot(c) * a.norm());
        sum += angle * (edges.inverse() * steps);
        angles += angle;
    }
    return angles > 0 ? Eigen::Vector3d(sum / angles) : sum;
}

CollapseEstimate estimateCollapse(const DecimatedMesh& mesh, std::span<const Eigen::Vector3d> gradients,
                                  std::uint32_t vertex)
{
    CollapseEstimate best;
    for (const std::uint32_t slot : mesh.tetrahedra().star(vertex))
        for (const std::uint32_t other : mesh.tetrahedra().vertices(slot)) {
            if (other == vertex || !mesh.mayMove(vertex, other))
                continue;
            const double difference = (gradients[vertex] - gradients[other]).norm();
            if (std::tie(difference, other) < std::tie(best.gradientDifference, best.target)) {
                best.gradientDifference = difference;
                best.target = other;
            }
        }
    if (best.target != DecimatedMesh::none && mesh.warps() && mesh.onBoundary(vertex))
        best.planeDistance = distanceFromPlane(mesh, vertex);
    return best;
}

namespace {

class PaperOrder {
public:
    PaperOrder(DecimatedMesh& mesh, double warpingWeight, double stopKey)
        : mesh_(mesh), warpingWeight_(warpingWeight), stopKey_(stopKey), versions_(mesh.vertexCount(), 0)
    {
    }

    Status run(Pauses& pauses);
    void archive(StateArchive& archive) { archive(mesh_, versions_, byError_, byWarping_, error_, warping_); }

private:
    /// A vertex in one of the two queues, the smallest estimates first.
    struct Entry {
        std::array<double, 2> measures; ///< that of the queue, then the other
        std::uint32_t vertex;
        std::uint32_t target;
        std::uint32_t version;
        bool operator<(const Entry& other) const
        {
            return std::tie(other.measures, other.vertex) < std::tie(measures, vertex);
        }
    };
    struct Queue : std::priority_queue<Entry> {
        void archive(StateArchive& archive) { archive(c); }
    };

    void estimate(std::uint32_t vertex);
    std::optional<Entry> takeFirst();
    void attempt(const Entry& entry);
    void noteAccuracy();

    DecimatedMesh& mesh_;
    double warpingWeight_;
    double stopKey_;
    std::vector<Eigen::Vector3d> gradients_; ///< of the input, as the paper has them
    std::vector<std::uint32_t> versions_;    ///< of each vertex's newest estimate
    Queue byError_;
    Queue byWarping_; ///< of meshes that warp
    // What the mesh has come to, the worst so far.
    float error_ = 0;
    float warping_ = 0;
};

void PaperOrder::estimate(std::uint32_t vertex)
{
    const CollapseEstimate found = estimateCollapse(mesh_, gradients_, vertex);
    ++versions_[vertex];
    if (found.target == DecimatedMesh::none)
        return;
    const double error = found.gradientDifference, warping = found.planeDistance;
    byError_.push({{error, warping}, vertex, found.target, versions_[vertex]});
    if (mesh_.warps())
        byWarping_.push({{warping, error}, vertex, found.target, versions_[vertex]});
}

/// The vertex that is expected to do the least harm to what is worse off, by W / E against delta / eps.
std::optional<PaperOrder::Entry> PaperOrder::takeFirst()
{
    const bool warpingCounts =
        mesh_.warps() && warpingWeight_ * static_cast<double>(warping_) > static_cast<double>(error_);
    Queue& queue = warpingCounts ? byWarping_ : byError_;
    while (!queue.empty()) {
        const Entry first = queue.top();
        queue.pop();
        if (versions_[first.vertex] == first.version)
            return first;
    }
    return std::nullopt;
}

void PaperOrder::attempt(const Entry& entry)
{
    // What cannot go is out of the queues, which is the paper's tag, until its star changes.
    ++versions_[entry.vertex];
    const DecimatedMesh::Candidate candidate = mesh_.judge(entry.vertex, entry.target);
    if (!candidate.exists() || static_cast<double>(candidate.key) > stopKey_ ||
        !mesh_.collapse(entry.vertex, candidate))
        return;
    noteAccuracy();
    for (const std::uint32_t vertex : mesh_.touched())
        estimate(vertex);
}

/// Accuracy gets worse only by what a collapse changes, which is around the vertices that it touches.
void PaperOrder::noteAccuracy()
{
    for (const std::uint32_t vertex : mesh_.touched())
        for (const std::uint32_t slot : mesh_.tetrahedra().star(vertex)) {
            error_ = std::max(error_, mesh_.tetrahedra().state(slot).error);
            warping_ = std::max(warping_, mesh_.warpingOf(slot));
        }
}

Status PaperOrder::run(Pauses& pauses)
{
    gradients_.reserve(mesh_.vertexCount());
    for (std::uint32_t vertex = 0; vertex < mesh_.vertexCount(); ++vertex)
        gradients_.push_back(vertexGradient(mesh_, vertex));
    const auto goneOn = pauses.goneOn(*this);
    if (!goneOn.ok())
        return goneOn.error();
    for (std::uint32_t vertex = 0; !*goneOn && vertex < mesh_.vertexCount(); ++vertex)
        estimate(vertex);
    std::uint32_t work = 0;
    for (;;) {
        if (++work % workBetweenReports == 0)
            if (Status status =
                    pauses.pause(*this, static_cast<double>(mesh_.log().collapseCount()) / mesh_.vertexCount(),
                                 Message::marked("Collapsing"));
                !status)
                return status;
        const auto next = takeFirst();
        if (!next)
            return {};
        attempt(*next);
    }
}

} // namespace

Status decimateByEstimates(DecimatedMesh& mesh, double warpingWeight, double stopKey, const Progress& progress,
                           SavedState* state)
{
    Pauses pauses(progress, state);
    return PaperOrder(mesh, warpingWeight, stopKey).run(pauses);
}

namespace {

class Rounds {
public:
    Rounds(DecimatedMesh& mesh, double stopKey)
        : mesh_(mesh), stopKey_(stopKey), candidates_(mesh.vertexCount()), stale_(mesh.vertexCount(), true)
    {
        for (std::uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
            left_.push_back(vertex);
    }

    Status run(Pauses& pauses);
    void archive(StateArchive& archive) { archive(mesh_, left_, candidates_, stale_, bound_); }

private:
    Status lookAtStale(Pauses& pauses);
    void collapseUpToBound();
    double leastKey() const;

    DecimatedMesh& mesh_;
    double stopKey_;
    std::vector<std::uint32_t> left_; ///< vertices that were not removed
    std::vector<DecimatedMesh::Candidate> candidates_;
    std::vector<bool> stale_; ///< whether the candidate must be found again
    double bound_ = 0;        ///< of the keys of a round
};

Status Rounds::lookAtStale(Pauses& pauses)
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
        if (Status status = pauses.pause(*this, static_cast<double>(mesh_.log().collapseCount()) / mesh_.vertexCount(),
                                         Message::marked("Collapsing in rounds"));
            !status)
            return status;
    }
    return {};
}

/// What a collapse makes stale waits for the next round, so that no two stars meet.
void Rounds::collapseUpToBound()
{
    std::vector<std::uint32_t> chosen;
    for (const std::uint32_t vertex : left_)
        if (candidates_[vertex].exists() && static_cast<double>(candidates_[vertex].key) <= bound_)
            chosen.push_back(vertex);
    std::ranges::sort(chosen, {}, [this](std::uint32_t vertex) { return std::tuple(candidates_[vertex].key, vertex); });
    std::vector<bool> removed(mesh_.vertexCount(), false);
    for (const std::uint32_t vertex : chosen) {
        if (stale_[vertex])
            continue;
        if (!mesh_.collapse(vertex, candidates_[vertex])) {
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

Status Rounds::run(Pauses& pauses)
{
    if (const auto goneOn = pauses.goneOn(*this); !goneOn.ok())
        return goneOn.error();
    for (;;) {
        if (Status status = lookAtStale(pauses); !status)
            return status;
        const double least = leastKey();
        if (least == std::numeric_limits<double>::infinity() || least > stopKey_)
            return {};
        if (least > bound_)
            bound_ = std::min(2 * least, stopKey_);
        collapseUpToBound();
    }
}

} // namespace

Status decimateInRounds(DecimatedMesh& mesh, double stopKey, const Progress& progress, SavedState* state)
{
    Pauses pauses(progress, state);
    return Rounds(mesh, stopKey).run(pauses);
}

} // namespace tetra
