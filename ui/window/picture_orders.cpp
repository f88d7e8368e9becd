// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_orders.h"

#include "ui/annotations/annotation_painter.h"
#include "ui/viewport/viewport.h"

namespace tetra {
namespace {

AnnotationContent contentOf(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    AnnotationContent content = annotationContent(workbench, viewport.camera(), viewport.background());
    content.state = settings.annotations;
    return content;
}

PictureOrder orderOf(const Viewport& viewport, const PictureSettings& settings)
{
    PictureOrder order;
    order.background = viewport.background();
    order.width = settings.size.width();
    order.height = settings.size.height();
    order.transparent = settings.transparent;
    order.dotsPerInch = settings.dotsPerInch;
    order.lineScale = std::max(1.0, annotationScale(settings.size, viewport.size()));
    return order;
}

} // namespace

QSize pixelsOf(const Viewport& viewport)
{
    return viewport.size() * viewport.devicePixelRatioF();
}

PictureOrder pictureOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    PictureOrder order = orderOf(viewport, settings);
    order.scene = viewport.scene();
    order.camera = viewport.camera();
    order.finish = [content = contentOf(workbench, viewport, settings),
                    scale = annotationScale(settings.size, viewport.size())](QImage& image) {
        paintAnnotations(image, content, scale);
    };
    return order;
}

FilmOrder filmOrder(Workbench& workbench, const Viewport& viewport, const PictureSettings& settings)
{
    FilmOrder order = workbench.filmOrder(viewport.camera());
    order.picture = orderOf(viewport, settings);
    order.finish = [content = contentOf(workbench, viewport, settings),
                    scale = annotationScale(settings.size, viewport.size())](QImage& image, const FilmFrame& frame,
                                                                             const ShownMesh& mesh) {
        paintAnnotations(image, atFrame(content, frame, mesh), scale);
    };
    return order;
}

} // namespace tetra
