// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/shown_mesh.h"
#include "ui/session/view_value.h"
#include "ui/workbench/picture_file.h"

#include <vector>

namespace tetra {

/// A film to write: that of a view.
struct FilmOrder {
    std::shared_ptr<const Model> model{};
    const Renderer* renderer = nullptr;
    std::vector<Parameter> parameters{}; ///< of the renderer
    ViewValue view{};
    PictureOrder picture{}; ///< size and background of each frame; the rest is the frame's
    /// Paints over a frame; called in the worker.
    std::function<void(QImage& picture, const ViewValue& view, const ShownMesh& mesh)> finish{};
    std::filesystem::path target{}; ///< a video, or name.png for name_0001.png and so on
    QString encoder{};              ///< of videos
};

/// The file of a frame: NAME_0001.png, of as many digits as `count` needs, four at least.
std::filesystem::path framePath(const std::filesystem::path& target, int frame, int count);

/// The files there that the film would take the place of. O(files in the folder), which may lie far away: not for the
/// GUI thread.
std::vector<std::filesystem::path> filesInTheWay(const std::filesystem::path& target, int count);

/// Draws all frames into a folder beside the target; when all are done they take their names, or become the video.
/// Cancelled or failed it leaves nothing behind, and what was there stays.
Status writeFilm(const FilmOrder& order, const Progress& progress);

} // namespace tetra
