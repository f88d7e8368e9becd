// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/build_state.h"

#include "core/base/checksum.h"

#include <tan/version.h>

#include <string>

namespace tetra {

std::uint64_t buildFingerprint(std::string_view files, const Dataset& dataset, std::span<const double> numbers,
                               std::span<const float> weights)
{
    std::string text = "TAn " TAN_VERSION "\n";
    const auto add = [&text](std::string_view part) { text.append(part) += '\n'; };
    add(files);
    for (const double number : numbers)
        add(formatNumber(number));
    add(std::to_string(dataset.source.hash));
    add(domainClassName(dataset.domain));
    add(sampleTypeName(dataset.values.type()));
    add(std::to_string(dataset.pointCount()));
    for (int axis = 0; axis < 3; ++axis) {
        add(std::to_string(dataset.lattice.size[static_cast<std::size_t>(axis)]));
        add(formatNumber(dataset.lattice.spacing[axis]));
    }
    add(std::to_string(checksum(std::as_bytes(weights))));
    return checksum(std::as_bytes(std::span(text)));
}

Result<std::unique_ptr<SavedState>> buildState(const BuildTarget& target, const Dataset& dataset,
                                               std::string_view method, std::span<const double> numbers,
                                               std::span<const float> weights)
{
    if (target.workFolder.empty() || !target.resume)
        return std::unique_ptr<SavedState>();
    return SavedState::open(target.workFolder, buildFingerprint(method, dataset, numbers, weights));
}

} // namespace tetra
