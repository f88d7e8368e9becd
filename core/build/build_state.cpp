// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/build_state.h"

#include "core/base/checksum.h"

#include <string>

namespace tetra {

Result<std::unique_ptr<SavedState>> buildState(const BuildTarget& target, const Dataset& dataset,
                                               std::string_view method, std::initializer_list<double> options,
                                               std::span<const float> weights)
{
    if (target.workFolder.empty() || !target.resume)
        return std::unique_ptr<SavedState>();
    std::string text = "TAn " TAN_VERSION " state\n";
    const auto add = [&text](std::string_view part) { text.append(part) += '\n'; };
    add(method);
    for (const double option : options)
        add(formatNumber(option));
    add(std::to_string(dataset.source.hash));
    add(domainClassName(dataset.domain));
    add(sampleTypeName(dataset.values.type()));
    add(std::to_string(dataset.pointCount()));
    for (int axis = 0; axis < 3; ++axis) {
        add(std::to_string(dataset.lattice.size[static_cast<std::size_t>(axis)]));
        add(formatNumber(dataset.lattice.spacing[axis]));
    }
    add(std::to_string(checksum(std::as_bytes(weights))));
    return SavedState::open(target.workFolder, checksum(std::as_bytes(std::span(text))));
}

} // namespace tetra
