// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session_document.h"

#include <QString>

#include <map>

namespace tetra {

/// What a PNG file says of how it was made, by keywords: "Software", "Title", "Description" with the accuracy, and in
/// "TAn-session" the session in our JSON, by which the picture can be made again.
std::map<QString, QString> pictureTexts(const SessionDocument& document, const QString& accuracy,
                                        const std::filesystem::path& folder);

/// The session that a PNG file holds; empty if it holds none or cannot be read. Reads no pixels.
std::string sessionInPicture(const std::filesystem::path& path);

/// Whether the file's name is that of a PNG picture.
bool isPictureFile(const std::filesystem::path& path);

} // namespace tetra
