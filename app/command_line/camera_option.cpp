// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/camera_option.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

namespace tetra {
namespace {

struct NamedView {
    std::string_view name;
    double azimuth;
    double elevation;
};

/// "iso" looks at a corner so that the three axes are equally long.
constexpr std::array<NamedView, 7> views = {{{"front", 0, 0},
                                             {"back", 180, 0},
                                             {"left", 270, 0},
                                             {"right", 90, 0},
                                             {"top", 0, 90},
                                             {"bottom", 0, -90},
                                             {"iso", 45, 35.264389682754654}}};

constexpr qint64 largestFile = 1 << 20;

/// Reads the keys of a camera file one by one; the first mistake stays.
class CameraFile {
public:
    CameraFile(std::string path, QJsonObject json) : path_(std::move(path)), json_(std::move(json)) {}

    Result<Camera> read(const Eigen::AlignedBox3d& bounds)
    {
        Camera camera;
        number("azimuth", camera.azimuth, -1e6, 1e6);
        number("elevation", camera.elevation, -90, 90);
        number("fieldOfView", camera.fieldOfView, 1, 170);
        truth("perspective", camera.perspective);
        camera = fitted(camera, bounds);
        number("distance", camera.distance, 1e-30, 1e30);
        point("target", camera.target);
        for (const QString& key : json_.keys())
            fail(key, "is not known");
        if (error_)
            return *error_;
        return camera;
    }

private:
    void fail(const QString& key, const std::string& what)
    {
        if (!error_)
            error_ = Error{ErrorKind::BadInput, "'" + path_ + "': the key \"" + key.toStdString() + "\" " + what + "."};
    }

    void number(const char* key, double& target, double least, double most)
    {
        const QJsonValue value = json_.take(QLatin1String(key));
        if (value.isUndefined())
            return;
        if (value.isDouble() && value.toDouble() >= least && value.toDouble() <= most)
            target = value.toDouble();
        else
            fail(key, "is no number in its bounds");
    }

    void truth(const char* key, bool& target)
    {
        const QJsonValue value = json_.take(QLatin1String(key));
        if (value.isBool())
            target = value.toBool();
        else if (!value.isUndefined())
            fail(key, "is neither true nor false");
    }

    void point(const char* key, Eigen::Vector3d& target)
    {
        const QJsonValue value = json_.take(QLatin1String(key));
        if (value.isUndefined())
            return;
        const QJsonArray list = value.toArray();
        if (list.size() != 3 || !std::ranges::all_of(list, [](const QJsonValue& entry) { return entry.isDouble(); }))
            return fail(key, "is not a list of three numbers");
        target = {list[0].toDouble(), list[1].toDouble(), list[2].toDouble()};
    }

    std::string path_;
    QJsonObject json_;
    std::optional<Error> error_;
};

Result<Camera> readCamera(const std::string& path, const Eigen::AlignedBox3d& bounds)
{
    QFile file{std::filesystem::path(path)};
    if (!file.exists())
        return Error{ErrorKind::WrongUsage,
                     "The camera '" + path + "' is neither a view (" + cameraNames() + ") nor a file."};
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorKind::BadInput,
                     "The camera '" + path + "' cannot be read: " + file.errorString().toStdString() + "."};
    QJsonParseError mistake;
    const QJsonDocument document = QJsonDocument::fromJson(file.read(largestFile), &mistake);
    if (!document.isObject())
        return Error{ErrorKind::BadInput, "'" + path + "' is no camera: it holds no JSON object (" +
                                              mistake.errorString().toStdString() + ")."};
    return CameraFile(path, document.object()).read(bounds);
}

} // namespace

std::string cameraNames()
{
    std::string names;
    for (const NamedView& view : views)
        names += (names.empty() ? "" : ", ") + std::string(view.name);
    return names;
}

Result<Camera> cameraFor(const std::string& nameOrFile, const Eigen::AlignedBox3d& bounds)
{
    const auto view = std::ranges::find(views, nameOrFile, &NamedView::name);
    if (view == views.end())
        return readCamera(nameOrFile, bounds);
    return fitted(Camera{.azimuth = view->azimuth, .elevation = view->elevation}, bounds);
}

} // namespace tetra
