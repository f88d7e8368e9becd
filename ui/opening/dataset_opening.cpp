// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/dataset_opening.h"

#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "ui/opening/recent_files.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

namespace tetra {
namespace {

/// Those that make a difference.
ImportOptions withoutDefaults(ImportOptions options, const std::vector<Parameter>& parameters)
{
    for (const Parameter& parameter : parameters)
        if (const auto found = options.values.find(parameter.id);
            found != options.values.end() && found->second == parameter.defaultValue)
            options.values.erase(found);
    return options;
}

/// For the preview of a raw file, and the check of its size.
Status findSamples(ImportQuestion& question, const Progress& progress)
{
    question.samples = question.path;
    const auto bytes = firstBytesOf(question.path);
    if (!bytes || !isPackedByGzip(*bytes))
        return {};
    auto folder = UnpackedFiles::make(question.path);
    if (!folder)
        return folder.error();
    const auto unpacked = folder->unpack(question.path, unpackedName(question.path).filename(), progress);
    if (!unpacked)
        return unpacked.error();
    question.samples = *unpacked;
    question.unpacked = *std::move(folder);
    return {};
}

} // namespace

DatasetOpening::DatasetOpening(PluginHost& host, Reading& reading) : host_(host), reading_(reading) {}

void DatasetOpening::openWithOptions(const std::filesystem::path& path)
{
    reading_.start([this, path](const Progress& progress) { return whenRead(path, true, progress); });
}

void DatasetOpening::readDifferently()
{
    if (dataset_)
        openWithOptions(dataset_->source.path);
}

std::function<void()> DatasetOpening::whenRead(const std::filesystem::path& path, bool asks, const Progress& progress)
{
    ImportQuestion question;
    question.path = path;
    question.options = rememberedImport(path, host_);
    const auto reader = chooseReader(host_, path);
    if (!reader)
        return reading_.tellLater(reader.error());
    const auto contents = probeDataset(host_, path, {}, progress.part(0, 0.1));
    const bool isIncomplete = !contents && contents.error().kind == ErrorKind::WrongUsage;
    if (!contents && !isIncomplete)
        return reading_.tellLater(contents.error());
    if (asks || isIncomplete || offersChoice(*contents)) {
        const auto lastReader = chooseReader(host_, path, question.options.reader);
        question.reader = lastReader ? *lastReader : *reader;
        question.contents = contents ? *contents : FileContents();
        question.reason = isIncomplete ? translatedMessage(contents.error().message) : QString();
        if (const Status found = findSamples(question, progress.part(0.1, 1)); !found)
            return reading_.tellLater(found.error());
        return [this, question] { emit choicesNeeded(question); };
    }
    return [this, path, read = readDataset(path, {}, progress.part(0.1, 1))] { datasetRead(path, read); };
}

DatasetOpening::ReadDataset DatasetOpening::readDataset(const std::filesystem::path& path, const ImportOptions& options,
                                                        const Progress& progress) const
{
    ReadDataset read{openDataset(host_, path, options, progress), {}, options};
    if (read.dataset) {
        read.size = buildSizeOf(*read.dataset, progress);
        for (const Provided<Builder>& builder : host_.builders())
            read.acceptances.push_back(builder.plugin->accepts(*read.dataset));
    }
    return read;
}

void DatasetOpening::importDataset(const std::filesystem::path& path, const ImportOptions& options)
{
    reading_.start([this, path, options](const Progress& progress) { return whenImported(path, options, progress); });
}

std::function<void()> DatasetOpening::whenImported(const std::filesystem::path& path, const ImportOptions& options,
                                                   const Progress& progress)
{
    const auto reader = chooseReader(host_, path, options.reader);
    const auto parameters = reader ? reader->plugin->parameters() : std::vector<Parameter>();
    return [this, path, read = readDataset(path, withoutDefaults(options, parameters), progress)] {
        if (read.dataset) {
            rememberImport(path, read.options);
            return reading_.passGate(
                false, [this, path, read] { take(path, read); }, [this] { emit importFailed({}); });
        }
        const Error& error = read.dataset.error();
        emit importFailed(error.kind == ErrorKind::Cancelled ? QString() : translatedMessage(error.message));
    };
}

void DatasetOpening::datasetRead(const std::filesystem::path& path, const ReadDataset& read)
{
    if (!read.dataset)
        return reading_.tell(read.dataset.error());
    reading_.passGate(false, [this, path, read] { take(path, read); });
}

void DatasetOpening::take(const std::filesystem::path& path, const ReadDataset& read)
{
    dataset_ = std::make_shared<const Dataset>(*read.dataset);
    buildSize_ = read.size;
    imported_ = read.options;
    acceptances_ = read.acceptances;
    addRecentFile(pathText(path));
    emit datasetOpened();
}

void DatasetOpening::close()
{
    if (!canClose())
        return;
    dataset_.reset();
    buildSize_ = {.points = 0};
    emit datasetClosed();
}

} // namespace tetra
