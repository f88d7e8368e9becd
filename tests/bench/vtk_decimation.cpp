// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/vtk_decimation.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <cstring>

namespace tetra {

namespace {

template <class Element> std::vector<Element> elementsOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    std::vector<Element> elements(std::size_t(bytes.size()) / sizeof(Element));
    std::memcpy(static_cast<void*>(elements.data()), bytes.constData(), elements.size() * sizeof(Element));
    return elements;
}

PlainMesh readMesh(const QTemporaryDir& folder, const QString& ending)
{
    return {elementsOf<Eigen::Vector3d>(folder.filePath("positions" + ending)),
            elementsOf<double>(folder.filePath("values" + ending)),
            elementsOf<std::array<std::uint32_t, 4>>(folder.filePath("tetrahedra" + ending))};
}

} // namespace

std::optional<VtkDecimation> decimateByVtk(const QString& file, const std::vector<double>& shares)
{
    const QTemporaryDir folder;
    QStringList arguments{TAN_SOURCE_DIR "/tests/bench/vtk_decimation.py", folder.path(), file};
    for (const double share : shares)
        arguments.append(QString::number(share));
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start("/usr/bin/python3", arguments);
    process.waitForFinished(-1);
    const QJsonArray seconds =
        QJsonDocument::fromJson(process.readAllStandardOutput()).object().value("seconds").toArray();
    if (seconds.size() != qsizetype(shares.size()))
        return std::nullopt;
    VtkDecimation result{.original = readMesh(folder, {}), .levels = {}};
    for (std::size_t i = 0; i < shares.size(); ++i)
        result.levels.push_back({shares[i], seconds[qsizetype(i)].toDouble(), readMesh(folder, QString(".%1").arg(i))});
    return result;
}

} // namespace tetra
