// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/findings.h"
#include "core/model/verify_scattered.h"

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <vector>

namespace tetra {

/// By how much of the value range a claimed error may be exceeded where interpolation is computed with 113 bits.
constexpr double errorAllowance = 1e-12;

/// Compares every original point with the interpolation in every cell that holds it, for verification.
class PointCheck {
public:
    /// All outlive it.
    PointCheck(const Model& model, const ScatteredOriginal& original, const Weights& weights, const LevelCells& cells,
               const MeshClaims& claims)
        : model_(model), original_(original), weights_(weights), cells_(cells), claims_(claims),
          states_(original.positions.size())
    {
    }

    /// An Error only if cancelled.
    Status run(const Progress& progress);

    /// Whether some cell holds the point.
    bool isCovered(std::uint32_t point) const { return (state(point) & Covered) != 0; }
    /// Whether some cell that holds it grants its error.
    bool isWithinOwn(std::uint32_t point) const { return (state(point) & WithinOwnError) != 0; }
    /// Weighted, in units of the values.
    double largestError() const
    {
        return largest_.combine([](double a, double b) { return std::max(a, b); });
    }
    /// Errors larger than what is claimed.
    Findings& tooLarge() { return tooLarge_; }

private:
    enum PointState { Covered = 1, WithinOwnError = 2 };

    std::uint8_t state(std::uint32_t point) const { return states_[point].load(std::memory_order_relaxed); }
    void mark(std::uint32_t point, int states)
    {
        if ((state(point) & states) != states)
            states_[point].fetch_or(static_cast<std::uint8_t>(states), std::memory_order_relaxed);
    }
    void checkCell(std::size_t number);
    /// What the history grants the cell; anything if it is of no history.
    double ownBound(std::size_t number) const;

    const Model& model_;
    const ScatteredOriginal& original_;
    const Weights& weights_;
    const LevelCells& cells_;
    const MeshClaims& claims_;
    std::vector<std::atomic<std::uint8_t>> states_;
    mutable tbb::enumerable_thread_specific<double> largest_{0.0};
    Findings tooLarge_;
};

} // namespace tetra
