// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_orders.h"

#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/view_picture.h"
#include "ui/tools/tool_painter.h"
#include "ui/tools/tool_stage.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QImage>

#include <utility>

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

/// After the annotations what tools keep, as large beside it as in the view.
void addTools(PictureOrder& order, const ViewPicture& picture, Workbench& workbench)
{
    const double scale = annotationScale(picture.size, picture.viewSize);
    const Camera& camera = picture.annotations.camera;
    const QSizeF size = QSizeF(picture.size.x(), picture.size.y()) / scale;
    auto drawings = keptDrawings(workbench.host().tools(), workbench, camera, size);
    if (drawings.empty())
        return;
    const ToolInk ink{camera, picture.annotations.background, QApplication::font(), {}, {}};
    order.finish = [before = order.finish, drawings = std::move(drawings), ink, scale](Picture& drawn) -> Status {
        if (before)
            if (const Status painted = before(drawn); !painted)
                return painted;
        QImage image(reinterpret_cast<uchar*>(drawn.pixels.data()), drawn.width, drawn.height, 4 * drawn.width,
                     QImage::Format_RGBA8888);
        paintTools(image, drawings, ink, scale);
        return {};
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
    const double scale = annotationScale(picture.size, picture.viewSize);
    order.finish = [content = picture.annotations, scale](Picture& drawn, const ViewValue& view,
                                                          const ShownMesh& mesh) {
        return paintAnnotations(pixelsOf(drawn), inView(content, view, accuracyText(mesh, content.language)), scale);
    };
    return order;
}

} // namespace tetra
