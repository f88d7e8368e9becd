// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

namespace {
using namespace tetra;

constexpr const char* orderId = "order";
constexpr const char* exact = Message::marked("exact").text;
constexpr const char* withCell = Message::marked("with-cell").text;

Parameter orderParameter()
{
    Parameter parameter;
    parameter.id = orderId;
    parameter.label = Message::marked("Order");
    parameter.explanation =
        Message::marked("How surfaces and volume are put in order: 'exact', or, as the paper did, 'with-cell', where "
                        "the part of a surface in a cell is drawn before the cell.");
    parameter.defaultValue = std::string(exact);
    parameter.choices = {exact, withCell};
    return parameter;
}

/// Keeps what the caches keep. Surfaces and volume share the mesh in spatial order.
class HybridSession : public RendererSession {
public:
    explicit HybridSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), mesh_(std::make_shared<OrderedMesh>(meshes.mesh)), surfaces_(mesh_), volume_(mesh_),
          boundary_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        // First what puts the mesh in spatial order: surfaces are quicker then.
        auto volume =
            volume_.update(view.value<TransferFunction>(transferId), view.value<bool>(shadedId), progress.part(0, 0.4));
        if (!volume)
            return volume.error();
        volume->fullGradient = view.value<double>(fullGradientId);
        volume->wholeCells = view.value<std::string>(orderId) == withCell;
        scene->drawables.push_back({.id = "volume", .label = "Volume", .shape = *std::move(volume)});
        if (const Status added = addIsosurfaces(surfaces_, view, progress.part(0.4, 0.8), *scene); !added)
            return added.error();
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
    std::shared_ptr<OrderedMesh> mesh_;
    IsosurfaceCache surfaces_;
    VolumeCache volume_;
    BoundaryCache boundary_;
};

} // namespace

/// Isosurfaces in a volume (R21).
class HybridRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return withShown({transferParameter(field), isovaluesParameter(field), shadedParameter(field),
                          fullGradientParameter(field), orderParameter(), boundaryParameter(),
                          boundaryOpacityParameter(), boundaryFarSideParameter(), boundaryLitParameter(),
                          clipParameter(), outlineParameter(field)},
                         field);
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<HybridSession>(meshes);
    }
};

TAN_PLUGIN(HybridRenderer, tetra::Renderer)
