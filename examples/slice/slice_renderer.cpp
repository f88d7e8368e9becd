// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/scene_parameters.h>

namespace {
using namespace tetra;

struct Arrow {
    Eigen::Vector3d place, gradient;
};

/// At each vertex of the cut.
std::vector<Arrow> arrowsOf(const MeshCut& cut, std::span<const Eigen::Vector3f> gradients)
{
    std::vector<Arrow> arrows;
    for (std::size_t vertex = 0; vertex < cut.points.size(); ++vertex) {
        const auto& [from, to, share] = cut.points[vertex];
        arrows.push_back({cut.surface.positions[vertex],
                          (gradients[from] + float(share) * (gradients[to] - gradients[from])).cast<double>()});
    }
    return arrows;
}

/// About so many of the arrows, as lines whose heads lie flat before the eye.
std::vector<Drawable> drawnArrows(const std::vector<Arrow>& arrows, double length, const Camera& camera)
{
    constexpr std::size_t mostArrows = 300;
    const std::size_t step = std::max<std::size_t>(1, arrows.size() / mostArrows);
    double steepest = 0;
    for (const Arrow& arrow : arrows)
        steepest = std::max(steepest, arrow.gradient.norm());
    LineSet lines{{}, {}, {0.1f, 0.1f, 0.1f}, 1.5f};
    const Eigen::Vector3d eye = eyePosition(camera);
    for (std::size_t i = 0; i < arrows.size() && steepest > 0; i += step) {
        const Eigen::Vector3d along = arrows[i].gradient * (length / steepest);
        const Eigen::Vector3d tip = arrows[i].place + along;
        const Eigen::Vector3d aside = along.cross(eye - tip).normalized() * along.norm() * 0.2;
        const auto first = std::uint32_t(lines.points.size());
        lines.points.insert(lines.points.end(),
                            {arrows[i].place, tip, tip - 0.35 * along + aside, tip - 0.35 * along - aside});
        for (const std::uint32_t end : {0u, 2u, 3u})
            lines.segments.push_back({first + 1, first + end});
    }
    return {{.id = "lines", .shape = std::move(lines)}};
}

class SliceSession : public RendererSession {
public:
    explicit SliceSession(const RendererMeshes& meshes) : meshes_(meshes), gradients_(vertexGradients(*meshes.mesh)) {}

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, meshes_.bounds);
        if (!scene)
            return scene.error();
        const double low = meshes_.bounds.min().z(), high = meshes_.bounds.max().z();
        const double height = low + (high - low) * view.value<double>("height") / 100;
        const auto cut = cutByPlane(*meshes_.mesh, {Eigen::Vector3d::UnitZ(), height}, progress);
        if (!cut)
            return cut.error();
        const TriangleMesh coloured = colouredByValue(cut->surface, view.value<TransferFunction>(transferId));
        Surface surface{.mesh = std::make_shared<const TriangleMesh>(coloured), .colour = {}, .lit = false};
        scene->drawables.push_back({.id = "slice", .label = "Slice", .shape = std::move(surface), .saved = true});
        const double length = meshes_.bounds.diagonal().norm() / 15;
        const auto arrows = [places = arrowsOf(*cut, gradients_), length](const Camera& camera, int, int) {
            return drawnArrows(places, length, camera);
        };
        if (view.value<bool>("arrows"))
            scene->drawables.push_back({.id = "arrows",
                                        .label = "Gradient",
                                        .shape = std::make_shared<const CustomDrawable>(CustomDrawable{arrows})});
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    RendererMeshes meshes_;
    Buffer<Eigen::Vector3f> gradients_;
};
} // namespace

/// A slice in colours, with arrows.
class SliceRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        Parameter height, arrows;
        height.id = "height";
        height.label = "Height";
        height.explanation = "Where the slice is, from the lowest place to the highest.";
        height.unit = "%";
        height.defaultValue = 50.0;
        height.maximum = 100;
        arrows.id = "arrows";
        arrows.label = "Arrows";
        arrows.explanation = "Shows where the values rise, and how much.";
        arrows.defaultValue = true;
        return {height, arrows, transferParameter(field), clipParameter(), outlineParameter()};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<SliceSession>(meshes);
    }
};

TAN_PLUGIN(SliceRenderer, tetra::Renderer)
