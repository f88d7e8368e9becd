// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/curvilinear_cells.h"
#include "core/verify/findings.h"
#include "core/verify/irregular_original.h"
#include "core/verify/level_cells.h"
#include "core/verify/placed_cell.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The dataset that a mesh is compared with, and what its domain needs for that. The dataset outlives it.
struct Original {
    /// What is wrong with the dataset, or with what the model says of it, is appended to `failures`. An Error only if
    /// cancelled.
    static Result<Original> make(const Model& model, const Dataset& dataset, std::vector<std::string>& failures,
                                 const Progress& progress);

    explicit Original(const Dataset& dataset);

    const Dataset& dataset;
    double extent;           ///< of the values
    double diagonal;         ///< of the bounds
    double warpingAllowance; ///< by which a claimed warping may be exceeded: coordinates are rounded
    std::optional<CurvilinearOriginal> curvilinear;
    std::optional<ScatteredOriginal> scattered;
    std::optional<IrregularOriginal> irregular;
    std::optional<GridPoints> gridPoints; ///< of curvilinear data

    /// Of scattered and irregular data.
    const ScatteredOriginal& points() const { return irregular ? irregular->points : *scattered; }
    /// Of irregular data; of others none.
    std::span<const std::uint32_t> touchingPoints() const
    {
        return irregular ? std::span<const std::uint32_t>(irregular->touching) : std::span<const std::uint32_t>();
    }
};

/// A mesh, what it is compared with, and what it claims.
struct MeshToVerify {
    const Model& model;
    const Original& original;
    const Weights& weights;
    const LevelCells& cells;
    const MeshBounds& bounds;

    bool ofHistory() const { return cells.size() > 0 && cells.historyNumber(0).has_value(); }
    double weight(std::uint64_t sample) const { return weights.empty() ? 1 : static_cast<double>(weights[sample]); }
};

/// What is measured at samples and claimed of them: in units of the values, or of length.
struct Residual {
    static Residual error(const MeshToVerify& mesh);
    static Residual warping(const MeshToVerify& mesh);

    const MeshToVerify& mesh;
    std::string_view name;  ///< "error"
    std::string_view whole; ///< "range": what percentages are of
    double size;            ///< of that
    double allowance;       ///< by which a claim may be exceeded: what rounds here rounds in the builder, too
    double (MeshBounds::*claim)(std::uint64_t sample) const;
    std::span<const std::uint16_t> ownOfHistory; ///< as fractions of the size

    double claimed(std::uint64_t sample) const { return (mesh.bounds.*claim)(sample); }
    /// What the history grants a cell; anything if it is of no history.
    double own(std::size_t cell) const;
    double percent(double residual) const { return size > 0 ? 100 * residual / size : 0; }
    /// "The error at sample (1, 2, 3) is 2 % of the range, more than the claimed 1 %"
    std::string moreThanClaimed(std::uint64_t sample, const std::string& name, double residual) const;
};

/// What the check of all cells finds of one residual. Safe to add to from any number of threads.
struct CellFindings {
    /// `severalValued`: samples, sorted, at which the data have several values, so that the cell that comes closest
    /// counts. They outlive it.
    explicit CellFindings(std::size_t samples, std::span<const std::uint32_t> severalValued = {})
        : residuals(samples, 0), states(samples), severalValued(severalValued),
          leastOfSeveral(severalValued.size(), std::numeric_limits<double>::infinity())
    {
    }

    Findings turned; ///< flat and inverted cells
    Findings beyondClaim;
    std::atomic<std::uint64_t> degenerate = 0; ///< without volume in physical space
    std::atomic<std::uint64_t> allowed = 0;    ///< inverted, as the grid itself is there
    PointResiduals residuals;                  ///< the largest of the cells that hold each
    std::vector<std::atomic<std::uint8_t>> states;
    std::span<const std::uint32_t> severalValued;
    PointResiduals leastOfSeveral; ///< of each of them, the smallest of the cells that hold it

    /// Its number among those with several values.
    std::optional<std::size_t> numberOfSeveral(std::uint64_t sample) const
    {
        const auto at = std::ranges::lower_bound(severalValued, sample);
        return at != severalValued.end() && *at == sample
                   ? std::optional(static_cast<std::size_t>(at - severalValued.begin()))
                   : std::nullopt;
    }

    bool isCovered(std::uint64_t sample) const { return (state(sample) & Covered) != 0; }
    bool isWithinOwn(std::uint64_t sample) const { return (state(sample) & WithinOwn) != 0; }
    void mark(std::uint64_t sample, bool withinOwn)
    {
        const int known = withinOwn ? Covered | WithinOwn : Covered;
        if ((state(sample) & known) != known)
            states[sample].fetch_or(static_cast<std::uint8_t>(known), std::memory_order_relaxed);
    }

private:
    enum State {
        Covered = 1,   ///< some cell holds the sample
        WithinOwn = 2, ///< some cell that holds it grants its residual
    };
    int state(std::uint64_t sample) const { return states[sample].load(std::memory_order_relaxed); }
};

/// That the cells of a mesh have volume, conform, fill the domain, and keep what is claimed at every sample (R4, R5),
/// and cells of a history what that grants each of them. Of curvilinear data they are not inverted in physical space,
/// either, but where the grid is (S5). Of scattered data the first mesh is taken to fill the domain, so that another
/// one does if its boundary faces have that one's sites on one side only. Of irregular data verifyIrregular() says the
/// rest. Claims are kept if they are exceeded by no more than the allowances; exactly where samples are integers of a
/// regular lattice without weights. At points where the data themselves have several values (touchingPoints()) one of
/// the cells that hold them keeps the claim. Appends to `verdict`. An Error only if cancelled.
Status verifyCells(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress);

/// A place inside the cell, if it is positive and not too thin for doubles to name one.
std::optional<Eigen::Vector3d> placeInside(const PlacedCell& cell);
/// How many cells hold the place. O(cells), on all threads.
std::size_t countHolding(std::span<const Eigen::Vector3d> positions, const LevelCells& cells,
                         const Eigen::Vector3d& place);

} // namespace tetra
