// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/preset.h"

#include <tan/base.h>

namespace tetra {

/// The user's own presets: a file of our JSON each, in the folder transfer-functions beside the program's settings.
/// Files that hold nothing of the kind are passed over.
std::vector<Preset> ownPresets();

/// Under a name, in place of one that has it already. `preset` as presetOf() makes it. The error says which file
/// cannot be written.
Status saveOwnPreset(const QString& name, const TransferFunction& preset);

Status deleteOwnPreset(const QString& name);

} // namespace tetra
