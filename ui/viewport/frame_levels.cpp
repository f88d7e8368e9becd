// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/canvas.h"

namespace tetra {

bool haveSameStill(const View& first, const View& second)
{
    const auto still = [](const View& view) { return view.levels.empty() ? nullptr : view.levels.front().scene.get(); };
    return !first.moving && !second.moving && still(first) == still(second) && first.camera == second.camera &&
           first.background == second.background;
}

bool wouldShowNothingNew(const View& first, const View& second, std::size_t level)
{
    return level < first.levels.size() && level < second.levels.size() &&
           first.levels[level].scene == second.levels[level].scene && first.camera == second.camera &&
           first.background == second.background;
}

std::vector<FrameLevel> frameLevels(const View& view)
{
    std::vector<FrameLevel> levels;
    for (const SceneLevel& level : view.levels) {
        FrameLevel& added = levels.emplace_back();
        added.tetrahedra = static_cast<double>(level.tetrahedra);
        added.isVolume = level.scene->volume.has_value();
        for (const Surface& surface : level.scene->surfaces)
            added.triangles += static_cast<double>(surface.mesh->triangles.size());
    }
    return levels;
}

} // namespace tetra
