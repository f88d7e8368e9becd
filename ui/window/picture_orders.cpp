// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_orders.h"

#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/view_picture.h"
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
    return picture;
}

} // namespace

PictureOrder pictureOrder(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    ViewPicture picture = pictureOf(workbench, viewport, settings);
    picture.scene = viewport.scene();
    PictureOrder order = pictureOrder(picture);
    if (const LensState& lens = workbench.session().view().lens; lens.isOn() && workbench.session().model())
        order.lens = std::make_shared<const LensOrder>(LensOrder{lens, workbench.scenes().sceneRequest()});
    return order;
}

FilmOrder filmOrder(const Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    const ViewPicture picture = pictureOf(workbench, viewport, settings);
    FilmOrder order = workbench.exporting().filmOrder();
    order.picture = pictureOrder(picture);
    const double scale = annotationScale(picture.size, picture.viewSize);
    order.finish = [content = picture.annotations, scale](Picture& drawn, const ViewValue& view,
                                                          const ShownMesh& mesh) {
        return paintAnnotations(pixelsOf(drawn), inView(content, view, accuracyText(mesh, content.language)), scale);
    };
    return order;
}

} // namespace tetra
