// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

namespace {
using namespace tetra;

/// Keeps what the two caches keep: another colour extracts nothing.
class IsosurfaceSession : public RendererSession {
public:
    explicit IsosurfaceSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), surfaces_(meshes.mesh), boundary_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        if (const Status added = addIsosurfaces(surfaces_, view, progress.part(0, 0.8), *scene); !added)
            return added.error();
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
    IsosurfaceCache surfaces_;
    BoundaryCache boundary_;
};

} // namespace

/// Surfaces on which the field has chosen values (R19).
class IsosurfaceRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return {isovaluesParameter(field),
                boundaryParameter(),
                boundaryOpacityParameter(),
                boundaryFarSideParameter(),
                boundaryLitParameter(),
                boundaryTransferParameter(field),
                clipParameter(),
                outlineParameter(field)};
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<IsosurfaceSession>(meshes);
    }
};

TAN_PLUGIN(IsosurfaceRenderer, tetra::Renderer)
