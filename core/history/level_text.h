// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/extraction.h"

#include <span>
#include <string>

namespace tetra {

/// The sizes of a model's meshes at several accuracies, as a file for other programs: one line a level with a line of
/// names before it, numbers under no locale, errors and warpings in % of the value range and of the diagonal.
std::string levelsAsCsv(const Model& model, std::span<const Accuracy> levels);

/// The same as one JSON object, with where the model is from: "model", "source", "builder", "sites", "tetrahedra",
/// "bytes", and "levels", a list of "error", "warping", "sites", "tetrahedra", "reached" and "reached_warping".
std::string levelsAsJson(const Model& model, std::span<const Accuracy> levels);

/// Either, as the name's ending says. Errors: WrongUsage, it is neither .csv nor .json.
Result<std::string> levelsFor(const std::filesystem::path& path, const Model& model, std::span<const Accuracy> levels);

} // namespace tetra
