// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/compatibility.h"

#include "plugins/api/metadata.h"
#include "plugins/host/plugin_file.h"

#include <tan/version.h>

#include <optional>
#include <string_view>

namespace tetra {

static_assert(pluginInterfaceVersion.major > 0 ||
                  pluginInterfaceVersion == Version{TAN_VERSION_MAJOR, TAN_VERSION_MINOR, TAN_VERSION_PATCH},
              "before 1.0 the plugin interface has the version of the program");

namespace {

Error refused(Message text)
{
    return {ErrorKind::BadInput, std::move(text)};
}

Status checkApi(const Version& plugin, const Version& host)
{
    if (fits(plugin, host))
        return {};
    if (plugin > host)
        return refused(Message::say("It is written for plugin interface %1, and this program has %2. Install a newer "
                                    "version of TAn, or an older one of the plugin.",
                                    toText(plugin), toText(host)));
    return refused(Message::say("It is written for plugin interface %1 of an earlier TAn, and this program has %2. "
                                "Install a newer version of the "
                                "plugin, or build it again with the headers of this TAn.",
                                toText(plugin), toText(host)));
}

/// The number of an interface's id, if it is one with the name of `like`: 2 of "org.tan.Reader/2".
std::optional<int> numberOf(std::string_view id, std::string_view like)
{
    const std::string_view name = like.substr(0, like.find('/') + 1);
    return id.starts_with(name) ? parseNumber<int>(id.substr(name.size())) : std::nullopt;
}

Status checkInterface(const PluginMetadata& plugin)
{
    const std::string_view expected = pluginInterface(plugin.kind);
    if (const auto number = numberOf(plugin.interface, expected); number && *number < *numberOf(expected, expected))
        return refused(builtForEarlierTan());
    if (plugin.interface != expected)
        return refused(Message::say("Its metadata call it a %1, but it implements %2 instead of %3. Ask the plugin's "
                                    "author for a fixed version.",
                                    pluginKindText(plugin.kind), plugin.interface, expected));
    return {};
}

Status checkQt(const Version& plugin, const Version& host)
{
    if (plugin == Version{} || host == Version{} || fits(plugin, host))
        return {};
    return refused(Message::say("It was built with Qt %1, and this program runs with Qt %2. Install a build of the "
                                "plugin for this Qt.",
                                toText(plugin), toText(host)));
}

Status checkBuildTag(const std::string& plugin, const std::string& host)
{
    if (plugin == host)
        return {};
    if (plugin.empty())
        return refused(Message::say("It does not state what it was built with, and this program was built with %1. "
                                    "Rebuild the plugin with tan_plugin_module().",
                                    host));
    return refused(Message::say("It was built with %1, and this program with %2. Rebuild the plugin with that "
                                "compiler and the headers of this TAn, or install a build of it for this TAn.",
                                plugin, host));
}

} // namespace

HostBuild thisBuild()
{
    return {pluginInterfaceVersion, {}, TAN_BUILD_TAG};
}

Status checkCompatible(const PluginMetadata& plugin, const HostBuild& host)
{
    for (const Status& status : {checkApi(plugin.api, host.api), checkInterface(plugin), checkQt(plugin.qt, host.qt),
                                 checkBuildTag(plugin.buildTag, host.buildTag)})
        if (!status)
            return status;
    return {};
}

} // namespace tetra
