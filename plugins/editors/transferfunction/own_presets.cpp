// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/own_presets.h"

#include <tan/transfer.h>

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUrl>

#include <cmath>

namespace tetra {
namespace {

constexpr qint64 largestFile = 1 << 20;
constexpr const char* ending = ".json";

QDir folder()
{
    return {QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/transfer-functions"};
}

/// Any name can be a file's: what cannot stand there is percent-encoded, and dots, which would hide it; the first
/// program that had presets left dots as they are.
QString fileOf(const QString& name)
{
    const QString first = folder().filePath(QUrl::toPercentEncoding(name, " ") + ending);
    return !name.startsWith('.') && QFile::exists(first)
               ? first
               : folder().filePath(QUrl::toPercentEncoding(name, " ", ".") + ending);
}

Error failed(const QString& path, const QString& why)
{
    return {ErrorKind::BadInput,
            Message::say(
                "The preset '%1' cannot be changed: %2. Check the permissions of its folder, and that there is space.",
                path.toStdString(), why.toStdString())};
}

TransferFunction spread(TransferFunction function, const TransferLimits& range, double unitDistance)
{
    const auto valueAt = [&range](double share) { return std::lerp(range.least, range.largest, share); };
    for (ColourPoint& point : function.colours)
        point.value = valueAt(point.value);
    for (OpacityPoint& point : function.opacities)
        point.value = valueAt(point.value);
    if (auto& mask = function.mask)
        mask = {valueAt(mask->least), valueAt(mask->largest)};
    function.unitDistance = unitDistance;
    return function;
}

} // namespace

std::vector<Preset> ownPresets()
{
    std::vector<Preset> presets;
    for (const QFileInfo& found : folder().entryInfoList({QString("*") + ending}, QDir::Files, QDir::Name)) {
        QFile file(found.filePath());
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const auto function = transferFunctionFromText(file.read(largestFile).toStdString());
        if (!function)
            continue;
        Preset preset;
        preset.name = QUrl::fromPercentEncoding(found.completeBaseName().toUtf8());
        preset.id = "own." + preset.name;
        preset.make = [function = *function](const TransferLimits& range, double unitDistance) {
            return spread(function, range, unitDistance);
        };
        preset.isOwn = true;
        preset.unitDistance = function->unitDistance;
        presets.push_back(std::move(preset));
    }
    return presets;
}

Status saveOwnPreset(const QString& name, const TransferFunction& preset)
{
    QSaveFile file(fileOf(name));
    folder().mkpath(".");
    if (!file.open(QIODevice::WriteOnly))
        return failed(file.fileName(), file.errorString());
    file.write(QByteArray::fromStdString(transferFunctionToText(preset)));
    if (!file.commit())
        return failed(file.fileName(), file.errorString());
    return {};
}

Status deleteOwnPreset(const QString& name)
{
    QFile file(fileOf(name));
    if (!file.remove())
        return failed(file.fileName(), file.errorString());
    return {};
}

} // namespace tetra
