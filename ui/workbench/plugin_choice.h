// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace tetra {

/// The plugins that the user does not want, by id, in the user's settings. Holds from the next start on.
std::vector<std::string> unwantedPlugins();
void setPluginWanted(const std::string& id, bool wanted);

/// The host of this program: with the usual folders, without what the environment or the user does not want.
std::unique_ptr<PluginHost> wantedPlugins();

/// All that is known of the plugins, as text for a report of an error: a line each with tabs between name, id, kind,
/// version, interface, state, path and reason; then the folders.
QString pluginReport(const PluginHost& host);

/// The kinds of files in which such content can be saved, for a dialog: "STL files (*.stl)" ...; of meshes with those
/// in which their boundary is saved.
QStringList fileFilters(PluginHost& host, WrittenContent content);

} // namespace tetra
