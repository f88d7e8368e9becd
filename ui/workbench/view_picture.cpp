// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/view_picture.h"

#include "core/history/whole_elsewhere.h"
#include "plugins/api/scene_parameters.h"
#include "ui/annotations/annotation_painter.h"
#include "ui/session/accuracy_scale.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <new>

namespace tetra {
namespace {

constexpr std::uint64_t largestMesh = 100'000; // tetrahedra
constexpr int volumeParts = 256;
constexpr double everyError = 1e9; ///< %

/// The finest that is small, or the coarsest if that is not.
std::uint32_t sitesOfCoarseMesh(const Model& model)
{
    const auto size = meshSizeWithin(model, {}, largestMesh);
    return size ? size->sites : meshSizeAt(model, {.error = everyError}).sites;
}

/// That mesh; of a model at a server as large a one as that.
Result<std::shared_ptr<const TetrahedralMesh>> coarseMesh(const std::shared_ptr<const Model>& model,
                                                          const Progress& progress)
{
    if (model->elsewhere() == nullptr) {
        auto mesh = extractPrefix(*model, sitesOfCoarseMesh(*model), progress);
        if (!mesh)
            return mesh.error();
        return std::make_shared<const TetrahedralMesh>(*std::move(mesh));
    }
    MeshQuery query;
    query.warping = model->description().warpingWeight > 0 ? 0 : anyWarping;
    query.budget = std::max(largestMesh, meshSizeAt(*model, {.error = anyError}).tetrahedra);
    const auto mesh = MeshExtractor(model).extract(query, progress);
    return mesh ? Result<std::shared_ptr<const TetrahedralMesh>>(meshOf(*mesh)) : mesh.error();
}

constexpr Colour lightBackground{0.957F, 0.961F, 0.969F};
constexpr Colour darkBackground{0.118F, 0.125F, 0.137F};

/// The appearance of the session, where it says one that is known here; else how the model is seen at first. What
/// settings the session does not have are the renderers' own defaults: how it was seen when it was saved.
Appearance known(Appearance appearance, const std::vector<Provided<Renderer>>& modes, const Appearance& start)
{
    if (rendererOf(modes, appearance.mode) == nullptr)
        appearance.mode = start.mode;
    if (appearance.transfer.opacities.empty())
        appearance.transfer = start.transfer;
    return appearance;
}

/// Drops from a view of another field what depends on its places or values.
void dropWhatDoesNotFit(SessionDocument& kept, const ViewValue& start)
{
    kept.view.query.focus = start.query.focus;
    kept.view.query.window = start.query.window;
    kept.view.query.values = start.query.values;
    kept.view.query.range = start.query.range;
    kept.view.appearance.transfer = {};
    kept.view.appearance.settings.erase(clipId);
    kept.view.isovalues = start.isovalues;
    kept.hasCamera = false;
    kept.view.animation = {};
}

} // namespace

FieldExtent roughExtentOf(const Model& model)
{
    return {model.description().range, model.description().bounds};
}

FieldExtent extentOf(const std::shared_ptr<const Model>& model, const Progress& progress)
try {
    FieldExtent field = roughExtentOf(*model);
    if (const auto mesh = coarseMesh(model, progress)) {
        field.volumes = volumeHistogram(**mesh, field.range.minimum, field.range.maximum, volumeParts);
        field.surface = surfaceValue(**mesh, field.range.minimum, field.range.maximum);
    }
    return field;
} catch (const std::bad_alloc&) {
    return roughExtentOf(*model);
}

ViewValue startingView(const std::vector<Provided<Renderer>>& modes, const Model& model, const FieldExtent& field,
                       double aspectRatio)
{
    return {.query = startingQuery(model, startingError(model)),
            .appearance = startingAppearance(modes, field, model.description().domain),
            .isovalues = startingIsovalues(modes, field),
            .camera = fitted(Camera(), model.description().bounds, aspectRatio)};
}

SessionDocument restoredView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                             const FieldExtent& field)
{
    const ViewValue start = startingView(modes, model, field);
    if (!isOfSameField(kept, model))
        dropWhatDoesNotFit(kept, start);
    kept.view.appearance = known(std::move(kept.view.appearance), modes, start.appearance);
    FocusState& focus = kept.view.query.focus; // earlier versions wrote no lengths for these
    focus.distance = focus.distance > 0 ? focus.distance : start.query.focus.distance;
    focus.valueFalloff = focus.valueFalloff > 0 ? focus.valueFalloff : start.query.focus.valueFalloff;
    kept.view.query = corrected(kept.view.query, start.query, model);
    for (Isovalue& isovalue : kept.view.isovalues)
        isovalue = corrected(isovalue, model.description().range);
    return kept;
}

const Renderer* rendererOf(const std::vector<Provided<Renderer>>& modes, const std::string& id)
{
    const auto found = std::ranges::find(modes, id, &Provided<Renderer>::id);
    return found != modes.end() ? found->plugin : nullptr;
}

SceneRequest sceneOf(const std::shared_ptr<const Model>& model, const Renderer* renderer,
                     const std::vector<Parameter>& parameters, const ViewValue& view)
{
    SceneRequest request{model, renderer, meshQuery(view.query, *model, presentView(view)),
                         rendererValues(parameters, view.appearance, view.isovalues), view.camera};
    request.faultyCells = showsFaultyCells(view.appearance);
    return request;
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
