// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/scene_parameters.h>

#include <string>

namespace {
using namespace tetra;

/// The largest value of each ray: from black at the least of `range` by blue to white at the largest. A channel of the
/// colour rises with the value, so that the largest of each channel is the colour of the largest value.
std::shared_ptr<const OpticalModel> brightestValue(const ValueRange& range)
{
    const auto least = float(range.minimum), extent = float(range.extent() > 0 ? range.extent() : 1);
    OpticalModel model;
    model.combiner = Combiner::Maximum;
    model.evaluate = [least, extent](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            const float share = std::clamp((std::max(pieces.entry[i], pieces.exit[i]) - least) / extent, 0.0f, 1.0f);
            pieces.red[i] = pieces.green[i] = share * share;
            pieces.blue[i] = share;
            pieces.transmittance[i] = 1 - share;
        }
    };
    model.shader = R"(
vec4 lightOfPiece(float entry, float exit, float way, float gradient)
{
    float least = float()" +
                   formatNumber(least) + "), extent = float(" + formatNumber(extent) + R"();
    float share = clamp((max(entry, exit) - least) / extent, 0.0, 1.0);
    return vec4(share * share, share * share, share, share);
}
)";
    return std::make_shared<const OpticalModel>(model);
}

class Projection : public RendererSession {
public:
    explicit Projection(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), range_(extentOf(*meshes.mesh, meshes.bounds).range), model_(brightestValue(range_)),
          volume_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        // Which cells count: all whose values are not transparent here.
        const auto least = range_.minimum + range_.extent() * view.value<double>("threshold") / 100;
        const auto counts = transferFunctionFromPoints({{least, {1, 1, 1}, 0}, {least, {1, 1, 1}, 1}}, 1);
        auto volume = volume_.update(counts, false, progress);
        if (!volume)
            return volume.error();
        volume->model = model_;
        scene->drawables.push_back({.id = "projection", .label = "Maximum", .shape = *std::move(volume)});
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
    ValueRange range_;
    std::shared_ptr<const OpticalModel> model_;
    VolumeCache volume_;
};
} // namespace

/// Shows the largest value along each line of sight.
class ProjectionRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent&) const override
    {
        Parameter threshold;
        threshold.id = "threshold";
        threshold.label = "Threshold";
        threshold.explanation = "Smaller values do not count.";
        threshold.unit = "% of the value range";
        threshold.defaultValue = 0.0;
        threshold.maximum = 100;
        return {threshold, clipParameter(), outlineParameter()};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<Projection>(meshes);
    }
};

TAN_PLUGIN(ProjectionRenderer, tetra::Renderer)
