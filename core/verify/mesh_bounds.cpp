// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/mesh_bounds.h"

#include <algorithm>
#include <limits>

namespace tetra {

MeshBounds::MeshBounds(double error, double warping) : error_(error), warping_(warping) {}

MeshBounds::MeshBounds(const MeshQuery& query, double scale, const Dataset& original)
    : errorField_(query.error), warpingField_(query.warping), scale_(scale), original_(&original),
      extent_(original.values.range().extent()), diagonal_(original.bounds().diagonal().norm())
{
}

/// In %.
double MeshBounds::asked(const ErrorField& field, std::uint64_t sample) const
{
    return field.at(original_->position(sample), original_->values.at(sample));
}

double MeshBounds::error(std::uint64_t sample) const
{
    constexpr double allowance = 1e-12; // of the range
    if (areUniform())
        return error_;
    return (keptPercent(asked(errorField_, sample), scale_) / 100 + allowance) * extent_;
}

double MeshBounds::warping(std::uint64_t sample) const
{
    if (areUniform())
        return warping_;
    const double percent = asked(warpingField_, sample);
    return percent >= anyWarping ? std::numeric_limits<double>::infinity()
                                 : keptPercent(percent, scale_) / 100 * diagonal_;
}

Accuracy keptEverywhere(const MeshQuery& query, double scale)
{
    constexpr double all = 100;
    return {.error = std::min(all, keptPercent(query.error.bounds().maximum, scale)),
            .warping = std::min(anyWarping, keptPercent(query.warping.bounds().maximum, scale))};
}

} // namespace tetra
