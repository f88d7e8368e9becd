// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/weighting.h"
#include "core/model/verify_parts.h"

#include <algorithm>

namespace tetra {

Result<Weights> weightsOf(const Model& model, const Dataset& original, std::vector<std::string>& failures,
                          const Progress& progress)
{
    const auto& parameters = model.description().parameters;
    const auto given = std::ranges::find(parameters, "weights", &std::pair<std::string, std::string>::first);
    if (given == parameters.end())
        return Weights{};
    const Result<Weighting> weighting = parseWeighting(given->second);
    if (!weighting) {
        failures.push_back("The model's weights cannot be read. " + weighting.error().text);
        return Weights{};
    }
    return pointWeights(*weighting, original, progress);
}

} // namespace tetra
