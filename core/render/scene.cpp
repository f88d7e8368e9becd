// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/scene_checks.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace tetra {

const Drawable* drawableOf(const Scene& scene, std::string_view id)
{
    const auto found = std::ranges::find(scene.drawables, id, &Drawable::id);
    return found != scene.drawables.end() ? &*found : nullptr;
}

std::optional<Scene> withDrawn(const Scene& scene, const Camera& camera, int width, int height)
{
    using Custom = std::shared_ptr<const CustomDrawable>;
    if (shapesOf<Custom>(scene).empty())
        return std::nullopt;
    Scene drawn{
        .bounds = scene.bounds, .clipPlanes = scene.clipPlanes, .reference = scene.reference, .maker = scene.maker};
    for (const Drawable& drawable : scene.drawables) {
        const Custom* custom = std::get_if<Custom>(&drawable.shape);
        if (custom == nullptr) {
            drawn.drawables.push_back(drawable);
            continue;
        }
        if (!*custom || !(*custom)->draw)
            continue;
        for (Drawable& part : (*custom)->draw(camera, width, height))
            if (std::holds_alternative<Surface>(part.shape) || std::holds_alternative<LineSet>(part.shape)) {
                part.id = drawable.id + "/" + part.id;
                part.overlay = part.overlay || drawable.overlay;
                drawn.drawables.push_back(std::move(part));
            }
    }
    return drawn;
}

LineSet boxOutline(const Eigen::AlignedBox3d& box, const Colour& colour, float width)
{
    LineSet lines;
    lines.colour = colour;
    lines.width = width;
    if (box.isEmpty())
        return lines;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        lines.points.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
        for (std::uint32_t axis = 1; axis < 8; axis *= 2)
            if ((corner & axis) == 0)
                lines.segments.push_back({corner, corner | axis});
    }
    return lines;
}

namespace {

constexpr char planeSeparator = ';';

/// Cuts off and gives what stands before the separator, or all.
std::string_view takeToken(std::string_view& text, char separator)
{
    const auto end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

std::string_view withoutBlanks(std::string_view text)
{
    const auto begin = text.find_first_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The same plane with a normal of which squares and floats are neither zero nor infinite. The factor is a power of
/// two, which changes no digit.
ClipPlane ofUsualSize(const ClipPlane& plane)
{
    constexpr int mostSteps = 40;
    const double largest = plane.normal.cwiseAbs().maxCoeff();
    const int steps = largest > 0 ? std::ilogb(largest) : 0;
    if (std::abs(steps) <= mostSteps)
        return plane;
    return {plane.normal.unaryExpr([steps](double component) { return std::ldexp(component, -steps); }),
            std::ldexp(plane.offset, -steps)};
}

std::optional<ClipPlane> parsePlane(std::string_view text)
{
    std::array<double, 4> numbers{};
    if (std::ranges::count(text, ',') != 3)
        return {};
    for (double& number : numbers) {
        const auto parsed = parseNumber<double>(withoutBlanks(takeToken(text, ',')));
        if (!parsed || !std::isfinite(*parsed))
            return {};
        number = *parsed;
    }
    const ClipPlane plane = ofUsualSize({{numbers[0], numbers[1], numbers[2]}, numbers[3]});
    return plane.normal.isZero(0) || !std::isfinite(plane.offset) ? std::nullopt : std::optional(plane);
}

} // namespace

Result<std::vector<ClipPlane>> parseClipPlanes(std::string_view text)
{
    std::vector<ClipPlane> planes;
    while (!text.empty()) {
        const std::string_view part = withoutBlanks(takeToken(text, planeSeparator));
        if (part.empty())
            continue;
        const auto plane = parsePlane(part);
        if (!plane)
            return Error{ErrorKind::WrongUsage,
                         Message::say("'%1' is not a clip plane: give four numbers nx,ny,nz,offset, the first three "
                                      "not all zero; points with nx x + ny y + nz z >= offset are shown.",
                                      printable(part))};
        planes.push_back(*plane);
    }
    return planes;
}

std::string clipPlanesText(std::span<const ClipPlane> planes)
{
    std::string text;
    for (const ClipPlane& plane : planes) {
        if (!text.empty())
            text += planeSeparator;
        for (const double component : plane.normal)
            text += formatNumber(component) + ",";
        text += formatNumber(plane.offset);
    }
    return text;
}

} // namespace tetra
