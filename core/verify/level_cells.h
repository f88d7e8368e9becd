// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/topology.h"
#include "core/verify/exact_cell.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// The cells of one mesh, by the numbers of its vertices. For verification; the arrays are known to be usable.
class LevelCells {
public:
    using Cell = Tetrahedron;

    /// Of the level of the first sites, picked from the history by its definition: created by one of them, destroyed by
    /// none. Vertices are sites.
    LevelCells(const Model& model, const std::vector<LatticePoint>& places, std::uint32_t sites)
        : points_(model.points()), places_(places)
    {
        for (std::uint32_t creator = 0; creator < sites; ++creator)
            for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t) {
                if (model.destroyers()[t] < sites)
                    continue;
                const std::array<std::uint32_t, 3>& others = model.otherSites()[t];
                cells_.push_back({creator, others[0], others[1], others[2]});
                historyNumbers_.push_back(t);
            }
    }
    /// Of any mesh whose vertices are points of the dataset: the point of each, and, of lattices, where it lies.
    LevelCells(std::span<const std::uint32_t> points, const std::vector<LatticePoint>& places, std::vector<Cell> cells)
        : points_(points), places_(places), cells_(std::move(cells))
    {
    }

    std::size_t size() const noexcept { return cells_.size(); }
    const Cell& vertices(std::size_t cell) const { return cells_[cell]; }
    std::uint32_t point(std::uint32_t vertex) const { return points_[vertex]; }
    /// Of a cell.
    Cell points(std::size_t cell) const
    {
        const Cell& c = cells_[cell];
        return {points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]};
    }
    const LatticePoint& place(std::uint32_t vertex) const { return places_[vertex]; }
    LatticeCorners corners(std::size_t cell) const
    {
        const Cell& c = cells_[cell];
        return {places_[c[0]], places_[c[1]], places_[c[2]], places_[c[3]]};
    }
    /// The tetrahedron of the history that a cell of a level is; other meshes have none.
    std::optional<std::uint64_t> historyNumber(std::size_t cell) const
    {
        return historyNumbers_.empty() ? std::nullopt : std::optional(historyNumbers_[cell]);
    }

private:
    std::span<const std::uint32_t> points_;
    const std::vector<LatticePoint>& places_;
    std::vector<Cell> cells_;
    std::vector<std::uint64_t> historyNumbers_;
};

/// One for each sample that its error is multiplied by (R6); empty if the model was built without.
using Weights = std::vector<float>;

/// By how much a claimed warping may be exceeded in these bounds: coordinates of their size are rounded, in the builder
/// as here.
inline double allowedWarping(const Eigen::AlignedBox3d& bounds)
{
    const double farthest = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    return 1e-12 * bounds.diagonal().norm() + 0x1p-44 * farthest;
}

/// What a mesh claims of its error and its warping at each sample, for verification.
class MeshBounds {
public:
    /// The same at all samples, in units of the values and of length.
    MeshBounds(double error, double warping);
    /// What the query's fields allow there, at this scale (keptPercent()). The dataset outlives it.
    MeshBounds(const MeshQuery& query, double scale, const Dataset& original);

    bool areUniform() const noexcept { return original_ == nullptr; }
    /// In units of the values. Fields are computed in doubles, so theirs is 1e-12 of the range more.
    double error(std::uint64_t sample) const;
    /// In units of length.
    double warping(std::uint64_t sample) const;

private:
    double asked(const ErrorField& field, std::uint64_t sample) const;

    double error_ = 0;
    double warping_ = 0;
    ErrorField errorField_;
    ErrorField warpingField_;
    double scale_ = 1;
    const Dataset* original_ = nullptr;
    double extent_ = 0;
    double diagonal_ = 0;
};

/// A face of one cell only, seen from outside counterclockwise.
struct BoundaryFace {
    Triangle vertices;
    std::uint32_t cell = 0;
};

/// What a domain says of its cells' faces.
struct FaceRule {
    std::function<bool(const Triangle& vertices)> onBoundary;
    std::function<std::string(std::uint32_t vertex)> place; ///< for messages
};

/// Every face belongs to two cells, one on each side, or to one and lies on the domain's boundary. Sorts the faces in
/// batches of at most about 8 million. The faces of one cell go to `boundary` if it is given, in a fixed order. An
/// Error only if cancelled.
Status verifyFaces(const LevelCells& cells, const FaceRule& rule, LevelReport& verdict, const Progress& progress,
                   std::vector<BoundaryFace>* boundary = nullptr);

} // namespace tetra
