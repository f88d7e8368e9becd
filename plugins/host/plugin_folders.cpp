// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_folders.h"

#include <QByteArray>
#include <QDir>

#include <algorithm>

#include <sys/stat.h>
#include <unistd.h>

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

void ignoreRelativeFolders()
{
    for (const char* variable :
         {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"})
        if (!qgetenv(variable).startsWith('/'))
            qunsetenv(variable);
    for (const char* variable : {"XDG_DATA_DIRS", "XDG_CONFIG_DIRS"}) {
        QByteArrayList folders = qgetenv(variable).split(':');
        if (folders.removeIf([](const QByteArray& folder) { return !folder.startsWith('/'); }) == 0)
            continue;
        if (folders.isEmpty())
            qunsetenv(variable);
        else
            qputenv(variable, folders.join(':'));
    }
}

std::filesystem::path userPluginFolder()
{
    const auto absoluteIn = [](const char* variable) -> std::filesystem::path {
        const std::filesystem::path folder = qgetenv(variable).toStdString();
        return folder.is_absolute() ? folder : std::filesystem::path();
    };
    if (const auto data = absoluteIn("XDG_DATA_HOME"); !data.empty())
        return data / "tan/plugins";
    const auto home = absoluteIn("HOME");
    return home.empty() ? home : home / ".local/share/tan/plugins";
}

Message whyOthersMayWrite(const std::filesystem::path& place)
{
    struct stat status {};
    if (::stat(place.c_str(), &status) != 0)
        return {};
    if (status.st_uid != ::geteuid() && status.st_uid != 0)
        return Message::say("'%1' belongs to another user, who could put any program there. Copy what you trust into a "
                            "folder of your own.",
                            place.string());
    if ((status.st_mode & S_IWOTH) != 0)
        return Message::say("Every user of this machine can write to '%1', and could put any program there. "
                            "Remove that right (chmod o-w), and see what is in it.",
                            place.string());
    return {};
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
    if (const auto own = userPluginFolder(); !own.empty())
        add(own);
    add(programFolder / "../lib/tan/plugins");
    add(programFolder / TAN_INSTALLED_PLUGINS_FROM_PROGRAM);
    return folders;
}

std::vector<std::string> disabledPlugins()
{
    return listInEnvironment("TAN_PLUGIN_DISABLE", ',');
}

} // namespace tetra
