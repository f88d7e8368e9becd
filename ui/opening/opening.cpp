// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/opening.h"

#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "ui/opening/sample_models.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <tan/open.h>

#include <QFileInfo>
#include <QRegularExpression>

#include <utility>

namespace tetra {

Opening::Opening(PluginHost& host, Session& session, SceneService& scenes, std::filesystem::path views)
    : host_(host), session_(session), views_(std::move(views)), damage_(session), sessionFile_(session),
      models_(session, scenes, sessionFile_, views_, reading_), datasets_(host, reading_),
      sessions_(session, scenes, sessionFile_, models_, reading_), samples_(host, reading_)
{
    connect(&reading_, &Reading::aboutToRead, &models_, &ModelOpening::forgetComing);
    connect(&models_, &ModelOpening::modelTaken, &datasets_, &DatasetOpening::close);
    connect(&samples_, &Samples::made, this, &Opening::open);
    connect(&damage_, &DamageWatch::damageFound, &reading_, &Reading::tell);
    connect(&reading_, &Reading::failed, this, &Opening::failed);
    connect(&models_, &ModelOpening::failed, this, &Opening::failed);
    connect(&sessions_, &SessionOpening::failed, this, &Opening::failed);
    connect(&sessionFile_, &SessionFile::failed, this, &Opening::failed);
    connect(&sessionFile_, &SessionFile::saveFailed, this, &Opening::saveFailed);
}

Opening::~Opening() = default;

QStringList Opening::nameFilters()
{
    QStringList filters{tr("Models (*.tan)"), tr("Sessions (*.tansession)"), tr("Pictures saved by TAn (*.png)")};
    for (const std::string& filter : readableFiles(host_))
        filters.append(translatedText(filter));
    filters.append(tr("Datasets compressed with gzip (*.gz)"));
    static const QRegularExpression patterns(R"(\(([^)]*)\)$)");
    QStringList all;
    for (const QString& filter : std::as_const(filters))
        all.append(patterns.match(filter).captured(1));
    filters.prepend(tr("All supported files (%1)").arg(all.join(' ')));
    filters.append(tr("All files (*)"));
    return filters;
}

void Opening::open(const QString& path)
{
    const std::filesystem::path file = filePath(path);
    if (isSessionFile(file))
        return sessions_.open(file, SessionSource::File);
    if (isAddress(file.string()))
        return models_.open(file);
    models_.read(
        [this, file](const ModelOpening::ComingModel& coming, const Progress& progress) -> std::function<void()> {
            if (isPictureFile(file))
                if (const auto session = sessionInPicture(file); session && !session->empty())
                    return [this, file] { emit pictureOpened(pathText(file)); };
            if (!isModelFile(file))
                return datasets_.whenRead(file, false, progress);
            OpenedModel asSeenLast;
            asSeenLast.view = views_.find(file);
            return models_.whenRead({.place = file, .as = asSeenLast}, coming, progress);
        });
}

void Opening::openWithOptions(const QString& path)
{
    if (const std::filesystem::path file = filePath(path); isAddress(file.string()))
        models_.open(file);
    else
        datasets_.openWithOptions(file);
}

QString Opening::proposedPath(const QString& ending) const
{
    const std::filesystem::path& path = session_.model()->path();
    const std::filesystem::path& becomes = models_.becomes();
    const QFileInfo model(pathText(becomes.empty() ? path : becomes)); // looks at a build go with the program
    // What lies beside a sample may be gone tomorrow.
    const bool hasFolder = !isOfSample(path) && !isAddress(path.string());
    const QString folder = hasFolder ? model.absolutePath() : documentFolder();
    QString name = model.completeBaseName();
    if (ending.contains('.' + QFileInfo(name).suffix() + '.')) // x.packed.tan is not packed into x.packed.packed.tan
        name = QFileInfo(name).completeBaseName();
    return folder + "/" + name + ending;
}

void Opening::close()
{
    const bool isOfDataset = !session_.model() || datasets_.isBuilt();
    if (session_.model())
        models_.close();
    if (isOfDataset)
        datasets_.close();
}

} // namespace tetra
