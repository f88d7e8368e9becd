// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/history/extraction.h"

#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What the checker found of one level (B3).
struct LevelReport {
    Accuracy asked;
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    bool conforming = false; ///< every face in two cells, or in one and on the domain's boundary
    bool covers = false;     ///< the cells fill the domain exactly, every sample lies in one
    /// Flat or negative cells; of curvilinear data those in computational space and the negative ones in physical
    /// space.
    std::uint64_t inverted = 0;
    std::uint64_t invertedInData = 0; ///< of these those that are no failure: the grid itself makes them (S5)
    std::uint64_t degenerate = 0;     ///< cells of curvilinear data without volume in physical space (S6)
    double largestError = 0;          ///< recomputed at every original sample, weighted (R6), % of the value range
    double largestWarping = 0;        ///< likewise, % of the diagonal; of irregular data at the boundary's vertices
    /// Of irregular data the larger of that and the distance from the mesh's boundary to the original one (S13), not
    /// weighted, % of the diagonal: as far as was found, and what no place exceeds.
    std::optional<double> twoSidedWarping{};
    double twoSidedBound = 0;
    std::vector<std::string> failures; ///< in words; empty means proved
    bool ok() const noexcept { return failures.empty(); }
};

struct VerificationReport {
    std::vector<std::string>
        failures; ///< of the file as a whole: checksums, structure, sites and values against the dataset
    std::uint64_t foldedCells = 0; ///< of curvilinear data: cells of the grid that have an inverted corner (S5)
    std::vector<LevelReport> levels;
    bool ok() const noexcept;
};

/// Proves, sharing no code with builders or extraction, that each level of `model` is a conforming, exact cover of the
/// domain without flat or inverted cells and keeps the error and the warping that it claims against the original data,
/// weighted if the model was built with weights. Curvilinear data: exact in computational space, then lifted; cells
/// without volume are counted apart, and so are inverted ones that the grid itself makes, which are no failure (S5).
/// Irregular data: the boundary, wherever it lies, is a manifold that does not meet itself, with the components and the
/// surfaces of the original (S12). An Error only if checking itself was impossible.
Result<VerificationReport> verify(const Model& model, const Dataset& original, const std::vector<Accuracy>& levels,
                                  const Progress& progress = {});

} // namespace tetra
