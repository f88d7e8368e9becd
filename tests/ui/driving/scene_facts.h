// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <array>
#include <vector>

namespace tetra {

/// What the settings of the renderers make of a scene.
struct SceneFacts {
    bool hasVolume = false;
    bool shaded = false;
    bool withCell = false; ///< surfaces and volume in the order of the paper
    std::size_t lines = 0;
    std::size_t surfaces = 0;
    float lastOpacity = 0; ///< of the last surface, which is the boundary if that is shown
    bool backFacesOnly = false;
    std::vector<std::array<double, 4>> clipPlanes{}; ///< normal and offset
};

inline SceneFacts factsOf(const Scene& scene)
{
    SceneFacts facts;
    facts.hasVolume = scene.volume.has_value();
    facts.shaded = scene.volume && scene.volume->shaded;
    facts.withCell = scene.hybridOrder == HybridOrder::WithCell;
    facts.lines = scene.lines.size();
    facts.surfaces = scene.surfaces.size();
    if (!scene.surfaces.empty()) {
        facts.lastOpacity = scene.surfaces.back().opacity;
        facts.backFacesOnly = scene.surfaces.back().backFacesOnly;
    }
    for (const ClipPlane& plane : scene.clipPlanes)
        facts.clipPlanes.push_back({plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset});
    return facts;
}

} // namespace tetra
