// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tetra::testing {

/// The camera with its eye at a place, looking where it looked.
inline Camera withEyeAt(const Camera& camera, const Eigen::Vector3d& place)
{
    Camera result = camera;
    result.target += place - eyePosition(camera);
    return result;
}

/// The fine part of a blend.
struct FinePart {
    Volume fine;
    std::variant<Box, Sphere> region;
    double border = 0;
    std::vector<FocusRegion> more{}; ///< regions
};

inline std::vector<FocusRegion> regionsOf(const FinePart& focus)
{
    std::vector<FocusRegion> regions{{focus.region, focus.border}};
    regions.insert(regions.end(), focus.more.begin(), focus.more.end());
    return regions;
}

/// A scene by the kinds of its shapes, to be put together and taken apart.
struct SceneParts {
    std::vector<Surface> surfaces{};
    std::vector<LineSet> lines{};
    Eigen::AlignedBox3d bounds{};
    std::optional<Volume> volume{};
    std::optional<FinePart> focus{}; ///< of the volume
    bool wholeCells = false;         ///< of the volume
    std::vector<ClipPlane> clipPlanes{};

    operator Scene() const // NOLINT(google-explicit-constructor): tests hand it on as a scene
    {
        Scene scene{.bounds = bounds, .clipPlanes = clipPlanes};
        const auto add = [&](const std::string& kind, Shape shape) {
            scene.drawables.push_back(
                {.id = kind + "-" + std::to_string(scene.drawables.size()), .shape = std::move(shape)});
        };
        for (const Surface& surface : surfaces)
            add("surface", surface);
        for (const LineSet& set : lines)
            add("lines", set);
        if (volume) {
            Volume outside = *volume;
            outside.wholeCells = wholeCells;
            if (focus)
                add("volume", FocusVolume{outside, focus->fine, regionsOf(*focus)});
            else
                add("volume", outside);
        }
        return scene;
    }
};

inline SceneParts partsOf(const Scene& scene)
{
    SceneParts parts{.bounds = scene.bounds, .clipPlanes = scene.clipPlanes};
    for (const Drawable& drawable : scene.drawables) {
        if (const auto* surface = std::get_if<Surface>(&drawable.shape))
            parts.surfaces.push_back(*surface);
        else if (const auto* lines = std::get_if<LineSet>(&drawable.shape))
            parts.lines.push_back(*lines);
        else if (const auto* volume = std::get_if<Volume>(&drawable.shape))
            parts.volume = *volume;
        else if (const auto* focus = std::get_if<FocusVolume>(&drawable.shape)) {
            parts.volume = focus->outside;
            const FocusRegion& region = focus->regions.front();
            parts.focus =
                FinePart{focus->fine, region.shape, region.border, {focus->regions.begin() + 1, focus->regions.end()}};
        }
    }
    parts.wholeCells = parts.volume && parts.volume->wholeCells;
    return parts;
}

} // namespace tetra::testing
