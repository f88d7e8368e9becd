// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/interrupted_build.h"

#include "core/base/file_writer.h"
#include "core/base/mapped_file.h"
#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "plugins/host/parameter_text.h"
#include "plugins/host/parameter_values.h"

#include <tan/version.h>

#include <map>
#include <span>
#include <sstream>
#include <system_error>

namespace tetra {
namespace {

std::filesystem::path noteIn(const std::filesystem::path& workFolder)
{
    return workFolder / "build";
}

bool isThere(const std::filesystem::path& path)
{
    std::error_code problem;
    return std::filesystem::exists(path, problem);
}

std::string noteRead(const std::filesystem::path& workFolder)
{
    constexpr std::size_t mostBytes = 1 << 20;
    const auto note = wholeText(noteIn(workFolder), mostBytes);
    return note ? *note : std::string();
}

/// The first lines of a note.
std::string headOf(const Dataset& dataset)
{
    return "TAn " TAN_VERSION "\ndata " + std::to_string(dataset.source.hash) + "\n";
}

} // namespace

std::string buildNote(const Dataset& dataset, const Provided<Builder>& builder, const ParameterValues& values)
{
    std::string note = headOf(dataset) + "builder " + builder.id + "\n";
    for (const auto& [id, text] : usedTexts(builder.plugin->parameters(), values, dataset))
        note.append(id).append(" ").append(text) += '\n';
    return note;
}

void leaveNote(const std::filesystem::path& workFolder, std::string_view note)
{
    if (!isThere(workFolder / "state") && noteRead(workFolder) != note) // SavedState's
        (void)writeWholeFile(noteIn(workFolder), std::as_bytes(std::span(note)));
}

std::string interruptedNote(const std::filesystem::path& output)
{
    if (output.empty() || !isThere(noteIn(workFolderOf(output))))
        return {};
    auto folder = WorkFolder::open(workFolderOf(output), WorkFolder::Leftovers::Keep);
    if (!folder)
        return {};
    folder->keep();
    return noteRead(folder->path());
}

LeftBuild leftBuild(PluginHost& host, const Dataset& dataset, const std::string& builder, const ParameterValues& values,
                    std::string_view note)
{
    if (note.empty())
        return LeftBuild::None;
    const auto chosen = host.builder(builder);
    return chosen && note == buildNote(dataset, *chosen, values) ? LeftBuild::Same : LeftBuild::Other;
}

std::optional<InterruptedBuild> interruptedBuild(PluginHost& host, const Dataset& dataset, std::string_view note)
{
    const std::string head = headOf(dataset);
    if (!note.starts_with(head))
        return std::nullopt;
    std::map<std::string, std::string> texts;
    std::istringstream lines(std::string(note.substr(head.size())));
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t end = line.find(' '); end != std::string::npos)
            texts.emplace(line.substr(0, end), line.substr(end + 1));
    const auto builder = host.builder(texts["builder"]);
    if (!builder)
        return std::nullopt;
    InterruptedBuild build{.builder = builder->id, .values = {}};
    for (const Parameter& parameter : builder->plugin->parameters())
        if (const auto text = texts.find(parameter.id); text != texts.end())
            if (const auto value = parseParameter(parameter, text->second))
                build.values[parameter.id] = *value;
    return build;
}

Status discardInterruptedBuild(const std::filesystem::path& output)
{
    if (!isThere(workFolderOf(output)))
        return {};
    const auto folder = WorkFolder::open(workFolderOf(output), WorkFolder::Leftovers::Remove);
    return folder ? Status() : Status(folder.error());
}

} // namespace tetra
