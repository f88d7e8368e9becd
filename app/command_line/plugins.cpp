// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"

namespace tetra {
namespace {

/// Loading tells whether the libraries that a plugin needs are there; the metadata alone do not.
void loadAll(PluginHost& host)
{
    host.builders();
    host.renderers();
    host.readers();
    host.writers();
    host.editors();
    host.tools();
}

} // namespace

Syntax pluginsSyntax(PluginHost&)
{
    return {.purpose = "list the plugins, and what is wrong with those that cannot be used",
            .explanation =
                "Every plugin found is loaded to see whether all that it needs is there. A plugin that cannot be used "
                "is listed with the reason and the remedy; it does not keep the program from working.",
            .positionals = {},
            .options = {},
            .examples = {{"tan plugins", "All plugins, one per line."}},
            .exitCodes = {0, 2, 4}};
}

Result<Outcome> runPlugins(const Invocation& invocation)
{
    loadAll(invocation.host);
    Outcome outcome;
    JsonArray list;
    std::string errors;
    std::vector<std::vector<std::string>> rows = {{"kind", "id", "version", "state"}};
    for (const PluginStatus& plugin : invocation.host.plugins()) {
        const PluginMetadata& metadata = plugin.metadata;
        const std::string kind(plugin.hasMetadata ? pluginKindName(metadata.kind) : "unknown");
        const std::string version = plugin.hasMetadata ? toText(metadata.version) : "";
        list.push_back(JsonObject{{"id", metadata.id},
                                  {"kind", kind},
                                  {"version", version},
                                  {"state", pluginStateName(plugin.state)},
                                  {"error", plugin.error.text()},
                                  {"name", metadata.name},
                                  {"file", plugin.path.string()}});
        rows.push_back({kind, metadata.id, version, std::string(pluginStateName(plugin.state))});
        if (!plugin.error.empty())
            errors += "\n" + visibleText(metadata.id) + " (" + visibleText(plugin.path.string()) +
                      "): " + visibleText(plugin.error) + "\n";
    }
    outcome.figures = {{"plugins", list}};
    outcome.text = table(rows) + errors + "\nSearched in:\n";
    for (const auto& folder : invocation.host.folders())
        outcome.text += "  " + visibleText(folder.string()) + "\n";
    return outcome;
}

} // namespace tetra
