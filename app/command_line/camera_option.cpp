// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/camera_option.h"

#include <tan/render.h>

#include <QFile>

#include <algorithm>
#include <array>
#include <filesystem>

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

Result<Camera> readCamera(const std::string& path, const Eigen::AlignedBox3d& bounds, double aspectRatio)
{
    QFile file{std::filesystem::path(path)};
    if (!file.exists())
        return Error{ErrorKind::WrongUsage,
                     "The camera '" + path + "' is neither a view (" + cameraNames() + ") nor a file."};
    if (!file.open(QIODevice::ReadOnly))
        return Error{file.error() == QFileDevice::ResourceError ? ErrorKind::OutOfResource : ErrorKind::BadInput,
                     "The camera '" + path + "' cannot be read: " + file.errorString().toStdString() + "."};
    const auto camera = cameraFromText(file.read(largestFile).toStdString(), bounds, aspectRatio);
    if (!camera)
        return Error{camera.error().kind, "'" + path + "': " + camera.error().text()};
    return camera;
}

} // namespace

std::string cameraNames()
{
    std::string names;
    for (const NamedView& view : views)
        names += (names.empty() ? "" : ", ") + std::string(view.name);
    return names;
}

Result<Camera> cameraFor(const std::string& nameOrFile, const Eigen::AlignedBox3d& bounds, double aspectRatio)
{
    const auto view = std::ranges::find(views, nameOrFile, &NamedView::name);
    if (view == views.end())
        return readCamera(nameOrFile, bounds, aspectRatio);
    return fitted(Camera{.azimuth = view->azimuth, .elevation = view->elevation}, bounds, aspectRatio);
}

} // namespace tetra
