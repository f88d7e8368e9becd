// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/session_document.h"
#include "plugins/api/renderer.h"

#include <tan/model.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace tetra {

/// What a session was read from.
enum class SessionSource {
    File,    ///< of its own, which it is saved in from now on
    Picture, ///< that shows it
    Lost,    ///< what was kept of it by a program that ended unexpectedly
};

/// A model that was read, and how to show it.
struct OpenedModel {
    std::shared_ptr<const Model> model{};
    FieldExtent field{};
    std::optional<SessionDocument> view{}; ///< none: as at first
    std::filesystem::path from{};          ///< of the view, if that is not how the model was seen last
    SessionSource source = SessionSource::File;
    bool isLocated = false; ///< the user has said where the model of the session is
    /// It is a model under way, as far as it is built or has come; where it will be when it is done.
    std::filesystem::path becomes{};
    /// Of a model of which only the beginning was read: how much there is.
    std::uint32_t sitesOfWhole = 0;
    std::uint64_t bytesOfWhole = 0;
    std::uint64_t bytesRead = 0;
};

} // namespace tetra
