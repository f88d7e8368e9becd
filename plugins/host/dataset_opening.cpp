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

/// The reader, if the values are among its parameters.
Result<Provided<Reader>> readerFor(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options)
{
    auto reader = chooseReader(host, path, options.reader);
    if (!reader)
        return reader;
    const Status known =
        checkParameterValues("reader '" + reader->id + "'", reader->plugin->parameters(), options.values);
    return known ? reader : known.error();
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

Result<Provided<Reader>> chooseReader(PluginHost& host, const std::filesystem::path& path,
                                      const std::optional<std::string>& id)
{
    if (!id)
        return chooseReader(host, path);
    if (const auto bytes = firstBytesOf(path); !bytes)
        return bytes.error();
    return host.reader(*id);
}

Result<Dataset> openDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                            const Progress& progress)
{
    const auto reader = readerFor(host, path, options);
    if (!reader)
        return reader.error();
    const double readEnd = options.part.isWhole() ? 1 : 0.8;
    const auto whole =
        callPlugin(reader->id, [&] { return reader->plugin->read(path, options.values, progress.part(0, readEnd)); });
    if (!whole)
        return whole;
    return takePart(*whole, options.part, progress.part(readEnd, 1));
}

Result<FileContents> probeDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                                  const Progress& progress)
{
    const auto reader = readerFor(host, path, options);
    if (!reader)
        return reader.error();
    return callPlugin(reader->id, [&] { return reader->plugin->probe(path, options.values, progress); });
}

} // namespace tetra
