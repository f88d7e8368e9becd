// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/vertex_star.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The tetrahedra of a CollapseStar, as its members of the same names give them.
struct StarTetrahedra {
    std::span<const double> columns;
    std::size_t columnLength;
    std::span<const std::uint32_t> faces;
    std::array<double, 3> apex;
};

/// Finds out which tetrahedra of a fan places lie in, eight at once. Refers to what the tetrahedra refer to.
class StarLocator {
public:
    /// For about `placeCount` places.
    StarLocator(const StarTetrahedra& tetrahedra, std::size_t placeCount);

    /// For eight places, given by their coordinates, the face of the tetrahedron that has each: the one whose smallest
    /// weight is largest, of equals the first, so that rounding leaves no place without one. And how far the value
    /// there is from the apex's. Soonest done where places come in an order in which near ones follow one another.
    void locateEight(const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps);

private:
    StarTetrahedra tetrahedra_;
    // Of the way with the widest vectors, which not every build has.
    [[maybe_unused]] bool many_;
    [[maybe_unused]] std::size_t latest_ = 0; ///< the tetrahedron of one of the places before, in faces
};

/// The removed points of a star side by side, for arithmetic on eight at once: arrays are filled up to a multiple of
/// eight with copies of the first point.
struct StarPoints {
    static constexpr std::size_t lanes = 8;

    std::vector<std::uint32_t> points;   ///< their numbers; count() of them
    std::array<Buffer<double>, 3> place; ///< where errors are measured, from the star's vertex
    Buffer<double> value;
    Buffer<double> weight;                  ///< empty: 1
    std::array<Buffer<double>, 3> physical; ///< in physical space; empty: no warping

    Buffer<std::uint32_t> owner; ///< by the last evaluation: which tetrahedron has the point
    Buffer<double> error;        ///< by the last evaluation, weighted
    Buffer<double> warping;      ///< likewise, where there are physical places

    std::size_t count() const noexcept { return points.size(); }
};

/// What of the vertices of a star's link is interpolated: the field, and of meshes with physical places these three
/// coordinates.
class LinkSamples {
public:
    void set(const VertexStar& star, std::span<const Eigen::Vector3d> physical);

    bool physical() const noexcept { return physical_; }
    double at(std::uint32_t linkPlace, std::size_t number) const { return ofLink_[numberCount() * linkPlace + number]; }
    /// Of the corners of the star's faces side by side, as VertexStar::corners(): three columns.
    std::span<const double> ofCorners(std::size_t number) const
    {
        return std::span(ofCorners_).subspan(3 * number * columnLength_, 3 * columnLength_);
    }

private:
    std::size_t numberCount() const noexcept { return physical_ ? 4 : 1; }

    bool physical_ = false;
    std::size_t columnLength_ = 0;
    std::vector<double> ofLink_;
    std::vector<double> ofCorners_;
};

/// The tetrahedra that a collapse makes: around a common apex, one for each face of the star that the apex does not lie
/// in, as linear functions of the place from the apex.
class CollapseStar {
public:
    /// Both must live on. The star has been measured.
    void set(const VertexStar& star, std::uint32_t linkPlace, const LinkSamples& samples);
    /// The tetrahedra of the star itself, the vertex as their apex, which has this value.
    void setStar(const VertexStar& star, double value, const LinkSamples& samples);

    const std::array<double, 3>& apex() const noexcept { return apex_; } ///< from the star's vertex
    double apexValue() const noexcept { return apexSamples_[0]; }
    bool physical() const noexcept { return samples_->physical(); }
    /// The places among the star's faces of those that have a tetrahedron.
    std::span<const std::uint32_t> faces() const noexcept { return faces_; }

    /// Twelve columns of columnLength() numbers, by face: three times three rows whose products with a place are the
    /// weights of the face's corners, and one whose product is how far the value is from the apex's. Of no meaning
    /// for faces without a tetrahedron.
    std::span<const double> columns() const noexcept { return columns_; }
    std::size_t columnLength() const noexcept { return columnLength_; }
    /// The weights of the corners of a face at a place from the apex.
    std::array<double, 3> weightsAt(std::size_t face, const std::array<double, 3>& place) const;
    /// Sample `number` where the corners of a face have these weights.
    double interpolated(std::size_t face, std::size_t number, const std::array<double, 3>& weights) const;

private:
    void compute(const VertexStar& star);

    const LinkSamples* samples_ = nullptr;
    std::array<double, 3> apex_{};
    std::array<double, 4> apexSamples_{};
    std::size_t columnLength_ = 0;
    std::vector<std::uint32_t> faces_;
    std::vector<double> columns_;
};

/// The face whose tetrahedron of the fan a place from the apex lies in, of several the one that it lies deepest in;
/// 2^32 - 1 if it lies outside of all by more than `tolerance`, in weights of corners.
std::uint32_t faceAt(const CollapseStar& fan, const std::array<double, 3>& place, double tolerance);

/// What below cannot be told from none, because rounding makes as much; and how warpings compare with errors.
struct CollapseMeasure {
    double leastError = 0;
    double leastWarping = 0;
    double warpingWeight = 0;
};

/// Gives each point to the tetrahedron of the fan that has it, and computes its error and warping (R4, R5) into
/// `points`, which names the tetrahedra by their faces. Returns the largest of the errors and weighted warpings, or, as
/// soon as that exceeds `bound`, what it is so far.
double evaluateFan(const CollapseStar& fan, const CollapseMeasure& measure, double bound, StarPoints& points);

/// For each of some vertices of the link the unweighted error that the star's vertex gets by a collapse onto it: where
/// the line from there through the vertex leaves the star. `fan` is the star itself; positive are the tetrahedra of
/// each of these collapses.
void vertexErrors(const VertexStar& star, const CollapseStar& fan, const CollapseMeasure& measure,
                  const LinkSamples& samples, std::span<const std::uint32_t> linkPlaces, std::vector<double>& errors);

} // namespace tetra
