// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen as pictures and films, and pictures that say how they were made.
#include "ui/session/target_path.h"
#include "ui/session/view_picture.h"
#include "ui/session/workbench.h"

namespace tetra {

void Workbench::savePicture(const PictureOrder& order)
{
    std::optional<SceneRequest> ofItsOwn; // a scene for this camera and size, if the mode depends on them
    if (session_.model() && renderer() != nullptr && renderer()->needs().view && order.scene) {
        ofItsOwn = sessionRequest();
        ofItsOwn->camera = order.camera;
        ofItsOwn->width = order.width;
        ofItsOwn->height = order.height;
    }
    savingPicture_.enqueue(
        [this, order, ofItsOwn, model = session_.model()](const Progress& progress) -> std::function<void()> {
            const auto picture = ofItsOwn ? drawPicture(order, *ofItsOwn, progress) : drawPicture(order, progress);
            const Status right = model ? model->confirm(progress.withCallback({})) : Status();
            const Status done = !picture               ? Status(picture.error())
                                : !right               ? right
                                : order.target.empty() ? Status()
                                                       : writePicture(*picture, order.target);
            return [this, order, done, picture] {
                if (!tellSave(done))
                    return;
                if (order.target.empty())
                    emit pictureDrawn(*picture);
                else
                    emit pictureSaved(pathText(order.target));
            };
        });
}

AnnotationContent Workbench::annotations(const Camera& camera, const Colour& background) const
{
    AnnotationContent content;
    if (const auto& model = session_.model()) {
        const ViewState& view = session_.view();
        const auto& shown = session_.shown();
        content = annotationContent(*model, matteringParameters(), preview_ ? preview_->transfer : view.look().transfer,
                                    preview_ ? preview_->isovalues : view.isovalues(), shown ? &*shown : nullptr);
    }
    content.state = session_.view().annotations();
    content.camera = camera;
    content.background = background;
    return content;
}

SessionDocument Workbench::startingView() const
{
    return tetra::startingView(modes_, *session_.model(), field_);
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
    filmTarget_ = order.target;
    savingFilm_.start([this, order](const Progress& progress) -> std::function<void()> {
        return [this, order, written = writeFilm(order, progress)] {
            if (tellSave(written))
                emit filmSaved(pathText(order.target));
        };
    });
}

} // namespace tetra
