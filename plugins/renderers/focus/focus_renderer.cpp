// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

#include <QObject>

#include <optional>

namespace {
using namespace tetra;

/// Keeps what is made ready of both meshes, and the boundary of the one outside.
class FocusSession : public RendererSession {
public:
    explicit FocusSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), focus_(meshes.focus), outside_(meshes.mesh), boundary_(meshes.mesh)
    {
        if (focus_)
            fine_.emplace(focus_->mesh);
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        const auto function = view.value<TransferFunction>(transferId);
        const bool shaded = view.value<bool>(shadedId);
        Drawable drawable{.id = "volume", .label = "Volume", .shape = {}};
        auto outside = outside_.update(function, shaded, progress.part(0, 0.4));
        if (!outside)
            return outside.error();
        if (focus_) {
            auto fine = fine_->update(function, shaded, progress.part(0.4, 0.8));
            if (!fine)
                return fine.error();
            drawable.shape = FocusVolume{*std::move(outside), *std::move(fine), focus_->region, focus_->border};
        } else {
            drawable.shape = *std::move(outside);
        }
        scene->drawables.push_back(std::move(drawable));
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
    std::optional<FocusMesh> focus_;
    VolumeCache outside_;
    std::optional<VolumeCache> fine_; ///< of the focus
    BoundaryCache boundary_;
};

} // namespace

/// A volume in two resolutions, blended at the border of the focus (R24, S18); without a focus in one.
class FocusRenderer : public QObject, public tetra::Renderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "focus_renderer.json")
    Q_INTERFACES(tetra::Renderer)

public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return {transferParameter(field),   shadedParameter(), boundaryParameter(), boundaryOpacityParameter(),
                boundaryFarSideParameter(), clipParameter(),   outlineParameter()};
    }

    RendererNeeds needs() const override { return {.focusMesh = true}; }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<FocusSession>(meshes);
    }
};

#include "focus_renderer.moc"
