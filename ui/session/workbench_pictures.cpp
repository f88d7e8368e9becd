// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen as pictures and films, and pictures that say how they were made.
#include "ui/session/target_path.h"
#include "ui/session/view_picture.h"
#include "ui/session/workbench.h"

namespace tetra {

void Workbench::savePicture(const PictureOrder& order)
{
    savingPicture_.enqueue([this, order, model = session_.model()](const Progress& progress) -> std::function<void()> {
        const auto picture = drawPicture(order, progress);
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
    ViewValue view = preview_.value_or(session_.view());
    view.annotations = session_.view().annotations;
    view.camera = camera;
    view.background = background;
    const auto& shown = session_.shown();
    return session_.model()
               ? annotationContent(*session_.model(), matteringParameters(), view, shown ? &*shown : nullptr)
               : AnnotationContent{.state = view.annotations, .camera = camera, .background = background};
}

ViewValue Workbench::startingView() const
{
    return tetra::startingView(modes_, *session_.model(), field_, session_.shape());
}

FilmOrder Workbench::filmOrder() const
{
    return {.model = session_.model(),
            .renderer = renderer(),
            .parameters = renderingParameters(),
            .view = session_.view()};
}

void Workbench::previewView(const std::optional<ViewValue>& view)
{
    std::optional<ViewValue> next = session_.model() ? view : std::nullopt;
    if (next) {
        next->query = corrected(next->query, session_.view().query, *session_.model());
        next->camera = {}; // not the model's matter
    }
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
