// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>

#include <filesystem>
#include <span>

namespace tetra {

/// An error (WrongUsage) if `output` is one of the `inputs`, by whatever names and links they are reached: results
/// never replace what they are made from.
Status checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

/// An error (WrongUsage) if a mesh made of `model` would replace a file that is called like the model's dataset: after
/// "part.vtu" became "part.tan", "part.vtu" is the first name for a mesh of it that comes to mind.
Status checkMeshOutput(const std::filesystem::path& output, const Model& model);
/// The same by ModelDescription::sourceName alone.
Status checkMeshOutput(const std::filesystem::path& output, const std::string& source);

} // namespace tetra
