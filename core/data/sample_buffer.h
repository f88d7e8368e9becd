// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/sample_type.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace tetra {

/// Memory for `count` samples of `type`, to be filled and handed to a ScalarField. More than the machine's physical
/// memory is refused before anything is taken; so is a count whose bytes no 64-bit number holds.
Result<std::shared_ptr<std::byte>> allocateSamples(SampleType type, std::uint64_t count);

} // namespace tetra
