// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"
#include "plugins/host/model_building.h"

#include <string>

namespace tetra {

/// What was done, which gave a model.
enum class Making { Built, Merged };

/// What building or merging the model `wanted` gave. One that is packed afterwards has another size.
Outcome outcomeOf(const ModelBuild& build, const std::string& wanted, Making making, bool isPacked = false);

/// What the model keeps of how its dataset was opened: a reader that nobody chose and that has nothing to be told is no
/// choice.
ImportOptions toKeep(ImportOptions imported, const Arguments& arguments);

} // namespace tetra
