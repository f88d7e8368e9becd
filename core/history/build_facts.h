// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// Names among a description's parameters, and values of them, that more depends on than what people are told
/// (FORMAT.md, "parameter."). Written by core/build, read by buildFacts().
namespace buildText {
inline constexpr std::string_view refinement = "refinement"; ///< as ModelDescription::builder
inline constexpr std::string_view error = "error";
inline constexpr std::string_view weights = "weights";
inline constexpr std::string_view block = "block";
inline constexpr std::string_view selection = "selection", paper = "paper";
inline constexpr std::string_view errorIn = "error-in", space = "space";
inline constexpr std::string_view distance = "distance", twoSided = "two-sided";
} // namespace buildText

/// How a model was built, and what its builder claims, as far as something depends on it. A plain value.
struct BuildFacts {
    /// By the builder "refinement", which makes the same history of the same data again.
    bool isRefined = false;
    /// Where it was to stop, in % of the range; NaN if the text is no number. None if it was not told.
    std::optional<double> error{};
    /// What parseWeighting() reads. Empty: errors are not weighted.
    std::string weights{};
    /// Cells along an edge of a block, where the build was told a number; else 0.
    std::uint32_t blockCells = 0;
    bool hasPaperSelection = false; ///< error and warping were compared in the units of the data
    /// The error in space of a mesh is at most its key, too (C12).
    bool claimsInSpace = false;
    /// No place of a mesh's boundary is farther from the original's than its key allows, either.
    bool claimsTwoSides = false;

    bool isWeighted() const noexcept { return !weights.empty(); }
    /// What the file tells of batches is the warping from one side and the error in the grid: those bounds do not hold
    /// what either claims, as keys do.
    bool claimsByKeysAlone() const noexcept { return claimsInSpace || claimsTwoSides; }
};

/// O(parameters).
TAN_INTERNAL BuildFacts buildFacts(const ModelDescription& description);

} // namespace tetra
