// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/star_points.h"
#include "core/mesh/decimation/vertex_star.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The tetrahedra that a collapse makes: around a common apex, one for each face of the star that the apex does not lie
/// in, as linear functions of the place from the apex.
class ApexFan {
public:
    /// What of the star's link is interpolated: the field, and of lifted meshes the three physical coordinates.
    using Samples = std::array<double, 4>;

    /// `samples`: one for each vertex of the star's link; without `lifted` only the first number counts. The star has
    /// been measured.
    void set(const VertexStar& star, std::uint32_t linkPlace, std::span<const Samples> samples, bool lifted);

    const std::array<double, 3>& apex() const noexcept { return apex_; } ///< from the star's vertex
    const Samples& apexSamples() const noexcept { return apexSamples_; }
    bool lifted() const noexcept { return lifted_; }
    /// The places among the star's faces of those that have a tetrahedron.
    std::span<const std::uint32_t> faces() const noexcept { return faces_; }

    /// Nine columns of columnLength() numbers, by face: three times three rows whose products with a place are the
    /// weights of the face's corners. Of no meaning for faces without a tetrahedron.
    std::span<const double> weights() const noexcept { return weights_; }
    std::size_t columnLength() const noexcept { return columnLength_; }
    /// The weights of the corners of a face at a place from the apex.
    std::array<double, 3> weightsAt(std::size_t face, const std::array<double, 3>& place) const;
    /// How fast sample `number` grows along each axis.
    std::array<double, 3> gradient(std::size_t face, std::size_t number) const;

private:
    std::array<double, 3> apex_{};
    Samples apexSamples_{};
    bool lifted_ = false;
    std::size_t columnLength_ = 0;
    std::vector<std::uint32_t> faces_;
    std::vector<double> weights_;
    std::vector<double> gradients_; ///< by face, of each sample three numbers
};

/// What below cannot be told from none, because rounding makes as much; and how warpings compare with errors.
struct FanMeasure {
    double leastError = 0;
    double leastWarping = 0;
    double warpingWeight = 0;
};

/// Gives each point to the tetrahedron of the fan that has it, and computes its error and warping (R4, R5) into
/// `points`, which names the tetrahedra by their faces. Returns the largest of the errors and weighted warpings, or, as
/// soon as that exceeds `bound`, what it is so far.
double evaluateFan(const ApexFan& fan, const FanMeasure& measure, double bound, StarPoints& points);

} // namespace tetra
