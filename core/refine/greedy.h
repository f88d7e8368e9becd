// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/base.h>
#include <tan/build.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// Greedy refinement (paper, 3.1), the engine of every Delaunay model: insert the point that the mesh is farthest from,
/// give the points of the tetrahedra that die to those that are born, measure these, and again.
///
/// What a mesh is, where a point lies in it and how far it is from the data is the business of a *space*: a regular
/// lattice (refine/lattice), a curvilinear grid (refine/curvilinear), points anywhere (refine/free). Which point comes
/// when, and where that ends, is said by an *order*. All of them go through the one loop below, and stand on what
/// follows it:
///
/// - One after the other, the worst first: WorstFirst, which makes a history (R8).
/// - In rounds, many points that one look at the mesh has found: Round. That makes a mesh good enough in a region
///   (history/query), and the levels of a packed model (packed/replay).
/// - Both by turns, where the worst first is known at once of one error, and of another one only after a look: a
///   history of a curvilinear grid that keeps the error in space (refine/curvilinear).

/// What comes when.
// clang-format off
template <class Order>
concept RefinementOrder = requires(Order order) {
    /// What to insert, an optional or a pointer: nothing if no more is known that should be.
    static_cast<bool>(order.next());
    { order.insert(*order.next()) } -> std::same_as<Status>;
    /// What the last insertion cost, in the time that it takes to give a point of a lattice to another tetrahedron.
    { order.work() } -> std::convertible_to<std::uint64_t>;
    /// Called between insertions now and then, often enough for a user who waits: asks whether the work was cancelled.
    { order.pause() } -> std::same_as<Status>;
    /// Called when there is nothing to insert: looks for more. Whether the refinement goes on.
    { order.look() } -> std::same_as<Result<bool>>;
};
// clang-format on

/// Inserts what comes next, until a look finds that the mesh is good enough. Errors: the order's.
template <RefinementOrder Order> Status refineGreedily(Order& order)
{
    // Early insertions may move millions of points, late ones a few: pause by work done, not by insertions.
    constexpr std::uint64_t workBetweenPauses = 1u << 20;
    std::uint64_t work = 0;
    for (;;) {
        while (const auto next = order.next()) {
            if (const Status inserted = order.insert(*next); !inserted)
                return inserted;
            work += order.work();
            if (work < workBetweenPauses)
                continue;
            work = 0;
            if (const Status paused = order.pause(); !paused)
                return paused;
        }
        const Result<bool> goesOn = order.look();
        if (!goesOn.ok())
            return goesOn.error();
        if (!*goesOn)
            return {};
    }
}

/// A mesh whose worst point is known at any time. next() tells what to insert: `key` is the distance of the mesh as it
/// is from the data, and at a key that is small enough one may stop if `complete` holds. insert() does it and hands the
/// step to the history.
// clang-format off
template <class Space>
concept RefinableSpace = requires(Space space) {
    { space.next().key } -> std::convertible_to<float>;
    { space.next().complete } -> std::convertible_to<bool>;
    { space.insert(space.next()) } -> std::same_as<Status>;
    { space.work() } -> std::convertible_to<std::uint64_t>;
    /// How many points lie in tetrahedra that must still be refined.
    { space.pointsAboveStop() } -> std::convertible_to<std::uint64_t>;
    /// Called now and then, to drop what is out of date.
    space.sweep();
    /// All that insertions change.
    space.archive(std::declval<StateArchive&>());
};
// clang-format on

/// The worst point of a space, until the key is at most `stopKey`; that ends the history.
template <RefinableSpace Space> class WorstFirst {
public:
    WorstFirst(Space& space, double stopKey, HistorySink& sink, const Progress& progress, SavedState* state)
        : space_(space), stopKey_(stopKey), sink_(sink), progress_(progress), state_(state),
          pointsAtStart_(static_cast<double>(std::max<std::uint64_t>(space.pointsAboveStop(), 1)))
    {
    }

    using Next = decltype(std::declval<Space&>().next());
    std::optional<Next> next()
    {
        const Next next = space_.next();
        key_ = next.key;
        if (next.complete && !(static_cast<double>(next.key) > stopKey_))
            return std::nullopt;
        return next;
    }
    Status insert(const Next& next) { return space_.insert(next); }
    std::uint64_t work() const { return space_.work(); }
    Status pause()
    {
        const bool cancelled = progress_.cancelled();
        if (state_ != nullptr)
            state_->pause(space_, cancelled);
        if (cancelled)
            return cancelledError(Message::marked("The refinement"));
        // Errors may rise in between, and with them what is left to do.
        fraction_ = std::max(fraction_, 1 - static_cast<double>(space_.pointsAboveStop()) / pointsAtStart_);
        progress_.report(fraction_, Message::marked("Refining"));
        space_.sweep();
        return {};
    }
    /// There is nothing to look for: what is worst is known.
    Result<bool> look()
    {
        const Status finished = sink_.finish(key_);
        return finished ? Result<bool>(false) : finished.error();
    }
    /// Of the mesh as it is.
    float key() const { return key_; }

private:
    Space& space_;
    double stopKey_;
    HistorySink& sink_;
    const Progress& progress_;
    SavedState* state_;
    double pointsAtStart_;
    double fraction_ = 0;
    float key_ = 0;
};

/// Refines by WorstFirst. The key that was reached. `state`, if there is one, is kept up to date. Errors: the space's,
/// the sink's, cancelled.
template <RefinableSpace Space> Result<float> refineWorstFirst(Space& space, double stopKey, HistorySink& sink,
                                                               const Progress& progress, SavedState* state = nullptr)
{
    WorstFirst<Space> order(space, stopKey, sink, progress, state);
    const Status refined = refineGreedily(order);
    return refined ? Result<float>(order.key()) : refined.error();
}

/// What one look at a mesh has found: points to insert, each in a tetrahedron of its own. Insertions change tetrahedra,
/// and what was found in those that are no more is left to the next look.
template <class Found> class Round {
public:
    std::vector<Found> found;

    /// Begins with what was found, the first first. Whether that is anything.
    template <class ComesBefore> bool begin(const ComesBefore& comesBefore)
    {
        std::ranges::sort(found, comesBefore);
        place_ = 0;
        return !found.empty();
    }
    /// The next one that still stands; null after the last.
    template <class Stands> const Found* next(const Stands& stands)
    {
        while (place_ < found.size())
            if (const Found& one = found[place_++]; stands(one))
                return &one;
        return nullptr;
    }
    /// Between two of its insertions.
    void archive(StateArchive& archive) { archive(found, place_); }

    /// What an insertion costs (RefinementOrder) where nothing else tells: it is not measured at once.
    static constexpr std::uint64_t work = 1u << 12;

private:
    std::uint64_t place_ = 0;
};

/// A tetrahedron of the mesh that a refinement begins with, by the numbers of its sites.
struct StartTetrahedron {
    std::array<std::uint32_t, 4> sites{}; ///< positive
    float error = 0;                      ///< its own, and its warping: bounds, as HistoryTetrahedron's
    float warping = 0;
};

/// Hands the first mesh to the history: site after site, each with the tetrahedra of which it is the latest corner, in
/// their order. `points` are the sites' points. The number of each tetrahedron in the history. Errors: the sink's.
Result<std::vector<std::uint32_t>> addStart(std::span<const std::uint64_t> points,
                                            std::span<const StartTetrahedron> tetrahedra, HistorySink& sink);

} // namespace tetra
