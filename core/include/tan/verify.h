// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/verify.h: the checker: whether a model keeps what it claims, checked independently against the original data.
///
/// ~~~{.cpp}
/// /// Proves a model at 10 %, 1 % and in full; the text says what does not hold, and is empty if all does.
/// tetra::Result<std::string> proved(const tetra::Model& model, const tetra::Dataset& original)
/// {
///     const auto report = tetra::verify(model, original, {{.error = 10}, {.error = 1}, {.error = 0}});
///     if (!report)
///         return report.error();
///     std::string faults;
///     for (const std::string& failure : report->failures)
///         faults += failure + '\n';
///     for (const tetra::LevelReport& level : report->levels)
///         for (const std::string& failure : level.failures)
///             faults += std::to_string(level.asked.error) + " %: " + failure + '\n';
///     return faults;
/// }
/// ~~~

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// How large the error, or the warping, is at the points of the dataset (C15), weighted (R6), in % of the value range,
/// or of the diagonal. Vertices of the mesh count with none.
struct ResidualStatistics {
    double largest = 0;
    double mean = 0;
    double percentile99 = 0; ///< at 99 of 100 points it is at most this
    double rootMeanSquare = 0;
};

/// The error that is seen (C12): at each point's place in space, the tetrahedron there, its linear value against the
/// sample. Where several tetrahedra hold a place, which are folded there or share a face, the one that comes closest
/// counts; where none does, the nearest place on the mesh's boundary. The same as the error but for curvilinear data,
/// whose error has the weights of computational space.
struct ErrorInSpace : ResidualStatistics {
    std::uint64_t outside = 0; ///< how many points lie in no tetrahedron
};

/// What is measured of a mesh at every point of the dataset.
struct ErrorStatistics {
    ResidualStatistics error;   ///< that of the claim (R5)
    ResidualStatistics warping; ///< likewise (R4); of irregular data over the boundary's vertices alone
    ErrorInSpace errorInSpace;
    /// Of irregular data: the error, but that of points outside of the mesh is taken at the nearest place of its
    /// boundary, whatever the claim; where that exceeds it, the claim is of any place within the claimed warping (R5).
    std::optional<ResidualStatistics> errorAtNearest{};
};

/// What the checker found of one level (B3).
struct LevelReport {
    Accuracy asked;
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    bool conforming = false; ///< every face in two cells, or in one and on the domain's boundary; false if not checked
    bool covers = false;     ///< the cells fill the domain exactly, and every sample lies in one; false if not checked
    /// Cells that are flat or negative; for curvilinear data those that are in computational space, and those negative
    /// in physical space.
    std::uint64_t inverted = 0;
    std::uint64_t invertedInData = 0; ///< of these, the ones that the grid itself makes, which are no failures (S5)
    std::uint64_t degenerate = 0;     ///< cells of curvilinear data without volume in physical space (S6)
    ErrorStatistics measured{};       ///< recomputed at every original sample
    /// Of irregular data the distance between the two boundaries, either way (S13), not weighted, % of the diagonal:
    /// the largest that was found, and in `twoSidedBound` what no place exceeds.
    std::optional<double> twoSidedWarping{};
    double twoSidedBound = 0;
    std::vector<std::string> failures; ///< in words; empty if the level is proved
    bool ok() const noexcept { return failures.empty(); }
};

struct TAN_API VerificationReport {
    /// Of the file as a whole: checksums, structure, sites and values against the dataset. If there are any, levels may
    /// not have been checked; their failures say so.
    std::vector<std::string> failures;
    std::uint64_t foldedCells = 0; ///< of curvilinear data: cells of the grid that have an inverted corner (S5)
    /// Of irregular data: points that lie in or on a cell which they are no corner of, where parts touch or overlap
    /// without having points in common. The data have several values there; a level is right at such a point if one of
    /// the cells that hold it keeps the claim, and that is what is measured.
    std::uint64_t touchingPoints = 0;
    std::vector<LevelReport> levels; ///< in the order in which they were asked for
    bool ok() const noexcept;
};

/// Proves, sharing no code with builders or extraction but the reading of the file, that each level of `model` is a
/// conforming, exact cover of the domain without flat or inverted cells and keeps the error and the warping that it
/// claims against the original data, weighted if the model was built with weights. Curvilinear data: exact in
/// computational space, then in physical space; cells without volume are counted apart, and so are inverted ones that
/// the grid itself makes, which are no failure (S5). Irregular data: the boundary, wherever it lies, is a manifold that
/// does not meet itself but where the original does, in the same way (C10), with the components and the surfaces of the
/// original (S12). A damaged model gives failures; an
/// Error only if checking itself was impossible: cancelled, out of memory. On all threads; levels one after the other,
/// each about as long as extracting its mesh and locating every sample in it.
TAN_API Result<VerificationReport> verify(const Model& model, const Dataset& original,
                                          const std::vector<Accuracy>& levels, const Progress& progress = {});

} // namespace tetra
