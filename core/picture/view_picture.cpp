// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/view_picture.h"

#include "core/base/guarded.h"
#include "core/base/text.h"
#include "core/history/whole_elsewhere.h"
#include "core/picture/annotations/annotation_painter.h"
#include "core/picture/model_samples.h"
#include "core/picture/rendering_modes.h"
#include "core/picture/shown_error.h"
#include "core/picture/tool_painter.h"
#include "core/render/object_values.h"
#include "core/view/appearance.h"
#include "core/view/view_value.h"
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"

#include <tan/query.h>
#include <tan/render.h>
#include <tan/view.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

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

/// How much of a volume has values from `begin` to `end`, in parts of all.
double shareOf(const ValueHistogram& volumes, double begin, double end)
{
    const double perPart = static_cast<double>(volumes.counts.size()) / (volumes.largest - volumes.least);
    const auto part = [&](double value) {
        const double number = (value - volumes.least) * perPart;
        return volumes.counts.begin() + std::clamp<std::ptrdiff_t>(std::lround(number), 0, std::ssize(volumes.counts));
    };
    return static_cast<double>(std::reduce(part(begin), std::max(part(begin), part(end)), std::uint64_t(0)));
}

/// Where the data have a surface; not one in the background, but on that side of it where there is more.
std::optional<double> surfaceIn(const TetrahedralMesh& mesh, const ValueHistogram& volumes)
{
    const double least = volumes.least, largest = volumes.largest;
    const auto surface = surfaceValue(mesh, least, largest);
    const auto background = backgroundValues(volumes);
    if (!surface || !background || *surface < background->least || *surface > background->largest)
        return surface;
    const bool isAbove = shareOf(volumes, background->largest, largest) >= shareOf(volumes, least, background->least);
    const auto beside =
        isAbove ? surfaceValue(mesh, background->largest, largest) : surfaceValue(mesh, least, background->least);
    return beside ? beside : surface;
}

constexpr Colour lightBackground{0.957F, 0.961F, 0.969F};
constexpr Colour darkBackground{0.118F, 0.125F, 0.137F};

} // namespace

FieldExtent roughExtentOf(const Model& model)
{
    FieldExtent field{model.description().range, model.description().bounds};
    field.hasSamples = model.description().domain == DomainClass::RegularLattice;
    return field;
}

Result<FieldExtent> extentOf(const std::shared_ptr<const Model>& model, const Progress& progress)
{
    const auto look = [&]() -> Result<FieldExtent> {
        FieldExtent field = roughExtentOf(*model);
        const auto mesh = coarseMesh(model, progress);
        if (!mesh)
            return mesh.error();
        field.volumes = volumeHistogram(**mesh, field.range.minimum, field.range.maximum, volumeParts);
        if (model->description().domain != DomainClass::RegularLattice) { // no image of an object in something else
            field.surface = surfaceValue(**mesh, field.range.minimum, field.range.maximum);
            return field;
        }
        field.surface = surfaceIn(**mesh, field.volumes);
        field.object = objectOutline(**mesh, field.volumes, field.surface);
        return field;
    };
    return guarded(Message::marked("Not enough memory to read '%1'. Close other programs."), look,
                   visibleText(model->path().native()));
}

FieldExtent knownExtentOf(const std::shared_ptr<const Model>& model, const Progress& progress)
{
    const auto field = extentOf(model, progress);
    return field ? *field : roughExtentOf(*model);
}

TransferFunction usualTransfer(const std::vector<Provided<Renderer>>& modes, const Model& model,
                               const FieldExtent& field, const QueryState& query)
{
    return startingAppearance(modes, seenWith(field, query, model), model.description().domain).transfer;
}

TransferFunction usualTransfer(const std::vector<Provided<Renderer>>& modes, const Model& model,
                               const FieldExtent& field, const MeshQuery& query)
{
    return startingAppearance(modes, seenWith(field, query, model), model.description().domain).transfer;
}

ViewValue startingView(const std::vector<Provided<Renderer>>& modes, const Model& model, const FieldExtent& field,
                       double aspectRatio)
{
    const QueryState query = startingQuery(model, startingError(model));
    ViewValue view{.query = query,
                   .appearance = startingAppearance(modes, seenWith(field, query, model), model.description().domain),
                   .isovalues = startingIsovalues(modes, field),
                   .camera = usualCamera(model.description())};
    view.camera = framed(view, field.bounds, field.object, aspectRatio);
    return view;
}

std::span<const Eigen::Vector3d> framedObject(const FieldExtent& field, const Renderer* renderer, const ViewValue& view)
{
    if (renderer == nullptr || field.object.empty())
        return field.object;
    const Appearance& look = view.appearance;
    const std::vector<Parameter> shown = matteringParameters(renderer->parameters(field), look.settings);
    const auto boundary = look.settings.find(boundaryId);
    const bool hasBoundary = hasParameter(shown, boundaryId) && boundary != look.settings.end() &&
                             boundary->second != ParameterValue(std::string(boundaryOff));
    if (hasBoundary || hasParameter(shown, slicesId))
        return {};
    const ObjectValues object(field.volumes, field.surface);
    const auto isWithin = [&](const Isovalue& isovalue) {
        return !isovalue.visible || object.hasAllBeyond(isovalue.value);
    };
    const bool isAllWithin =
        (!hasParameter(shown, isovaluesId) || std::ranges::all_of(view.isovalues, isWithin)) &&
        (!hasParameter(shown, transferId) || look.transfer.opacities.empty() || object.hasAllSeenOf(look.transfer));
    return isAllWithin ? std::span<const Eigen::Vector3d>(field.object) : std::span<const Eigen::Vector3d>();
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

SceneRequest withSamples(SceneRequest request, PluginHost& host)
{
    request.samples = [&host](const Model& model, const Progress& progress) {
        return samplesOf(model, host, progress);
    };
    return request;
}

std::vector<ErrorRemark> errorRemarksOf(const FieldExtent& field, const ShownMesh& mesh, const ParameterValues& values,
                                        const Scene& scene)
{
    std::vector<double> isovalues;
    if (const auto found = values.find(isovaluesId); found != values.end())
        if (const auto* all = std::get_if<std::vector<Isovalue>>(&found->second))
            for (const Isovalue& isovalue : *all)
                if (isovalue.visible)
                    isovalues.push_back(isovalue.value);
    const TransferFunction* transfer = nullptr;
    if (const auto found = values.find(transferId); found != values.end() && hasVolume(scene))
        transfer = std::get_if<TransferFunction>(&found->second);
    return shownErrorRemarks(field, mesh.query, mesh.scale, isovalues, transfer);
}

bool hasDarkGround(const Renderer& renderer, const ParameterValues& settings)
{
    const auto parameters = matteringParameters(renderer.parameters({}), settings);
    return hasParameter(parameters, shadedId) && parameterValue<bool>(parameters, settings, shadedId);
}

Colour usualBackground(bool isDark)
{
    return isDark ? darkBackground : lightBackground;
}

Size sizeInUnits(const ViewPicture& picture)
{
    const double scale = annotationScale(picture.size, picture.viewSize);
    return {picture.size.x() / scale, picture.size.y() / scale};
}

Status paintOver(const PixelCanvas& canvas, const AnnotationContent& content, std::span<const ToolDrawing> tools)
{
    if (const Status painted = paintAnnotations(canvas, content); !painted)
        return painted;
    return paintTools(canvas, tools, {content.camera, content.background, content.language, content.fonts});
}

void tellShown(AnnotationContent& content, ShownField shown)
{
    if (shown != ShownField::Mesh)
        content.state[AnnotationKind::Accuracy].shown = true;
}

PictureOrder pictureOrder(const ViewPicture& picture)
{
    const double scale = annotationScale(picture.size, picture.viewSize);
    PictureOrder order;
    order.scene = picture.scene;
    order.camera = picture.annotations.camera;
    order.background = picture.annotations.background;
    order.width = picture.size.x();
    order.height = picture.size.y();
    order.transparent = picture.transparent;
    order.dotsPerInch = picture.dotsPerInch;
    order.lineScale = std::max(1.0, scale);
    order.unit = scale;
    order.lensWriting = {picture.annotations.language.numbers, picture.annotations.fonts};
    if (std::ranges::any_of(picture.annotations.state.places, &AnnotationPlace::shown) || !picture.tools.empty())
        order.over = [content = picture.annotations, tools = picture.tools](const PixelCanvas& canvas) {
            return paintOver(canvas, content, tools);
        };
    return order;
}

} // namespace tetra
