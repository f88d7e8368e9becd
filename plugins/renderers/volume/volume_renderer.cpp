// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

namespace {
using namespace tetra;

/// Keeps what the two caches keep: another transfer function leaves the mesh as it is, another shading or clip plane
/// both.
class VolumeSession : public RendererSession {
public:
    explicit VolumeSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), volume_(meshes.mesh), boundary_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        auto volume =
            volume_.update(view.value<TransferFunction>(transferId), view.value<bool>(shadedId), progress.part(0, 0.8));
        if (!volume)
            return volume.error();
        volume->fullGradient = view.value<double>(fullGradientId);
        scene->drawables.push_back({.id = "volume", .label = "Volume", .shape = *std::move(volume)});
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
    VolumeCache volume_;
    BoundaryCache boundary_;
};

} // namespace

/// The field as a translucent cloud (R20).
class VolumeRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return withShown({transferParameter(field), shadedParameter(field), fullGradientParameter(field),
                          boundaryParameter(), boundaryOpacityParameter(), boundaryFarSideParameter(),
                          boundaryLitParameter(), clipParameter(), outlineParameter(field)},
                         field);
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<VolumeSession>(meshes);
    }
};

TAN_PLUGIN(VolumeRenderer, tetra::Renderer)
