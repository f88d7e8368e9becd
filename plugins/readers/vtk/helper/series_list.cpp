// SPDX-License-Identifier: GPL-3.0-or-later
// The formats: https://www.paraview.org/Wiki/ParaView/Data_formats (PVD; JSON based new meta file format for series).
#include "plugins/readers/vtk/helper/series_list.h"

#include "plugins/readers/vtk/checks/format_checks.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Error wrongSeries(const Message& what)
{
    return {ErrorKind::BadInput, what};
}

using PartsByTime = std::map<double, std::vector<SeriesPart>>;

/// One DataSet of a .pvd, put to those of the same time.
Status addDataSet(const QXmlStreamAttributes& attributes, const fs::path& folder, PartsByTime& parts)
{
    const QString timeText = attributes.value(QLatin1String("timestep")).toString();
    bool isNumber = true;
    const double time = timeText.trimmed().isEmpty() ? 0 : timeText.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(time))
        return wrongSeries(
            Message::say("it has the time '%1', which is not a number.", printable(timeText.toStdString())));
    const std::string fileName = attributes.value(QLatin1String("file")).toString().toStdString();
    const auto file = fileBelow(folder, folder, fileName);
    if (!file)
        return file.error();
    const std::string given = attributes.value(QLatin1String("name")).toString().toStdString();
    parts[time].push_back({given.empty() ? fileName : given, *file});
    return {};
}

Result<std::vector<SeriesStep>> readPvd(const QByteArray& text, const fs::path& folder)
{
    PartsByTime parts;
    QXmlStreamReader xml(text);
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("DataSet"))
            if (const Status added = addDataSet(xml.attributes(), folder, parts); !added)
                return added.error();
    if (xml.hasError())
        return wrongSeries(Message::say("its XML ends or breaks in line %1. It is damaged or cut short: copy or "
                                        "export it again.",
                                        static_cast<std::int64_t>(xml.lineNumber())));
    std::vector<SeriesStep> steps;
    for (auto& [time, ofTime] : parts)
        steps.push_back({time, std::move(ofTime)});
    return steps;
}

Result<std::vector<SeriesStep>> readJson(const QByteArray& text, const fs::path& folder)
{
    QJsonParseError problem{};
    const QJsonDocument document = QJsonDocument::fromJson(text, &problem);
    if (problem.error != QJsonParseError::NoError)
        return wrongSeries(Message::say("its JSON breaks at byte %1. It is damaged or cut short: copy or export it "
                                        "again.",
                                        static_cast<std::int64_t>(problem.offset)));
    const QJsonValue files = document.object().value(QLatin1String("files"));
    if (!files.isArray())
        return wrongSeries(Message::say("it has no list of 'files'."));
    std::vector<SeriesStep> steps;
    for (const QJsonValue entry : files.toArray()) {
        const QJsonValue name = entry.toObject().value(QLatin1String("name"));
        const QJsonValue time = entry.toObject().value(QLatin1String("time"));
        if (!name.isString() || (!time.isUndefined() && !time.isDouble()))
            return wrongSeries(Message::say("its file number %1 does not have a 'name' and a 'time' that is a number.",
                                            steps.size() + 1));
        const std::string fileName = name.toString().toStdString();
        const auto file = fileBelow(folder, folder, fileName);
        if (!file)
            return file.error();
        steps.push_back({time.toDouble(static_cast<double>(steps.size())), {{fileName, *file}}});
    }
    return steps;
}

} // namespace

Result<std::vector<SeriesStep>> readSeries(const fs::path& path)
{
    constexpr std::size_t mostBytes = std::size_t(64) << 20; // some hundred thousand files
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    if (bytes.size() > mostBytes)
        return wrongSeries(Message::say("it has %1 bytes, more than a list of files has.", bytes.size()));
    const auto text =
        QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    auto steps =
        text.trimmed().startsWith('{') ? readJson(text, path.parent_path()) : readPvd(text, path.parent_path());
    if (!steps)
        return steps;
    if (steps->empty())
        return wrongSeries(Message::say("it is a list of files, but names none."));
    std::ranges::stable_sort(*steps, {}, &SeriesStep::time);
    return steps;
}

} // namespace tetra
