// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/subsampling.h"

#include "core/base/checksum.h"

#include <tan/data.h>

namespace tetra {

Result<Dataset> subsampled(const Dataset& dataset, std::uint32_t step)
{
    Dataset part = dataset;
    for (std::uint32_t& size : part.lattice.size) {
        size = (size + step - 1) / step;
        if (size < 2)
            return Error{ErrorKind::BadInput, "Every " + std::to_string(step) + "th sample of '" + dataset.source.name +
                                                  "' is less than two along an axis."};
    }
    part.lattice.spacing *= step;
    const auto samples = allocateSamples(dataset.values.type(), part.lattice.pointCount());
    if (!samples)
        return samples.error();
    visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> from = dataset.values.as<T>();
        T* to = reinterpret_cast<T*>(samples->get());
        for (std::uint32_t k = 0; k < part.lattice.size[2]; ++k)
            for (std::uint32_t j = 0; j < part.lattice.size[1]; ++j)
                for (std::uint32_t i = 0; i < part.lattice.size[0]; ++i)
                    *to++ = from[dataset.lattice.index(i * step, j * step, k * step)];
    });
    part.values = ScalarField(dataset.values.type(), part.lattice.pointCount(), *samples);
    part.source.name += ", every " + std::to_string(step) + " samples";
    part.source.path.clear();
    part.source.hash = checksum(part.values.bytes());
    return part;
}

} // namespace tetra
