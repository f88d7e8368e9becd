// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/subcommands.h"

#include "app/command_line/annotation_options.h"
#include "app/command_line/plugin_options.h"
#include "core/base/text.h"

#include <array>
#include <utility>

namespace tetra {

void addRemarks(std::span<const Message> remarks, Outcome& outcome)
{
    if (remarks.empty())
        return;
    JsonValue& told = outcome.figures["remarks"];
    JsonArray all = told.array() != nullptr ? *told.array() : JsonArray();
    for (const Message& remark : remarks) {
        all.push_back(remark.text());
        outcome.text += visibleText(remark) + "\n";
    }
    told = std::move(all);
}

std::span<const Subcommand> subcommands()
{
    static constexpr std::array<Subcommand, 15> all = {{
        {"sample", sampleSyntax, runSample},
        {"build", buildSyntax, runBuild},
        {"merge", mergeSyntax, runMerge},
        {"info", infoSyntax, runInfo},
        {"verify", verifySyntax, runVerify},
        {"extract", extractSyntax, runExtract},
        {"isosurface", isosurfaceSyntax, runIsosurface},
        {"render", renderSyntax, runRender},
        {"cut", cutSyntax, runCut},
        {"pack", packSyntax, runPack},
        {"unpack", unpackSyntax, runUnpack},
        {"set-frame", setFrameSyntax, runSetFrame},
        {"serve", serveSyntax, runServe},
        {"reproduce", reproduceSyntax, runReproduce},
        {"plugins", pluginsSyntax, runPlugins},
    }};
    return all;
}

Syntax wholeSyntax(const Subcommand& subcommand, PluginHost& host)
{
    Syntax syntax = subcommand.syntax(host);
    syntax.options.push_back(
        {.name = "json", .placeholder = "", .explanation = "Print one JSON object instead of text."});
    syntax.options.push_back({.name = "help", .placeholder = "", .explanation = "Print this text.", .letter = 'h'});
    separatePluginOptions(syntax);
    return syntax;
}

} // namespace tetra
