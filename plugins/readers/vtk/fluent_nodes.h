// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace tetra {

/// The places of the nodes of a Fluent case (.cas), three numbers each, in the order of their numbers: what VTK takes
/// in single precision. `text` is the whole file, whose nodes stand in text (section 10) or in double precision (3010).
/// Nothing if there are not exactly `nodes` of three dimensions, told once each: whoever asks has VTK's. Any thread.
std::optional<std::vector<double>> readFluentNodes(std::string_view text, std::uint64_t nodes);

} // namespace tetra
