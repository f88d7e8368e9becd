// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/checksum.h"

#include <tan/data.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace tetra {

/// Random values; few different ones, and so large batches, every third time.
inline Dataset randomDataset(std::mt19937& random, SampleType type, const Lattice& lattice)
{
    const double levels = random() % 3 == 0 ? 2 + random() % 4 : 250;
    return visitSampleType(type, [&]<class T>() {
        const auto values = std::make_shared<std::vector<T>>(lattice.pointCount());
        for (T& value : *values) {
            const double unit = static_cast<double>(random() % 100003) / 100003;
            const double offset = std::is_signed_v<T> ? -levels / 2 : 0;
            value = static_cast<T>(std::is_integral_v<T> ? (sizeof(T) == 1 ? std::floor(unit * levels) / 2 + offset / 2
                                                                           : std::floor(unit * levels) * 90 + offset)
                                                         : unit * 1e-3 + 1);
        }
        const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
        const ScalarField field(type, lattice.pointCount(), bytes);
        return Dataset{.lattice = lattice, .values = field, .source = {"random", {}, checksum(field.bytes())}};
    });
}

} // namespace tetra
