// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"

#include <QString>

#include <filesystem>

namespace tetra {

/// A dataset of which the user is to say how it is to be read.
struct ImportQuestion {
    std::filesystem::path path;
    Provided<Reader> reader; ///< that the options name, or that suits the file best
    FileContents contents{}; ///< with these options
    ImportOptions options{}; ///< to begin with
    QString reason{};        ///< why it is asked, in a sentence; empty if the user wanted to be
};

/// Whether a file offers a choice that a user wants to be asked about: an array, a time step, a block, a layout.
bool offersChoice(const FileContents& contents);

} // namespace tetra
