// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/isosurface/isosurface_renderer.h"

#include "core/graphics/palette.h"
#include "plugins/renderers/isosurface/isosurface_session.h"

namespace tetra {

std::vector<Parameter> isosurfaceParameters(const ValueRange& range)
{
    const auto [red, green, blue] = distinctColour(0);
    const Isovalue middle{range.minimum + range.extent() / 2, red, green, blue, 1, true};

    Parameter isovalues;
    isovalues.id = isovaluesId;
    isovalues.label = "Isovalues";
    isovalues.explanation = "The values whose surfaces are shown, each with its colour and opacity.";
    isovalues.defaultValue = std::vector{middle};
    isovalues.minimum = range.minimum;
    isovalues.maximum = range.maximum;

    Parameter outline;
    outline.id = outlineId;
    outline.label = "Outline";
    outline.explanation = "Shows the edges of the box that the data fill.";
    outline.defaultValue = true;
    return {isovalues, outline};
}

std::unique_ptr<RendererSession> IsosurfaceRenderer::open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                          const Eigen::AlignedBox3d& bounds) const
{
    return std::make_unique<IsosurfaceSession>(std::move(mesh), bounds);
}

} // namespace tetra
