// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/base.h>
#include <tan/build.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// Greedy refinement (paper, 3.1), the engine of every Delaunay model: insert the point that the mesh is farthest from,
/// give the points of the tetrahedra that die to those that are born, measure these, and again.
///
/// What a mesh is, where a point lies in it and how far it is from the data is the business of a *space*: a regular
/// lattice (refine/lattice), a curvilinear grid (refine/curvilinear), points anywhere (refine/free). When to insert
/// which point is the business of the two schedulers below: one after the other, the worst first, which makes a history
/// (R8); or many in a round, which makes a mesh good enough in a region (history/query).

/// A mesh to refine one point at a time. next() tells what to insert: `key` is the distance of the mesh as it is from
/// the data, and at a key that is small enough one may stop if `complete` holds. insert() does it and hands the step
/// to the history.
// clang-format off
template <class Space>
concept RefinableSpace = requires(Space space) {
    { space.next().key } -> std::convertible_to<float>;
    { space.next().complete } -> std::convertible_to<bool>;
    { space.insert(space.next()) } -> std::same_as<Status>;
    /// What the last insertion cost, in the time that it takes to give a point of a lattice to another tetrahedron.
    { space.work() } -> std::convertible_to<std::uint64_t>;
    /// How many points lie in tetrahedra that must still be refined.
    { space.pointsAboveStop() } -> std::convertible_to<std::uint64_t>;
    /// Called now and then, to drop what is out of date.
    space.sweep();
    /// All that insertions change.
    space.archive(std::declval<StateArchive&>());
};
// clang-format on

/// Refines until the key is at most `stopKey`, then ends the history with it. The key that was reached. `state`, if
/// there is one, is kept up to date. Errors: the space's, cancelled.
template <RefinableSpace Space> Result<float> refineWorstFirst(Space& space, double stopKey, HistorySink& sink,
                                                               const Progress& progress, SavedState* state = nullptr)
{
    const double pointsAtStart = static_cast<double>(std::max<std::uint64_t>(space.pointsAboveStop(), 1));
    // Early insertions move millions of points, late ones a few: ask by work done, not by insertions.
    constexpr std::uint64_t workBetweenReports = 1u << 20;
    std::uint64_t work = 0;
    double fraction = 0;
    for (;;) {
        const auto next = space.next();
        if (next.complete && !(static_cast<double>(next.key) > stopKey)) {
            if (const Status finished = sink.finish(next.key); !finished)
                return finished.error();
            return next.key;
        }
        if (const Status inserted = space.insert(next); !inserted)
            return inserted.error();
        work += space.work();
        if (work < workBetweenReports)
            continue;
        work = 0;
        const bool cancelled = progress.cancelled();
        if (state != nullptr)
            state->pause(space, cancelled);
        if (cancelled)
            return cancelledError(Message::marked("The refinement"));
        // Errors may rise in between, and with them what is left to do.
        fraction = std::max(fraction, 1 - static_cast<double>(space.pointsAboveStop()) / pointsAtStart);
        progress.report(fraction, Message::marked("Refining"));
        space.sweep();
    }
}

/// A mesh to refine in rounds: found() is the worst point of each tetrahedron that is too far from the data.
// clang-format off
template <class Space>
concept RoundwiseSpace = requires(Space space) {
    space.found().front();
    /// Whether the tetrahedron that the point was found in is still there: no insertion has changed it since.
    { space.stands(space.found().front()) } -> std::convertible_to<bool>;
    { space.insert(space.found().front()) } -> std::same_as<Status>;
    /// Makes found() what is found in the tetrahedra that changed since. Errors: cancelled.
    { space.look() } -> std::same_as<Status>;
};
// clang-format on

/// Inserts what was found, what isWorse() says first, unless an insertion before it has changed its tetrahedron; then
/// looks at what changed; until nothing is found. `activity` is what was cancelled.
template <RoundwiseSpace Space> Status refineInRounds(Space& space, const Progress& progress, const Message& activity)
{
    constexpr std::size_t insertionsBetweenReports = 256;
    while (!space.found().empty()) {
        std::ranges::sort(space.found(), [](const auto& one, const auto& other) { return isWorse(one, other); });
        std::size_t insertions = 0;
        for (const auto& worst : space.found()) {
            if (insertions++ % insertionsBetweenReports == 0 && progress.cancelled())
                return cancelledError(activity);
            if (!space.stands(worst))
                continue;
            if (const Status inserted = space.insert(worst); !inserted)
                return inserted;
        }
        if (const Status looked = space.look(); !looked)
            return looked;
    }
    return {};
}

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
