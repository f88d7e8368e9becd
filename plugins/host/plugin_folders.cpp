// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_folders.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <algorithm>

namespace tetra {
namespace {

std::vector<std::string> listInEnvironment(const char* variable, char separator)
{
    std::vector<std::string> entries;
    for (const QByteArray& entry : qgetenv(variable).split(separator))
        if (!entry.trimmed().isEmpty())
            entries.push_back(entry.trimmed().toStdString());
    return entries;
}

} // namespace

std::filesystem::path userPluginFolder()
{
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return std::filesystem::path(QFile::encodeName(data).toStdString()) / "tan/plugins";
}

std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& programFolder)
{
    std::vector<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path& folder) {
        const auto absolute = std::filesystem::weakly_canonical(folder);
        if (std::ranges::find(folders, absolute) == folders.end())
            folders.push_back(absolute);
    };
    for (const std::string& folder : listInEnvironment("TAN_PLUGIN_PATH", QDir::listSeparator().toLatin1()))
        add(folder);
    add(userPluginFolder());
    add(programFolder / "../lib/tan/plugins");
    add(programFolder / TAN_INSTALLED_PLUGINS_FROM_PROGRAM);
    return folders;
}

std::vector<std::string> disabledPlugins()
{
    return listInEnvironment("TAN_PLUGIN_DISABLE", ',');
}

} // namespace tetra
