// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_orders.h"

#include "ui/annotations/annotation_painter.h"
#include "ui/scenes/view_picture.h"
#include "ui/tools/tool_painter.h"
#include "ui/tools/tool_stage.h"
#include "ui/viewport/viewport.h"

#include <utility>

namespace tetra {
namespace {

/// Of a preview that is what is seen; else the camera that was asked for, which the picture may be on its way to.
ViewPicture pictureOf(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    const Camera& camera = viewport.previewing() ? viewport.shownCamera() : viewport.camera();
    ViewPicture picture{.annotations = workbench.scenes().annotations(camera, viewport.background()),
                        .size = settings.size,
                        .viewSize = viewport.size(),
                        .transparent = settings.transparent,
                        .dotsPerInch = settings.dotsPerInch};
    picture.annotations.state = settings.annotations;
    return picture;
}

/// After the annotations what tools keep, as large beside it as in the view.
void addTools(PictureOrder& order, const ViewPicture& picture, Workbench& workbench)
{
    const double scale = annotationScale(picture.size, picture.viewSize);
    const Camera& camera = picture.annotations.camera;
    auto drawings = keptDrawings(workbench.host().tools(), workbench, camera, QSizeF(picture.size) / scale);
    if (drawings.empty())
        return;
    const ToolInk ink{camera, picture.annotations.background, picture.annotations.font, {}, {}};
    order.finish = [before = order.finish, drawings = std::move(drawings), ink, scale](QImage& image) {
        if (before)
            before(image);
        paintTools(image, drawings, ink, scale);
    };
}

} // namespace

PictureOrder pictureOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    ViewPicture picture = pictureOf(workbench, viewport, settings);
    picture.scene = viewport.scene();
    PictureOrder order = pictureOrder(picture);
    addTools(order, picture, workbench);
    if (const LensState& lens = workbench.session().view().lens; lens.isOn() && workbench.session().model())
        order.lens = std::make_shared<const LensOrder>(LensOrder{lens, workbench.scenes().sceneRequest()});
    return order;
}

FilmOrder filmOrder(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    const ViewPicture picture = pictureOf(workbench, viewport, settings);
    FilmOrder order = workbench.exporting().filmOrder();
    order.picture = pictureOrder(picture);
    order.finish = [content = picture.annotations, scale = annotationScale(picture.size, picture.viewSize)](
                       QImage& image, const ViewValue& view, const ShownMesh& mesh) {
        paintAnnotations(image, inView(content, view, mesh), scale);
    };
    return order;
}

} // namespace tetra
