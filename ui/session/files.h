// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QString>

#include <cstdint>
#include <filesystem>
#include <string>

namespace tetra {

/// The user's documents, or home where there is no folder for them.
QString documentFolder();

/// Where the model of a dataset goes unless the user says otherwise: beside it, or into the user's documents if that
/// folder cannot be written to.
QString proposedModelPath(const std::filesystem::path& dataset, const std::string& array = {});

std::filesystem::path filePath(const QString& path);
QString pathText(const std::filesystem::path& path);
/// For people: of an address without what may be a password or a key.
QString shownPlace(const std::filesystem::path& place);

/// The file's name alone, with escapes for what is not seen, and a word if the model is left at its server.
QString shownName(const std::filesystem::path& place);

/// "4.7 MB", in the user's language.
QString sizeText(std::uint64_t bytes);

} // namespace tetra
