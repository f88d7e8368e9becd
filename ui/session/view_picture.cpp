// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/view_picture.h"

#include "plugins/api/scene_parameters.h"
#include "ui/annotations/annotation_painter.h"
#include "ui/session/accuracy_scale.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr Colour lightBackground{0.957F, 0.961F, 0.969F};
constexpr Colour darkBackground{0.118F, 0.125F, 0.137F};

/// The look of the session, where it says one that is known here; else how the model is looked at first. What settings
/// the session does not have are the renderers' own defaults: how it was seen when it was saved.
Look lookOf(const SessionDocument& document, const std::vector<Provided<Renderer>>& modes, Look look)
{
    if (rendererOf(modes, document.look.mode) != nullptr)
        look.mode = document.look.mode;
    if (!document.look.transfer.opacities.empty())
        look.transfer = document.look.transfer;
    look.settings = document.look.settings;
    return look;
}

/// Of a view that was kept of another field: what is not a place in it nor a value of it.
void leaveWhatFits(SessionDocument& view, const SessionDocument& start)
{
    view.query.focus = start.query.focus;
    view.query.window = start.query.window;
    view.query.values = start.query.values;
    view.look.transfer = {};
    view.look.settings.erase(clipId);
    view.isovalues = start.isovalues;
    view.camera.reset();
    view.animation = {};
}

} // namespace

SessionDocument startingView(const std::vector<Provided<Renderer>>& modes, const Model& model, const FieldExtent& field)
{
    SessionDocument view;
    view.query = startingQuery(model, startingError(model));
    view.look = startingLook(modes, field, model.description().domain);
    view.isovalues = startingIsovalues(modes, field);
    return view;
}

SessionDocument restoredView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                             const FieldExtent& field)
{
    const SessionDocument start = startingView(modes, model, field);
    if (!isOfSameField(kept, model))
        leaveWhatFits(kept, start);
    kept.look = lookOf(kept, modes, start.look);
    kept.query = corrected(kept.query, start.query, model);
    for (Isovalue& isovalue : kept.isovalues)
        isovalue = corrected(isovalue, model.description().range);
    return kept;
}

const Renderer* rendererOf(const std::vector<Provided<Renderer>>& modes, const std::string& id)
{
    const auto found = std::ranges::find(modes, id, &Provided<Renderer>::id);
    return found != modes.end() ? found->plugin : nullptr;
}

SceneRequest sceneOf(const std::shared_ptr<const Model>& model, const Renderer* renderer,
                     const std::vector<Parameter>& parameters, const QueryState& query, const Look& look,
                     const std::vector<Isovalue>& isovalues)
{
    return {model, renderer, meshQuery(query, *model), rendererValues(parameters, look, isovalues), {}};
}

Colour usualBackground(bool isDark)
{
    return isDark ? darkBackground : lightBackground;
}

PictureOrder pictureOrder(const ViewPicture& picture)
{
    const double scale = annotationScale(picture.size, picture.viewSize);
    PictureOrder order;
    order.scene = picture.scene;
    order.camera = picture.annotations.camera;
    order.background = picture.annotations.background;
    order.width = picture.size.width();
    order.height = picture.size.height();
    order.transparent = picture.transparent;
    order.dotsPerInch = picture.dotsPerInch;
    order.lineScale = std::max(1.0, scale);
    if (std::ranges::any_of(picture.annotations.state.places, &AnnotationPlace::shown))
        order.finish = [content = picture.annotations, scale](QImage& image) {
            paintAnnotations(image, content, scale);
        };
    return order;
}

} // namespace tetra
