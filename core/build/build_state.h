// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/build.h>

#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>

namespace tetra {

/// What a build that is not in blocks keeps in the target's work folder, and goes on with; null unless it is to be
/// resumed, as keeping it takes time and room. `method`, `options` and `weights`, none or one a point, are all that it
/// depends on besides the dataset. Errors: as SavedState::open().
Result<std::unique_ptr<SavedState>> buildState(const BuildTarget& target, const Dataset& dataset,
                                               std::string_view method, std::initializer_list<double> options,
                                               std::span<const float> weights);

} // namespace tetra
