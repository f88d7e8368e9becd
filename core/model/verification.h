// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/model/extraction.h"

#include <string>
#include <vector>

namespace tetra {

/// What the checker found of one level (B3).
struct LevelVerdict {
    Accuracy asked;
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    bool conforming = false;    ///< every face in two cells, or in one and on the domain's boundary
    bool covers = false;        ///< the cells fill the domain exactly, every sample lies in one
    std::uint64_t inverted = 0; ///< flat or negative cells
    double largestError = 0;    ///< recomputed at every original sample, weighted (R6), % of the value range
    double largestWarping = 0;
    std::vector<std::string> failures; ///< in words; empty means proved
    bool ok() const noexcept { return failures.empty(); }
};

struct Verdict {
    std::vector<std::string>
        failures; ///< of the file as a whole: checksums, structure, sites and values against the dataset
    std::vector<LevelVerdict> levels;
    bool ok() const noexcept;
};

/// Proves, sharing no code with builders or extraction, that each level of `model` is a conforming, exact cover of the
/// domain without flat or inverted cells and keeps the error it claims against the original data, weighted if the model
/// was built with weights. An Error only if checking itself was impossible.
Result<Verdict> verify(const Model& model, const Dataset& original, const std::vector<Accuracy>& levels,
                       const Progress& progress = {});

} // namespace tetra
