// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/build.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace tetra {

/// Stands for all that the files of an unfinished build depend on, so that those of another build, or of another
/// version of TAn, are not taken for this one's: what the files are, the dataset, the numbers that the builder goes by,
/// and the weights, none or one a point.
std::uint64_t buildFingerprint(std::string_view files, const Dataset& dataset, std::span<const double> numbers,
                               std::span<const float> weights);

/// Sees to it that what an interrupted build left in a work folder is of the build that the fingerprint stands for, and
/// notes there that what follows is. Errors: it is of another one (WrongUsage), or the folder cannot be written.
Status claimWork(const std::filesystem::path& folder, std::uint64_t fingerprint);

/// What a build that is not in blocks keeps in the target's work folder, and goes on with; null unless it is to be
/// resumed, as keeping it takes time and room. The rest as of buildFingerprint(). Errors: as SavedState::open() and
/// claimWork().
Result<std::unique_ptr<SavedState>> buildState(const BuildTarget& target, const Dataset& dataset,
                                               std::string_view method, std::span<const double> numbers,
                                               std::span<const float> weights);

} // namespace tetra
