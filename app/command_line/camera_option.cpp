// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/camera_option.h"

#include "core/base/json.h"
#include "core/base/mapped_file.h"

#include <tan/render.h>

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

constexpr std::size_t largestFile = 1 << 20;

Result<Camera> readCamera(const std::string& path, const Framing& framing, const Eigen::AlignedBox3d& bounds,
                          double aspectRatio)
{
    std::error_code problem;
    if (!std::filesystem::exists(path, problem))
        return Error{ErrorKind::WrongUsage,
                     "The camera '" + path + "' is neither a view (" + cameraNames() + ") nor a file."};
    const auto text = wholeText(path, largestFile);
    if (!text)
        return Error{text.error().kind, "The camera cannot be used. " + text.error().text()};
    const auto camera = cameraFromText(*text, bounds, aspectRatio);
    if (!camera)
        return Error{camera.error().kind, "'" + path + "': " + camera.error().text()};
    const auto root = parseJson(*text);
    const bool hasPlace = root && (root->find("target") != nullptr || root->find("distance") != nullptr);
    return hasPlace ? *camera : framing(*camera);
}

} // namespace

std::string cameraNames()
{
    std::string names;
    for (const NamedView& view : views)
        names += (names.empty() ? "" : ", ") + std::string(view.name);
    return names;
}

Result<Camera> cameraFor(const std::string& nameOrFile, const Framing& framing, const Eigen::AlignedBox3d& bounds,
                         double aspectRatio)
{
    const auto view = std::ranges::find(views, nameOrFile, &NamedView::name);
    if (view == views.end())
        return readCamera(nameOrFile, framing, bounds, aspectRatio);
    return framing(Camera{.azimuth = view->azimuth, .elevation = view->elevation});
}

} // namespace tetra
