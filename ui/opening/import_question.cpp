// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/import_question.h"

#include "plugins/host/dataset_opening.h"
#include "ui/session/files.h"

#include <QFileInfo>
#include <QSettings>

namespace tetra {
namespace {

constexpr qsizetype mostRemembered = 50;
/// A list of lists: a file's path, then names and texts in turn; the newest first.
constexpr const char* settingsKey = "imports";

QString keyOf(const std::filesystem::path& path)
{
    return QFileInfo(pathText(path)).absoluteFilePath();
}

} // namespace

bool offersChoice(const FileContents& contents)
{
    return contents.arrays.size() > 1 || contents.timeSteps.size() > 1 || contents.blocks.size() > 1 ||
           !contents.suggestions.empty();
}

void ImportProbe::request(const std::filesystem::path& path, const ImportOptions& options)
{
    answer_.ask(
        *this,
        [this, path, options](const std::stop_token& stop) {
            return probeDataset(host_, path, options, Progress(stop, {}));
        },
        [this](const Result<FileContents>& contents) { emit probed(contents); });
}

void rememberImport(const std::filesystem::path& path, const ImportOptions& options)
{
    const QString key = keyOf(path);
    QVariantList all = QSettings().value(settingsKey).toList();
    all.removeIf([&](const QVariant& entry) { return entry.toStringList().value(0) == key; });
    QStringList entry = {key};
    for (const auto& [name, text] : importTexts(options))
        entry << QString::fromStdString(name) << QString::fromStdString(text);
    if (entry.size() > 1)
        all.prepend(entry);
    QSettings().setValue(settingsKey, all.mid(0, mostRemembered));
}

ImportOptions rememberedImport(const std::filesystem::path& path, PluginHost& host)
{
    const QString key = keyOf(path);
    ModelDescription description;
    for (const QVariant& entry : QSettings().value(settingsKey).toList())
        if (const QStringList texts = entry.toStringList(); texts.value(0) == key)
            for (qsizetype i = 1; i + 1 < texts.size(); i += 2)
                description.parameters.emplace_back(texts[i].toStdString(), texts[i + 1].toStdString());
    const auto id = importReaderOf(description);
    const auto reader = id ? host.reader(*id) : Result<Provided<Reader>>(Provided<Reader>{});
    if (!reader)
        return {};
    const auto options = importOf(description, id ? reader->plugin->parameters() : std::vector<Parameter>());
    return options ? *options : ImportOptions();
}

} // namespace tetra
