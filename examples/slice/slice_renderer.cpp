// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/scene_parameters.h>

#include <QObject>

namespace {
using namespace tetra;

struct Arrow {
    Eigen::Vector3f place, gradient;
};

struct Slice {
    std::shared_ptr<const TriangleMesh> surface; ///< with values, in the colours of a transfer function
    std::vector<Arrow> arrows;
};

/// A corner of the slice: where an edge of a tetrahedron passes through the plane.
void addCorner(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients, std::uint32_t from,
               std::uint32_t to, float height, TriangleMesh& slice, std::vector<Arrow>& arrows)
{
    const float below = mesh.positions[from].z() - height, above = mesh.positions[to].z() - height;
    const float share = below / (below - above);
    slice.positions.push_back(mesh.positions[from] + share * (mesh.positions[to] - mesh.positions[from]));
    slice.values.push_back(mesh.values[from] + share * (mesh.values[to] - mesh.values[from]));
    slice.normals.push_back(Eigen::Vector3f::UnitZ());
    arrows.push_back({slice.positions.back(), gradients[from] + share * (gradients[to] - gradients[from])});
}

Slice sliceOf(const TetrahedralMesh& mesh, std::span<const Eigen::Vector3f> gradients, float height)
{
    TriangleMesh slice;
    std::vector<Arrow> arrows;
    for (const auto& cell : mesh.tetrahedra) {
        std::vector<std::uint32_t> below, above;
        for (const std::uint32_t corner : cell)
            (mesh.positions[corner].z() < height ? below : above).push_back(corner);
        const auto first = std::uint32_t(slice.positions.size());
        for (const std::uint32_t from : below)
            for (const std::uint32_t to : above)
                addCorner(mesh, gradients, from, to, height, slice, arrows);
        const auto count = std::uint32_t(slice.positions.size()) - first; // 0, 3 or 4: ac, ad, bc, bd
        if (count > 0)
            slice.triangles.push_back({first, first + 1, first + 2});
        if (count == 4)
            slice.triangles.push_back({first + 1, first + 3, first + 2});
    }
    return {std::make_shared<const TriangleMesh>(std::move(slice)), std::move(arrows)};
}

/// About so many of the arrows, as lines whose heads lie flat before the eye.
std::vector<Drawable> drawnArrows(const std::vector<Arrow>& arrows, float length, const Camera& camera)
{
    constexpr std::size_t mostArrows = 300;
    const std::size_t step = std::max<std::size_t>(1, arrows.size() / mostArrows);
    float steepest = 0;
    for (const Arrow& arrow : arrows)
        steepest = std::max(steepest, arrow.gradient.norm());
    LineSet lines{{}, {}, {0.1f, 0.1f, 0.1f}, 1.5f};
    const Eigen::Vector3f eye = eyePosition(camera).cast<float>();
    for (std::size_t i = 0; i < arrows.size() && steepest > 0; i += step) {
        const Eigen::Vector3f along = arrows[i].gradient * (length / steepest);
        const Eigen::Vector3f tip = arrows[i].place + along;
        const Eigen::Vector3f aside = along.cross(eye - tip).normalized() * along.norm() * 0.2f;
        const auto first = std::uint32_t(lines.points.size());
        lines.points.insert(lines.points.end(),
                            {arrows[i].place, tip, tip - 0.35f * along + aside, tip - 0.35f * along - aside});
        for (const std::uint32_t end : {0u, 2u, 3u})
            lines.segments.push_back({first + 1, first + end});
    }
    return {{.id = "lines", .shape = std::move(lines)}};
}

class SliceSession : public RendererSession {
public:
    explicit SliceSession(const RendererMeshes& meshes) : meshes_(meshes), gradients_(vertexGradients(*meshes.mesh)) {}

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress&) override
    {
        auto scene = startScene(view, meshes_.bounds);
        if (!scene)
            return scene.error();
        const double low = meshes_.bounds.min().z(), high = meshes_.bounds.max().z();
        const double height = low + (high - low) * view.value<double>("height") / 100;
        const Slice slice = sliceOf(*meshes_.mesh, gradients_, float(height));
        const TriangleMesh coloured = colouredByValue(*slice.surface, view.value<TransferFunction>(transferId));
        Surface surface{.mesh = std::make_shared<const TriangleMesh>(coloured), .colour = {}, .lit = false};
        scene->drawables.push_back({.id = "slice", .label = "Slice", .shape = std::move(surface), .saved = true});
        const auto length = float(meshes_.bounds.diagonal().norm() / 15);
        const auto arrows = [places = slice.arrows, length](const Camera& camera, int, int) {
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
class SliceRenderer : public QObject, public tetra::Renderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "slice_renderer.json")
    Q_INTERFACES(tetra::Renderer)

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

#include "slice_renderer.moc"
