// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/value_scale.h"
#include "plugins/api/written_content.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace tetra {

/// The arrays of a mesh's values as a file has them.
struct ValueArrays {
    std::vector<NamedArray> arrays;
    std::shared_ptr<const Buffer<float>> kept{}; ///< what the second one points into
};

/// The values of vertices, which `values` keeps alive, under the name that their dataset has for them; where they are
/// logarithms, with a second array of the values that these are of. O(vertices). May throw std::bad_alloc.
inline ValueArrays valueArrays(std::string_view nameInDataset, bool areLogarithms, std::span<const float> values)
{
    ValueArrays result{.arrays = {{valueArrayName(nameInDataset), values}}};
    if (areLogarithms) {
        result.kept = std::make_shared<const Buffer<float>>(valuesOfLogarithms(values));
        result.arrays.push_back(
            {valueArrayName(nameOfLogarithms(nameInDataset)), std::span<const float>(*result.kept)});
    }
    return result;
}

} // namespace tetra
