// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/session_document.h"

namespace tetra {

/// Where the model of a session is now, which was read from the file `session`: where the session says, relative to
/// its own place or absolute, or in the same folders below one that the session lies in, as when a project was moved.
/// Of several the one with the stored identity; elsewhere than the session says only that one. Nothing if there is
/// none. Reads the beginnings of a few files: for a worker.
std::optional<std::filesystem::path> sessionModel(const SessionDocument& document,
                                                  const std::filesystem::path& session);

} // namespace tetra
