// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_opening.h"

#include "plugins/host/input_file.h"
#include "plugins/host/packed_file.h"
#include "plugins/host/parameter_values.h"

namespace tetra {
namespace {

Error noneReads(PluginHost& host, const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    if (const std::string program = unpackingProgram(bytes); !program.empty())
        return {ErrorKind::BadInput, Message::say("'%1' is packed. Unpack it first, by '%2', and open what is in it.",
                                                  path.string(), program)};
    return {ErrorKind::BadInput,
            Message::say("'%1' has an unknown format. %2%3", path.string(),
                         host.readers().empty()
                             ? Message::say("No reader is installed.")
                             : Message::say("The manual and 'tan info --help' list the files that are "
                                            "read; samples alone, without a header, are read as a raw "
                                            "file."),
                         host.explainMissing(PluginKind::Reader))};
}

/// The reader with the highest score for a file of this name that begins so; none if no plugin is set.
Provided<Reader> bestReader(PluginHost& host, const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    Provided<Reader> best;
    double bestScore = 0;
    for (auto& reader : host.readers())
        if (const double score = reader.plugin->score(path, bytes); score > bestScore) {
            bestScore = score;
            best = std::move(reader);
        }
    return best;
}

/// What a reader is given: the file, or what was in it if it is packed and the reader does not unpack it by itself.
struct ReadableFile {
    std::filesystem::path path;
    std::optional<UnpackedFile> unpacked;
};

Result<ReadableFile> readableFile(const Reader& reader, const std::filesystem::path& path, const Progress& progress)
{
    const auto bytes = firstBytesOf(path);
    if (!bytes)
        return bytes.error();
    if (!isPackedByGzip(*bytes) || reader.score(path, *bytes) > 0)
        return ReadableFile{path, {}};
    auto unpacked = UnpackedFile::unpack(path, progress);
    if (!unpacked)
        return unpacked.error();
    return ReadableFile{unpacked->path(), *std::move(unpacked)};
}

/// The message with `to` wherever one of its arguments says `from`.
Message renamed(const Message& message, const std::string& from, const std::string& to)
{
    if (message.sentence().empty()) {
        std::string text = message.text();
        for (auto place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size()))
            text.replace(place, from.size(), to);
        return text;
    }
    std::vector<Message> arguments;
    for (const Message& argument : message.arguments())
        arguments.push_back(renamed(argument, from, to));
    return Message::of(message.sentence(), std::move(arguments));
}

/// An error that names the file as the user does.
Error inPackedFile(Error error, const ReadableFile& file, const std::filesystem::path& path)
{
    if (!file.unpacked)
        return error;
    error.message = renamed(error.message, file.path.string(), path.string());
    if (error.kind == ErrorKind::BadInput)
        error.message = Message::say(
            "%1 (It was unpacked by itself. If it names other files, unpack it beside them: gunzip.)", error.message);
    return error;
}

/// The reader, if the values are among its parameters.
Result<Provided<Reader>> readerFor(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options)
{
    auto reader = chooseReader(host, path, options.reader);
    if (!reader)
        return reader;
    const Status known =
        checkParameterValues(Message::say("reader '%1'", reader->id), reader->plugin->parameters(), options.values);
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
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' is a TAn model, and a dataset is wanted here: the file that the model was built from.",
                         path.string())};
    Provided<Reader> best = bestReader(host, path, *bytes);
    if (best.plugin == nullptr && isPackedByGzip(*bytes)) {
        const auto inside = firstUnpackedBytes(path);
        if (!inside)
            return inside.error();
        best = bestReader(host, unpackedName(path), *inside);
    }
    if (best.plugin == nullptr)
        return noneReads(host, path, *bytes);
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
    constexpr double unpackEnd = 0.3;
    const auto file = readableFile(*reader->plugin, path, progress.part(0, unpackEnd));
    if (!file)
        return file.error();
    const double readBegin = file->unpacked ? unpackEnd : 0;
    const double readEnd = options.part.isWhole() ? 1 : 0.8;
    auto whole = reader->plugin->read(file->path, options.values, progress.part(readBegin, readEnd));
    if (!whole)
        return inPackedFile(whole.error(), *file, path);
    if (file->unpacked)
        whole->source.path = path;
    return takePart(*whole, options.part, progress.part(readEnd, 1));
}

Result<FileContents> probeDataset(PluginHost& host, const std::filesystem::path& path, const ImportOptions& options,
                                  const Progress& progress)
{
    const auto reader = readerFor(host, path, options);
    if (!reader)
        return reader.error();
    const auto file = readableFile(*reader->plugin, path, progress);
    if (!file)
        return file.error();
    const auto contents = reader->plugin->probe(file->path, options.values, progress);
    return contents ? contents : inPackedFile(contents.error(), *file, path);
}

} // namespace tetra
