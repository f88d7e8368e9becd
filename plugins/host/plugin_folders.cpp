// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_folders.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <utility>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {
namespace {

/// Empty if it is not set.
std::string environment(const char* variable)
{
    const char* const value = std::getenv(variable);
    return value != nullptr ? value : "";
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\n\v\f\r";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> piecesOf(std::string_view list, char separator)
{
    std::vector<std::string_view> pieces;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(separator, begin), list.size());
        pieces.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

/// What stands between the separators, without blanks around it; empty pieces are left out.
std::vector<std::string> listInEnvironment(const char* variable, char separator)
{
    std::vector<std::string> entries;
    const std::string list = environment(variable);
    for (const std::string_view piece : piecesOf(list, separator))
        if (const auto entry = trimmed(piece); !entry.empty())
            entries.emplace_back(entry);
    return entries;
}

} // namespace

void ignoreRelativeFolders()
{
    for (const char* variable :
         {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"})
        if (!environment(variable).starts_with('/'))
            ::unsetenv(variable);
    for (const char* variable : {"XDG_DATA_DIRS", "XDG_CONFIG_DIRS"}) {
        const std::string list = environment(variable);
        std::string absolute;
        for (const std::string_view folder : piecesOf(list, ':'))
            if (folder.starts_with('/'))
                (absolute += absolute.empty() ? "" : ":") += folder;
        if (absolute.empty())
            ::unsetenv(variable);
        else
            ::setenv(variable, absolute.c_str(), 1);
    }
}

std::filesystem::path userPluginFolder()
{
    const auto absoluteIn = [](const char* variable) -> std::filesystem::path {
        const std::filesystem::path folder = environment(variable);
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
        return Message::say("Every user of this machine can write to '%1', and could put any program there. Remove "
                            "that permission (chmod o-w), and check its content.",
                            place.string());
    return {};
}

namespace {

/// The folders of the environment and of the user, and these.
std::vector<std::filesystem::path> foldersWith(std::span<const std::filesystem::path> own)
{
    std::vector<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path& folder) {
        const auto absolute = std::filesystem::weakly_canonical(folder);
        if (std::ranges::find(folders, absolute) == folders.end())
            folders.push_back(absolute);
    };
    for (const std::string& folder : listInEnvironment("TAN_PLUGIN_PATH", ':'))
        add(folder);
    if (const auto ofUser = userPluginFolder(); !ofUser.empty())
        add(ofUser);
    for (const std::filesystem::path& folder : own)
        add(folder);
    return folders;
}

} // namespace

std::vector<std::filesystem::path> pluginFolders(const std::filesystem::path& programFolder)
{
    std::vector<std::filesystem::path> own;
    for (const char* folder : {"../lib/tan/plugins", TAN_INSTALLED_PLUGINS_FROM_PROGRAM})
        if (auto place = programFolder / folder; place.is_absolute())
            own.push_back(std::move(place));
    return foldersWith(own);
}

std::vector<std::filesystem::path> pluginFoldersOfLibrary()
{
    Dl_info library{};
    if (::dladdr(reinterpret_cast<const void*>(&pluginFoldersOfLibrary), &library) == 0)
        return foldersWith({});
    const std::filesystem::path folder = std::filesystem::path(library.dli_fname).parent_path();
    // As built it lies beside the folder "tan", as installed in it.
    return foldersWith(std::array{folder / "tan/plugins", folder / "plugins"});
}

std::vector<std::string> disabledPlugins()
{
    return listInEnvironment("TAN_PLUGIN_DISABLE", ',');
}

} // namespace tetra
