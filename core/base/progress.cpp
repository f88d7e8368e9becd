// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"

#include <tan/base.h>

#include <algorithm>
#include <cmath>

namespace tetra {

void RemainingTime::update(double fraction, double seconds) noexcept
{
    const double step = seconds - seconds_;
    if (!(step > 0) || !(fraction >= fraction_))
        return;
    // The memory grows with the work: ten minutes into a build the last ten seconds should not overrule the rest.
    const double memory = std::max(2.0, 0.25 * seconds);
    const double kept = std::exp(-step / memory);
    speed_ = kept * speed_ + (1 - kept) * (fraction - fraction_) / step;
    weight_ = kept * weight_ + (1 - kept);
    fraction_ = std::min(fraction, 1.0);
    seconds_ = seconds;
}

std::optional<double> RemainingTime::seconds() const noexcept
{
    if (fraction_ >= 1)
        return 0;
    if (seconds_ < 1 || fraction_ <= 0 || speed_ <= 0)
        return std::nullopt;
    return (1 - fraction_) * weight_ / speed_;
}

} // namespace tetra
