// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_saving.h"

#include "plugins/host/parameter_values.h"
#include "plugins/host/plugin_call.h"

namespace tetra {
namespace {

Result<Provided<Writer>> chooseWriter(PluginHost& host, const std::filesystem::path& path)
{
    Provided<Writer> best;
    double bestScore = 0;
    std::string writable;
    for (auto& writer : host.writers()) {
        for (const std::string& filter : writer.plugin->nameFilters())
            writable += (writable.empty() ? "" : ", ") + filter;
        if (const double score = writer.plugin->score(path); score > bestScore) {
            bestScore = score;
            best = std::move(writer);
        }
    }
    if (best.plugin == nullptr)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A dataset cannot be written as '%1'. %2%3", path.string(),
                                  writable.empty() ? Message::say("No writer is installed.")
                                                   : Message::say("These can be written: %1.", writable),
                                  host.explainMissing(PluginKind::Writer))};
    return best;
}

} // namespace

Status saveDataset(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                   const ParameterValues& values, const Progress& progress)
{
    const auto writer = chooseWriter(host, path);
    if (!writer)
        return writer.error();
    if (const Status known =
            checkParameterValues(Message::say("writer '%1'", writer->id), writer->plugin->parameters(), values);
        !known)
        return known;
    return callPlugin(writer->id, [&] { return writer->plugin->write(dataset, path, values, progress); });
}

} // namespace tetra
