// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <memory>

namespace tetra {

/// The samples of the lattice that a model was built from: from the model, if all of them are in it; else from the file
/// that it names, which lies beside it and is read as it was then. Takes as long as reading them; not for the GUI
/// thread. Errors: the data are no whole lattice (WrongUsage); they are not at hand, or others by their checksum
/// (BadInput); those of the reader; not enough memory; cancelled.
Result<std::shared_ptr<const Dataset>> samplesOf(const Model& model, PluginHost& host, const Progress& progress = {});

} // namespace tetra
