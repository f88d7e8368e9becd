// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace tetra;

constexpr const char* showsId = "shows";
constexpr const char* volumeOnly = Message::marked("volume").text;
constexpr const char* surfacesOnly = Message::marked("surfaces").text;
constexpr const char* bothOfThem = Message::marked("both").text;

Parameter showsParameter()
{
    Parameter parameter;
    parameter.id = showsId;
    parameter.label = Message::marked("Shows");
    parameter.explanation =
        Message::marked("What is shown, inside and outside the focus: the volume, isosurfaces, or both.");
    parameter.defaultValue = std::string(volumeOnly);
    parameter.choices = {volumeOnly, surfacesOnly, bothOfThem};
    return parameter;
}

Parameter with(Parameter parameter, const char* one, const char* other)
{
    parameter.onlyWith = {showsId, {std::string(one), std::string(other)}};
    return parameter;
}

/// Keeps what is made ready of both meshes, and the boundary of the one outside.
class FocusSession : public RendererSession {
public:
    explicit FocusSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), outside_(meshes.mesh), boundary_(meshes.mesh)
    {
        if (!meshes.focus)
            return;
        regions_ = meshes.focus->regions;
        fine_.emplace(meshes.focus->mesh);
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        const auto shows = view.value<std::string>(showsId);
        if (shows != surfacesOnly)
            if (const Status added = addVolume(view, progress.part(0, 0.4), *scene); !added)
                return added.error();
        if (shows == surfacesOnly || shows == bothOfThem)
            if (const Status added = addSurfaces(view, progress.part(0.4, 0.8), *scene); !added)
                return added.error();
        if (const Status added = addBoundary(boundary_, view, progress.part(0.8, 1), *scene); !added)
            return added.error();
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    /// Of one mesh. Surfaces and volume share it in spatial order.
    struct Caches {
        explicit Caches(std::shared_ptr<const TetrahedralMesh> of)
            : mesh(std::make_shared<OrderedMesh>(std::move(of))), volume(mesh), surfaces(mesh)
        {
        }
        std::shared_ptr<OrderedMesh> mesh;
        VolumeCache volume;
        IsosurfaceCache surfaces;
    };

    Status addVolume(const RendererView& view, const Progress& progress, Scene& scene)
    {
        const auto function = view.value<TransferFunction>(transferId);
        const bool shaded = view.value<bool>(shadedId);
        const auto fullGradient = view.value<double>(fullGradientId);
        Drawable drawable{.id = "volume", .label = "Volume", .shape = {}};
        auto outside = outside_.volume.update(function, shaded, progress.part(0, 0.5));
        if (!outside)
            return outside.error();
        outside->fullGradient = fullGradient;
        if (fine_) {
            auto fine = fine_->volume.update(function, shaded, progress.part(0.5, 1));
            if (!fine)
                return fine.error();
            fine->fullGradient = fullGradient;
            drawable.shape = FocusVolume{*std::move(outside), *std::move(fine), regions_};
        } else {
            drawable.shape = *std::move(outside);
        }
        scene.drawables.push_back(std::move(drawable));
        return {};
    }

    /// Those of both meshes, each with its share of a place.
    Status addSurfaces(const RendererView& view, const Progress& progress, Scene& scene)
    {
        const std::size_t first = scene.drawables.size();
        if (const Status added = addIsosurfaces(outside_.surfaces, view, progress.part(0, 0.5), scene); !added)
            return added;
        if (!fine_)
            return {};
        const std::size_t firstFine = scene.drawables.size();
        if (const Status added = addIsosurfaces(fine_->surfaces, view, progress.part(0.5, 1), scene); !added)
            return added;
        for (std::size_t i = first; i < scene.drawables.size(); ++i) {
            Drawable& drawable = scene.drawables[i];
            const bool isFine = i >= firstFine;
            std::get<Surface>(drawable.shape).share = std::make_shared<const FocusShare>(FocusShare{regions_, isFine});
            if (isFine) {
                drawable.id = "focus-" + drawable.id;
                drawable.label += ", focus";
            }
        }
        return {};
    }

    Eigen::AlignedBox3d bounds_;
    std::vector<FocusRegion> regions_;
    Caches outside_;
    std::optional<Caches> fine_; ///< of the focus
    BoundaryCache boundary_;
};

} // namespace

/// A volume and isosurfaces in two resolutions, blended at the borders of the focus (R24, S18); without a focus in one.
class FocusRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return {showsParameter(),
                transferParameter(field),
                with(isovaluesParameter(field), surfacesOnly, bothOfThem),
                with(shadedParameter(field), volumeOnly, bothOfThem),
                fullGradientParameter(field),
                boundaryParameter(),
                boundaryOpacityParameter(),
                boundaryFarSideParameter(),
                boundaryLitParameter(),
                clipParameter(),
                outlineParameter(field)};
    }

    RendererNeeds needs() const override { return {.focusMesh = true}; }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<FocusSession>(meshes);
    }
};

TAN_PLUGIN(FocusRenderer, tetra::Renderer)
