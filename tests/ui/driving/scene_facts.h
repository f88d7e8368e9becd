// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/render/scene_parts.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace tetra {

/// What the settings of the renderers make of a scene.
struct SceneFacts {
    bool hasVolume = false;
    bool hasSamples = false; ///< in its place
    bool shaded = false;
    double fullGradient = 0;
    bool withCell = false; ///< surfaces and volume in the order of the paper
    std::size_t lines = 0;
    std::size_t surfaces = 0;
    float lastOpacity = 0; ///< of the last surface, which is the boundary if that is shown
    bool backFacesOnly = false;
    bool lit = false;                                ///< the last surface, as its renderer says
    std::vector<std::array<double, 4>> clipPlanes{}; ///< normal and offset
    std::vector<std::string> saved{};                ///< labels of the surfaces that would be
    double firstShare = 0;   ///< how far along x the first saved surface begins, as a share of the scene's way
    std::string rayShader{}; ///< of a volume's optical model
};

inline SceneFacts factsOf(const Scene& scene)
{
    const testing::SceneParts parts = testing::partsOf(scene);
    SceneFacts facts;
    facts.hasVolume = parts.volume.has_value();
    facts.hasSamples = !shapesOf<SampledVolume>(scene).empty();
    facts.shaded = parts.volume && parts.volume->shaded;
    facts.fullGradient = parts.volume ? parts.volume->fullGradient : 0;
    facts.withCell = parts.wholeCells;
    facts.lines = parts.lines.size();
    facts.surfaces = parts.surfaces.size();
    if (!parts.surfaces.empty()) {
        facts.lastOpacity = parts.surfaces.back().opacity;
        facts.backFacesOnly = parts.surfaces.back().backFacesOnly;
        facts.lit = parts.surfaces.back().lit.value_or(false);
    }
    for (const Drawable& drawable : scene.drawables)
        if (drawable.saved)
            facts.saved.push_back(drawable.label);
    const auto first = std::ranges::find(scene.drawables, true, &Drawable::saved);
    if (const auto* surface = first != scene.drawables.end() ? std::get_if<Surface>(&first->shape) : nullptr;
        surface != nullptr && !surface->mesh->positions.empty())
        facts.firstShare = (surface->mesh->positions.front() - scene.bounds.min()).x() / scene.bounds.sizes().x();
    if (parts.volume && parts.volume->model)
        facts.rayShader = parts.volume->model->rayShader;
    for (const ClipPlane& plane : parts.clipPlanes)
        facts.clipPlanes.push_back({plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset});
    return facts;
}

} // namespace tetra
