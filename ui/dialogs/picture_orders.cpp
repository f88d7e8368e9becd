// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/picture_orders.h"

#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/kept_tools.h"
#include "core/picture/view_picture.h"
#include "core/view/appearance.h"
#include "ui/viewport/viewport.h"

namespace tetra {
namespace {

/// Of a preview that is what is seen; else the camera that was asked for, which the picture may be on its way to.
ViewPicture pictureOf(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    const Camera& camera = viewport.previewing() ? viewport.shownCamera() : viewport.camera();
    ViewPicture picture{.annotations = workbench.scenes().annotations(camera, viewport.background()),
                        .size = {settings.size.width(), settings.size.height()},
                        .viewSize = {viewport.width(), viewport.height()},
                        .transparent = settings.transparent,
                        .dotsPerInch = settings.dotsPerInch};
    picture.annotations.state = settings.annotations;
    if (const auto& shown = workbench.session().shown())
        tellShown(picture.annotations, shown->shown);
    return picture;
}

} // namespace

PictureOrder pictureOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    ViewPicture picture = pictureOf(workbench, viewport, settings);
    picture.scene = viewport.scene();
    if (const Session& session = workbench.session(); session.model())
        picture.tools = keptDrawings(keptTools(workbench.host(), session.view()), session.model()->description(),
                                     workbench.scenes().matteringParameters(), session.view(),
                                     picture.annotations.camera, sizeInUnits(picture), picture.annotations.language);
    PictureOrder order = pictureOrder(picture);
    if (const LensState& lens = workbench.session().view().lens; lens.isOn() && workbench.session().model())
        order.lens = std::make_shared<const LensOrder>(LensOrder{lens, workbench.scenes().sceneRequest()});
    return order;
}

FilmOrder filmOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    const ViewPicture picture = pictureOf(workbench, viewport, settings);
    FilmOrder order = workbench.exporting().filmOrder();
    order.picture = pictureOrder(picture);
    order.over = [content = picture.annotations, size = sizeInUnits(picture), model = order.model,
                  parameters = order.parameters, tools = keptTools(workbench.host(), order.view)](
                     const PixelCanvas& canvas, const ViewValue& view, const ShownMesh& mesh) {
        const auto shown =
            keptDrawings(tools, model->description(), matteringParameters(parameters, view.appearance.settings), view,
                         view.camera, size, content.language);
        AnnotationContent written = inView(content, view, accuracyText(mesh, content.language));
        tellShown(written, mesh.shown);
        return paintOver(canvas, written, shown);
    };
    return order;
}

} // namespace tetra
