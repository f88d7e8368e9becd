// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/film.h"

#include "core/picture/view_picture.h"

#include <utility>

namespace tetra {

Result<Picture> FilmFrames::draw(const Film& film, int number, const Progress& progress)
{
    ViewValue view = viewAtFrame(film.view, number);
    view.query = corrected(view.query, film.view.query, *film.model); // key frames may be of another model
    SceneRequest request = sceneOf(film.model, film.renderer, film.parameters, view);
    request.width = film.picture.width;
    request.height = film.picture.height;
    request.samples = film.samples;
    const auto built = picture_.make(request, progress);
    if (!built)
        return built.error();
    PictureOrder order = film.picture;
    order.scene = built->scene;
    order.camera = view.camera;
    if (film.over)
        order.over = [&](const PixelCanvas& canvas) { return film.over(canvas, view, built->mesh); };
    if (view.lens.isOn())
        order.lens = std::make_shared<const LensOrder>(LensOrder{view.lens, request});
    auto drawn = picture_.draw(order, false, progress);
    if (!drawn)
        return drawn.error();
    return lens_.finish(order, *std::move(drawn), progress);
}

} // namespace tetra
