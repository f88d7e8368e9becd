// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <span>

namespace tetra {

/// An error (WrongUsage) if `output` is one of the `inputs`, by whatever names and links they are reached: results
/// never replace what they are made from.
Status checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

/// An error (WrongUsage) if there is a file `output` that is no TAn model: a model replaces only models. Guards the
/// samples that a header names, which no input list shows.
Status checkModelOutput(const std::filesystem::path& output);

} // namespace tetra
