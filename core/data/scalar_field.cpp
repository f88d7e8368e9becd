// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/scalar_field.h"

#include <cmath>
#include <limits>

namespace tetra {

ScalarField::ScalarField(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples)
    : type_(type), count_(count), samples_(std::move(samples))
{
    visitSampleType(type_, [this]<class T>() {
        double minimum = std::numeric_limits<double>::infinity();
        double maximum = -minimum;
        for (const T sample : as<T>()) {
            const double value = static_cast<double>(sample);
            if (!std::isfinite(value)) {
                ++notFinite_;
                continue;
            }
            minimum = std::min(minimum, value);
            maximum = std::max(maximum, value);
        }
        if (notFinite_ < count_)
            range_ = {minimum, maximum};
    });
}

double ScalarField::at(std::uint64_t index) const
{
    return visitSampleType(type_, [&]<class T>() { return static_cast<double>(as<T>()[index]); });
}

} // namespace tetra
