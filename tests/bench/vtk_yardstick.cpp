// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/vtk_yardstick.h"

#include "tests/bench/bench_report.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>

#include <cstdio>
#include <span>

namespace tetra {
namespace {

template <class Element> void write(const QString& path, std::span<const Element> elements)
{
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(reinterpret_cast<const char*>(elements.data()), qint64(elements.size_bytes()));
}

QJsonArray jsonOf(const Eigen::Vector3d& point)
{
    return {point.x(), point.y(), point.z()};
}

QJsonObject jsonOf(const RenderingScene& scene, int size)
{
    QJsonArray points, cameras;
    for (const TransferPoint& point : transferPoints(scene.function))
        points.append(QJsonObject{{"value", point.value},
                                  {"colour", QJsonArray{point.colour[0], point.colour[1], point.colour[2]}},
                                  {"opacity", point.opacity}});
    for (const Camera& camera : scene.cameras)
        cameras.append(QJsonObject{{"eye", jsonOf(eyePosition(camera))}, {"target", jsonOf(camera.target)}});
    return {{"width", size},
            {"height", size},
            {"points", points},
            {"unitDistance", scene.function.unitDistance},
            {"cameras", cameras}};
}

void writeMesh(const QTemporaryDir& folder, const TetrahedralMesh& mesh)
{
    write<Eigen::Vector3d>(folder.filePath("positions"), mesh.positions);
    write<float>(folder.filePath("values"), mesh.values);
    write<std::array<std::uint32_t, 4>>(folder.filePath("tetrahedra"), mesh.tetrahedra);
}

void writeScene(const QTemporaryDir& folder, const QJsonObject& scene)
{
    const QByteArray json = QJsonDocument(scene).toJson();
    write<char>(folder.filePath("scene.json"), std::span(json.constData(), std::size_t(json.size())));
}

QJsonObject runScript(const QString& script, const QString& folder, int threads)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    const QString cores = threads == 1 ? "0" : QString("0-%1").arg(threads - 1);
    process.start("xvfb-run",
                  {"-a", "taskset", "-c", cores, "/usr/bin/python3", TAN_SOURCE_DIR "/tests/bench/" + script, folder});
    process.waitForFinished(-1);
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object();
}

std::map<QString, double> mediansOf(const QJsonObject& result)
{
    std::map<QString, double> medians;
    for (const QString& name : result.keys()) {
        std::vector<double> seconds;
        for (const QJsonValue& value : result[name].toArray())
            seconds.push_back(value.toDouble());
        if (!seconds.empty())
            medians[name] = median(seconds);
    }
    return medians;
}

} // namespace

std::map<QString, double> timeVtkContour(const TetrahedralMesh& mesh, double isovalue, int runs, int threads)
{
    const QTemporaryDir folder;
    writeMesh(folder, mesh);
    writeScene(folder, {{"isovalue", isovalue}, {"runs", runs}});
    const auto medians = mediansOf(runScript("vtk_contour.py", folder.path(), threads));
    if (medians.empty())
        std::fprintf(stderr, "No comparison with VTK: it needs the packages python3-vtk9 and xvfb.\n");
    return medians;
}

std::map<QString, double> timeVtk(const RenderingScene& scene, int size, int threads, const QString& pictureFolder)
{
    const QTemporaryDir folder;
    writeMesh(folder, *scene.mesh);
    writeScene(folder, jsonOf(scene, size));

    // Of several who start an Xvfb at once one may find that another took its number.
    QJsonObject result;
    for (int attempt = 0; attempt < 3 && result.isEmpty(); ++attempt)
        result = runScript("vtk_volume.py", folder.path(), threads);
    if (result.isEmpty())
        std::fprintf(stderr, "No comparison with VTK: it needs the packages python3-vtk9 and xvfb.\n");
    for (const QString& mapper : result.keys()) {
        const QString picture = QString("%1/%2 %3 %4.png").arg(pictureFolder, scene.name).arg(size).arg(mapper);
        if (!pictureFolder.isEmpty() && threads == 1) {
            QFile::remove(picture);
            QFile::copy(folder.filePath(mapper + ".png"), picture);
        }
    }
    return mediansOf(result);
}

} // namespace tetra
