// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"

namespace tetra {
namespace {

class BandSession : public RendererSession {
public:
    explicit BandSession(const Eigen::AlignedBox3d& bounds) : bounds_(bounds) {}
    Result<std::shared_ptr<const Scene>> prepare(const RendererView&, const Progress&) override
    {
        Scene scene;
        scene.bounds = bounds_;
        return std::make_shared<const Scene>(std::move(scene));
    }

private:
    Eigen::AlignedBox3d bounds_;
};

} // namespace

/// A mode with parameters of every type that the built-in modes have not: a band, which examples/editor edits, a colour
/// and a vector. It shows nothing.
class BandRenderer : public Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        Parameter band;
        band.id = "band";
        band.label = "Band";
        band.explanation = "Which values are seen.";
        band.defaultValue = OwnValue{"example.band", "{\"low\": " + formatNumber(field.range.minimum) +
                                                         ", \"high\": " + formatNumber(field.range.maximum) + "}"};
        Parameter colour;
        colour.id = "paint";
        colour.label = "Paint";
        colour.explanation = "In which colour.";
        colour.defaultValue = Colour{1, 0, 0};
        Parameter light;
        light.id = "light";
        light.label = "Light";
        light.explanation = "Where from.";
        light.defaultValue = Eigen::Vector3d(1, 2, 3);
        return {band, colour, light};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<BandSession>(meshes.bounds);
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::BandRenderer, tetra::Renderer)
