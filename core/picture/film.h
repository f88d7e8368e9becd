// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/scene_pipeline.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/view.h>

#include <functional>
#include <memory>
#include <vector>

namespace tetra {

/// A film of a view: its animation.
struct Film {
    std::shared_ptr<const Model> model{};
    const Renderer* renderer = nullptr;
    std::vector<Parameter> parameters{}; ///< of the renderer
    ViewValue view{};
    decltype(SceneRequest::samples) samples{}; ///< where its samples come from, if they are to be seen
    PictureOrder picture{};                    ///< size and background of each frame; the rest is the frame's
    /// Paints over a frame; called in the worker.
    std::function<Status(const PixelCanvas& canvas, const ViewValue& view, const ShownMesh& mesh)> over{};
};

/// Draws the frames of one film, best in their order: what one leaves helps with the next, the scene as far as it fits,
/// and the order of its cells. One thread at a time.
class FilmFrames {
public:
    /// Frame `number` of frameCount(film.view.animation), from 0. Errors: as of ScenePipeline.
    Result<Picture> draw(const Film& film, int number, const Progress& progress);

private:
    ScenePipeline picture_;
    ScenePipeline lens_;
};

} // namespace tetra
