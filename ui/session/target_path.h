// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <filesystem>

namespace tetra {

/// The user's documents, or home where there is no folder for them.
QString documentFolder();

/// Where the model of a dataset goes unless the user says otherwise: beside it, or into the user's documents if that
/// folder cannot be written to.
QString proposedModelPath(const std::filesystem::path& dataset);

std::filesystem::path filePath(const QString& path);
QString pathText(const std::filesystem::path& path);

} // namespace tetra
