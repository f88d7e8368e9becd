// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace tetra {

/// Positions of many lattice points given by their index: without a division a point, and without a conversion to
/// integers, so that a loop over points can be vectorised.
class LatticePoints {
public:
    explicit LatticePoints(const Lattice& lattice)
        : sizeX_(lattice.size[0]), sizeXy_(static_cast<double>(lattice.size[0]) * lattice.size[1]), perRow_(1 / sizeX_),
          perSlice_(1 / sizeXy_), spacing_(lattice.spacing), origin_(lattice.origin), directions_(lattice.directions)
    {
    }

    /// Where Lattice::position() puts the point. Any index is harmless; one outside has no meaning.
    Eigen::Vector3d position(std::uint32_t index) const
    {
        const Eigen::Vector3d along = alongAxes(index);
        return origin_ +
               (directions_.col(0) * along[0] + directions_.col(1) * along[1] + directions_.col(2) * along[2]);
    }
    /// The same, quicker, of a lattice along the axes.
    Eigen::Vector3d positionAlongAxes(std::uint32_t index) const { return origin_ + alongAxes(index); }

private:
    Eigen::Vector3d alongAxes(std::uint32_t index) const
    {
        const double number = index;
        const double slice = quotient(number, perSlice_);
        const double inSlice = number - slice * sizeXy_;
        const double row = quotient(inSlice, perRow_);
        const double inRow = inSlice - row * sizeX_;
        return {spacing_[0] * inRow, spacing_[1] * row, spacing_[2] * slice};
    }
    /// floor(number / unit), exactly. Half a unit up and half a quotient down, the value lies between the middles of
    /// two integers, at least 1 / (2 unit) away from either, far more than 32-bit numbers lose to rounding; adding 1.5
    /// * 2^52 then rounds to the integer between them.
    static double quotient(double number, double perUnit)
    {
        constexpr double integersOnly = 0x1.8p52; // of either sign
        return ((number + 0.5) * perUnit - 0.5 + integersOnly) - integersOnly;
    }

    double sizeX_;
    double sizeXy_;
    double perRow_;
    double perSlice_;
    Eigen::Vector3d spacing_;
    Eigen::Vector3d origin_;
    Eigen::Matrix3d directions_;
};

/// What the meshes of all kinds of queries are filled with: of the first `sites` sites, not more than the model has.
/// Results take the place of what was in the buffers. They do not ask whether the file changed meanwhile
/// (Model::checkIntact()): whoever puts a mesh together does that at its end.

/// Where sites lie in physical space. Errors: a damaged file.
Status placeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3d>& positions);

/// The values of sites, rounded to floats. Errors: a damaged file.
Status copyValues(const Model& model, std::uint32_t sites, Buffer<float>& values);

/// Makes tetrahedra that are positive in the space that the model was made in positive in physical space.
void turnToPhysicalSpace(const Model& model, std::span<std::array<std::uint32_t, 4>> tetrahedra);

/// That numbers in the model's file contradict each other, or that it changed meanwhile: `what` is the end of a
/// sentence.
Error inconsistentModel(const Model& model, const Message& what);

} // namespace tetra
