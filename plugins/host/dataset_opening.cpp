// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_opening.h"

#include "plugins/host/input_file.h"
#include "plugins/host/parameter_values.h"
#include "plugins/host/plugin_call.h"

namespace tetra {
namespace {

std::string withSeparators(const std::vector<std::string>& texts)
{
    std::string list;
    for (const std::string& text : texts)
        list += (list.empty() ? "" : ", ") + text;
    return list;
}

Error noneReads(PluginHost& host, const std::filesystem::path& path)
{
    const auto filters = readableFiles(host);
    const std::string readable =
        filters.empty() ? "No reader is installed." : "These can be read: " + withSeparators(filters) + ".";
    return {ErrorKind::BadInput, "'" + path.string() + "' is of no format that is known here. " + readable +
                                     host.explainMissing(PluginKind::Reader)};
}

} // namespace

std::vector<std::string> readableFiles(PluginHost& host)
{
    std::vector<std::string> filters;
    for (const auto& reader : host.readers())
        for (std::string& filter : reader.plugin->nameFilters())
            filters.push_back(std::move(filter));
    return filters;
}

Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path)
{
    const auto bytes = firstBytesOf(path);
    if (!bytes)
        return bytes.error();
    if (isModelFile(path))
        return Error{ErrorKind::BadInput, "'" + path.string() +
                                              "' is a TAn model, and a dataset is wanted here: the file that the model "
                                              "was built from."};
    Provided<Reader> best;
    double bestScore = 0;
    for (auto& reader : host.readers())
        if (const double score = reader.plugin->score(path, *bytes); score > bestScore) {
            bestScore = score;
            best = std::move(reader);
        }
    if (best.plugin == nullptr)
        return noneReads(host, path);
    return best;
}

Result<Dataset> openDataset(PluginHost& host, const std::filesystem::path& path, const ParameterValues& values,
                            const Progress& progress)
{
    const auto reader = chooseReader(host, path);
    if (!reader)
        return reader.error();
    if (const Status known = checkParameterValues("reader '" + reader->id + "'", reader->plugin->parameters(), values);
        !known)
        return known.error();
    return callPlugin(reader->id, [&] { return reader->plugin->read(path, values, progress); });
}

} // namespace tetra
