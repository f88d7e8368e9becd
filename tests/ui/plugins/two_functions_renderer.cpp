// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

namespace tetra {
namespace {

constexpr const char* bonesId = "bones";
constexpr const char* veinsId = "veins";

class TwoFunctionsSession : public RendererSession {
public:
    explicit TwoFunctionsSession(const Eigen::AlignedBox3d& bounds) : bounds_(bounds) {}
    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress&) override
    {
        Scene scene{.bounds = bounds_};
        for (const char* id : {bonesId, veinsId}) {
            const auto points = static_cast<float>(view.value<TransferFunction>(id).opacities.size());
            scene.drawables.push_back({.id = id, .shape = boxOutline(bounds_, Colour{1, 1, 1}, points)});
        }
        return std::make_shared<const Scene>(std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
};

} // namespace

/// A mode with two transfer functions of its own, and without the one that the built-in modes share. Each is an outline
/// as many pixels wide as its curve of opacities has points.
class TwoFunctionsRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        Parameter bones = transferParameter(field);
        bones.id = bonesId;
        bones.label = "Bones";
        bones.explanation = "The colour and the opacity of bones.";
        Parameter veins = bones;
        veins.id = veinsId;
        veins.label = "Veins";
        veins.explanation = "The colour and the opacity of veins.";
        std::get<TransferFunction>(veins.defaultValue).unitDistance *= 2;
        return {bones, veins};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<TwoFunctionsSession>(meshes.bounds);
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::TwoFunctionsRenderer, tetra::Renderer)
