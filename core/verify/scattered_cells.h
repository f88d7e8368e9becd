// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/verify/findings.h"
#include "core/verify/level_faces.h"
#include "core/verify/mesh_bounds.h"
#include "core/verify/verify_parts.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The corners of a cell, by position.
using PlacedCell = std::array<Eigen::Vector3d, 4>;

/// `points` of the cell's corners.
PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const std::array<std::uint32_t, 4>& points);
/// A cell of a mesh.
inline PlacedCell placedCell(std::span<const Eigen::Vector3d> positions, const LevelCells& cells, std::size_t number)
{
    const LevelCells::Cell& c = cells.vertices(number);
    return placedCell(positions, {cells.point(c[0]), cells.point(c[1]), cells.point(c[2]), cells.point(c[3])});
}

/// Exact signs of a cell's volume, and of whether a place lies in a positive cell, its boundary included or not.
int volumeSign(const PlacedCell& cell);
bool holds(const PlacedCell& cell, const Eigen::Vector3d& place);
bool holdsInside(const PlacedCell& cell, const Eigen::Vector3d& place);

/// |value - interpolation| at a place in a positive cell.
struct CellError {
    double error = 0;
    double doubt = 0; ///< how much of it may be rounding
};
/// In double precision, and with 113 bits and no doubt worth speaking of.
CellError quickError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                     double value);
double preciseError(const PlacedCell& cell, const std::array<double, 4>& values, const Eigen::Vector3d& place,
                    double value);

/// For messages: "(1.5, -2, 0.25)".
std::string textOf(const Eigen::Vector3d& place);
std::string textOf(const PlacedCell& cell);

/// The planes of a positive tetrahedron and its box, as a quick test that never rejects what is inside.
class TetrahedronPlanes {
public:
    explicit TetrahedronPlanes(const std::array<Eigen::Vector3d, 4>& corners);
    bool mayMeet(const Eigen::AlignedBox3d& box) const;

private:
    std::array<Eigen::Vector3d, 4> origins_;
    std::array<Eigen::Vector3d, 4> normals_;    ///< inwards
    std::array<Eigen::Vector3d, 4> magnitudes_; ///< what the normals' rounding errors are relative to
    Eigen::AlignedBox3d box_;
};

/// The original points of a model of scattered data, ready to be looked for.
struct ScatteredOriginal {
    explicit ScatteredOriginal(const Dataset& dataset);

    std::span<const Eigen::Vector3d> positions;
    std::vector<double> values;
    double extent = 0; ///< of the values
    BoxTree tree;      ///< of the positions

    double percent(double error) const { return extent > 0 ? 100 * error / extent : 0; }
};

/// That every site lies where its point lies, and every tetrahedron that ever lived is positive. For a history whose
/// indices can be followed. An Error only if cancelled.
Status verifyPlacedHistory(const Model& model, const ScatteredOriginal& original, std::vector<std::string>& failures,
                           const Progress& progress);
/// That cells are positive; appends to `verdict`.
void verifyPlacedVolumes(const ScatteredOriginal& original, const LevelCells& cells, LevelReport& verdict);

/// verifyPlacedHistory(), and that the first mesh fills the convex hull of all points: with that, a later mesh fills it
/// if its boundary faces have the first mesh's sites on one side only. For a history whose indices can be followed. An
/// Error only if cancelled.
Status verifyScatteredHistory(const Model& model, const ScatteredOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress);

/// As verifyLevel(). Claims are kept if they are exceeded by no more than 1e-12 of the value range: the interpolation
/// is computed with 113 bits where it is close.
Result<LevelReport> verifyScatteredLevel(const Model& model, const ScatteredOriginal& original,
                                         const std::vector<LatticePoint>& places, const Weights& weights,
                                         const Accuracy& asked, const Progress& progress);

/// Cells of scattered data: they conform, fill the domain, have volume, and keep what is claimed at every point. Takes
/// the first mesh to fill the domain, see verifyScatteredHistory(). Appends to `verdict`.
Status verifyScatteredCells(const Model& model, const ScatteredOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshBounds& claims, LevelReport& verdict,
                            const Progress& progress);

/// By how much of the value range a claimed error may be exceeded where interpolation is computed with 113 bits.
constexpr double errorAllowance = 1e-12;

/// Compares every original point with the interpolation in every cell that holds it, for verification.
class PointCheck {
public:
    /// All outlive it.
    PointCheck(const Model& model, const ScatteredOriginal& original, const Weights& weights, const LevelCells& cells,
               const MeshBounds& claims)
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
    const MeshBounds& claims_;
    std::vector<std::atomic<std::uint8_t>> states_;
    mutable tbb::enumerable_thread_specific<double> largest_{0.0};
    Findings tooLarge_;
};

} // namespace tetra
