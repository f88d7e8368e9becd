// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/workbench.h"

#include <utility>

namespace tetra {

Workbench::Workbench(PluginHost& host, std::filesystem::path views)
    : host_(host), scenes_(host, session_), opening_(host, session_, scenes_, std::move(views)),
      building_(host, session_, opening_), exporting_(host, session_, scenes_)
{
    connect(&scenes_, &SceneService::failed, this, &Workbench::failed);
    connect(&opening_, &Opening::failed, this, &Workbench::failed);
    connect(&opening_, &Opening::saveFailed, this, &Workbench::saveFailed);
    connect(&building_, &Building::saveFailed, this, &Workbench::saveFailed);
    connect(&exporting_, &Exporting::failed, this, &Workbench::failed);
    connect(&exporting_, &Exporting::saveFailed, this, &Workbench::saveFailed);
}

Workbench::~Workbench() = default;

} // namespace tetra
