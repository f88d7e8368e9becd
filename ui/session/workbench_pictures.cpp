// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen as pictures and films, and pictures that say how they were made.
#include "ui/session/picture_texts.h"
#include "ui/session/target_path.h"
#include "ui/session/workbench.h"

namespace tetra {

void Workbench::savePicture(const PictureOrder& order)
{
    pictures_.push_back(order);
    pictures_.back().model = session_.model();
    emit picturesWaitingChanged();
    saveNextPicture();
}

void Workbench::saveNextPicture()
{
    if (pictures_.empty() || savingPicture_.running())
        return;
    const PictureOrder order = pictures_.front();
    pictures_.pop_front();
    emit picturesWaitingChanged();
    savingPicture_.start([this, order](const Progress& progress) -> std::function<void()> {
        const auto picture = drawPicture(order, progress);
        const Status right = order.model ? order.model->confirm(progress.withCallback({})) : Status();
        const Status done = !picture               ? Status(picture.error())
                            : !right               ? right
                            : order.target.empty() ? Status()
                                                   : writePicture(*picture, order.target);
        return [this, order, done, picture] {
            if (!done)
                tell(done.error());
            else if (order.target.empty())
                emit pictureDrawn(*picture);
            else
                emit pictureSaved(pathText(order.target));
            saveNextPicture();
        };
    });
}

/// One of ours, or a dataset.
void Workbench::openPicture(const std::filesystem::path& path)
{
    textFiles_.start([this, path](const Progress&) -> std::function<void()> {
        return [this, path, session = sessionInPicture(path)] {
            if (session.empty())
                look(path, false);
            else
                emit pictureOpened(pathText(path), session);
        };
    });
}

FilmFrame Workbench::presentFrame(const Camera& camera) const
{
    const ViewState& view = session_.view();
    return {
        camera, view.look().transfer, view.isovalues(), view.query().error, view.query().byBudget, view.query().budget};
}

FilmOrder Workbench::filmOrder(const Camera& camera) const
{
    const ViewState& view = session_.view();
    FilmOrder order;
    order.animation = view.animation();
    order.start = presentFrame(camera);
    order.scene = {session_.model(), renderer(), {}, {}, {}};
    order.parameters = renderingParameters();
    order.look = view.look();
    order.query = view.query();
    return order;
}

void Workbench::previewFrame(const std::optional<FilmFrame>& frame)
{
    std::optional<FilmFrame> next = session_.model() ? frame : std::nullopt;
    if (next)
        next->camera = {}; // not the model's matter
    if (next == preview_)
        return;
    preview_ = next;
    requestScene();
}

void Workbench::saveFilm(const FilmOrder& order)
{
    savingFilm_.start([this, order](const Progress& progress) -> std::function<void()> {
        return [this, order, written = writeFilm(order, progress)] {
            if (written)
                emit filmSaved(pathText(order.target));
            else
                tell(written.error());
        };
    });
}

} // namespace tetra
