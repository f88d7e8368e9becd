// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/mesh_claims.h"

#include <limits>

namespace tetra {

MeshClaims::MeshClaims(double error, double warping) : error_(error), warping_(warping) {}

MeshClaims::MeshClaims(const MeshQuery& query, double scale, const Dataset& original)
    : errorField_(query.error), warpingField_(query.warping), scale_(scale), original_(&original),
      extent_(original.values.range().extent()), diagonal_(original.bounds().diagonal().norm())
{
}

/// As a fraction.
double MeshClaims::at(const ErrorField& field, std::uint64_t sample) const
{
    return field.at(original_->position(sample), original_->values.at(sample)) / 100;
}

double MeshClaims::error(std::uint64_t sample) const
{
    constexpr double allowance = 1e-12; // of the range
    return areUniform() ? error_ : at(errorField_, sample) * extent_ * scale_ + allowance * extent_;
}

double MeshClaims::warping(std::uint64_t sample) const
{
    if (areUniform())
        return warping_;
    const double asked = at(warpingField_, sample);
    return asked >= anyWarping / 100 ? std::numeric_limits<double>::infinity() : asked * diagonal_ * scale_;
}

} // namespace tetra
