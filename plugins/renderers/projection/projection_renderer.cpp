// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/renderer.h"
#include "plugins/api/scene_parameters.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace tetra;

constexpr const char* projectionId = "projection";
constexpr const char* maximum = Message::marked("maximum").text;
constexpr const char* minimum = Message::marked("minimum").text;

Parameter projectionParameter()
{
    Parameter parameter;
    parameter.id = projectionId;
    parameter.label = Message::marked("Projection");
    parameter.explanation = Message::marked(
        "Which value along each line of sight is shown: the largest ('maximum') or the smallest ('minimum').");
    parameter.defaultValue = std::string(maximum);
    parameter.choices = {maximum, minimum};
    return parameter;
}

/// How values become opacities, the larger of which counts, and these values again: at the far end of the range a
/// half, so that it is told from no value at all, at the other end 1. Values are scaled by a power of two, which
/// changes no digit: so the extent of the largest floats is a float, too, and that of very small ones not zero.
struct Opacities {
    float scale = 1;
    float least = 0; ///< scaled, like the extent
    float extent = 1;
    bool largestCounts = true;

    Opacities(const ValueRange& range, bool counts) : largestCounts(counts)
    {
        constexpr int mostSteps = 126; // of which two to their power, up or down, is a normal float
        const double size = std::max(std::abs(range.minimum), std::abs(range.maximum));
        const int steps = size > 0 ? std::clamp(-std::ilogb(size), -mostSteps, mostSteps) : 0;
        scale = std::ldexp(1.0f, steps);
        least = static_cast<float>(std::ldexp(range.minimum, steps));
        if (range.extent() > 0)
            extent = static_cast<float>(std::ldexp(range.extent(), steps));
    }

    float of(float entry, float exit) const
    {
        const float value = largestCounts ? std::max(entry, exit) : std::min(entry, exit);
        const float share = std::clamp((value * scale - least) / extent, 0.0f, 1.0f);
        return 0.5f + 0.5f * (largestCounts ? share : 1 - share);
    }
    /// The share of the range.
    float shareOf(float opacity) const { return largestCounts ? 2 * opacity - 1 : 2 - 2 * opacity; }
};

/// With float(), as a 1 alone is an integer in GLSL.
std::string inGlsl(float number)
{
    return "float(" + formatNumber(number) + ")";
}

std::string pieceShader(const Opacities& opacities)
{
    return "vec4 lightOfPiece(float entry, float exit, float way, float gradient)\n{\n    float value = " +
           std::string(opacities.largestCounts ? "max" : "min") + "(entry, exit);\n    float share = clamp((value * " +
           inGlsl(opacities.scale) + " - " + inGlsl(opacities.least) + ") / " + inGlsl(opacities.extent) +
           ", 0.0, 1.0);\n    return vec4(vec3(0.0), 0.5 + 0.5 * " +
           (opacities.largestCounts ? "share" : "(1.0 - share)") + ");\n}\n";
}

/// The colours of a transfer function over the range of values: a point's place is its share of that.
struct RangeColours {
    std::vector<float> places;
    std::vector<std::array<float, 3>> colours;

    RangeColours(const TransferFunction& function, const Opacities& opacities)
    {
        for (const ColourPoint& point : function.colours) {
            const double place =
                (point.value * static_cast<double>(opacities.scale) - static_cast<double>(opacities.least)) /
                opacities.extent;
            places.push_back(static_cast<float>(std::clamp(place, -1e6, 1e6)));
            colours.push_back(point.colour);
        }
        if (!places.empty())
            return;
        places.push_back(0); // a function without colours is white
        colours.push_back({1, 1, 1});
    }

    /// At a step the upper colour, as everywhere.
    std::array<float, 4> at(float share) const
    {
        const auto above = static_cast<std::size_t>(std::ranges::upper_bound(places, share) - places.begin());
        const auto& upper = colours[std::min(above, places.size() - 1)];
        const auto& lower = colours[above > 0 ? above - 1 : 0];
        float part = 0;
        if (above > 0 && above < places.size())
            part = (share - places[above - 1]) / (places[above] - places[above - 1]);
        const auto mixed = [&](std::size_t channel) {
            return lower[channel] + part * (upper[channel] - lower[channel]);
        };
        return {mixed(0), mixed(1), mixed(2), 1};
    }
    /// What the shader reads of them.
    std::vector<std::array<float, 4>> table() const
    {
        std::vector<std::array<float, 4>> rows;
        for (std::size_t i = 0; i < places.size(); ++i)
            rows.push_back({colours[i][0], colours[i][1], colours[i][2], places[i]});
        return rows;
    }
};

/// RangeColours::at() in GLSL, of the table. The text is the same for all functions.
std::string rayShader(bool largestCounts)
{
    return std::string("vec4 lightOfRay(float opacity)\n{\n    float share = ") +
           (largestCounts ? "2.0 * opacity - 1.0" : "2.0 - 2.0 * opacity") +
           R"(;
    int above = 0;
    for (int last = rayDataCount(); above < last;) {
        int middle = (above + last) / 2;
        if (rayDatum(middle).w <= share)
            above = middle + 1;
        else
            last = middle;
    }
    vec4 lower = rayDatum(max(above - 1, 0));
    if (above == 0 || above == rayDataCount())
        return vec4(lower.rgb, 1.0);
    vec4 upper = rayDatum(above);
    return vec4(mix(lower.rgb, upper.rgb, (share - lower.w) / (upper.w - lower.w)), 1.0);
}
)";
}

/// The value that counts, of all pieces of a ray, in its colour.
std::shared_ptr<const OpticalModel> projectionModel(const ValueRange& range, bool largestCounts,
                                                    const TransferFunction& function)
{
    const Opacities opacities(range, largestCounts);
    const auto colours = std::make_shared<const RangeColours>(function, opacities);
    OpticalModel model;
    model.combiner = Combiner::Maximum;
    model.evaluate = [opacities](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            pieces.red[i] = pieces.green[i] = pieces.blue[i] = 0;
            pieces.transmittance[i] = 1 - opacities.of(pieces.entry[i], pieces.exit[i]);
        }
    };
    model.shader = pieceShader(opacities);
    model.lightOfRay = [opacities, colours](float opacity) { return colours->at(opacities.shareOf(opacity)); };
    model.rayShader = rayShader(largestCounts);
    model.rayData = colours->table();
    return std::make_shared<const OpticalModel>(std::move(model));
}

/// Keeps the mesh in the order that volumes want.
class ProjectionSession : public RendererSession {
public:
    explicit ProjectionSession(const RendererMeshes& meshes)
        : bounds_(meshes.bounds), range_(extentOf(*meshes.mesh, meshes.bounds).range), volume_(meshes.mesh)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, bounds_);
        if (!scene)
            return scene.error();
        const auto function = view.value<TransferFunction>(transferId);
        if (const Status usable = checkTransferFunction(function); !usable)
            return usable.error();
        if (!std::isfinite(range_.extent()))
            return Error{ErrorKind::BadInput,
                         Message::say("Some values of the model are not finite numbers, so no largest or smallest one "
                                      "can be shown. Choose another mode.")};
        // All cells count, whatever opacities the function gives them.
        auto volume = volume_.update(transferFunctionFromPoints({{range_.minimum, {1, 1, 1}, 1}}), false, progress);
        if (!volume)
            return volume.error();
        volume->model = modelOf(function, view.value<std::string>(projectionId) != minimum);
        scene->drawables.push_back({.id = "projection", .label = "Projection", .shape = *std::move(volume)});
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    /// The same again as long as it is.
    std::shared_ptr<const OpticalModel> modelOf(const TransferFunction& function, bool largestCounts)
    {
        if (!model_ || function_ != function || largestCounts_ != largestCounts)
            model_ = projectionModel(range_, largestCounts, function);
        function_ = function;
        largestCounts_ = largestCounts;
        return model_;
    }

    Eigen::AlignedBox3d bounds_;
    ValueRange range_; ///< of the mesh
    VolumeCache volume_;
    TransferFunction function_; ///< of the model, like the next
    bool largestCounts_ = true;
    std::shared_ptr<const OpticalModel> model_;
};

} // namespace

/// The largest value along each line of sight, or the smallest, in its colour.
class ProjectionRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return {projectionParameter(), transferParameter(field), clipParameter(), outlineParameter(field)};
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<ProjectionSession>(meshes);
    }
};

TAN_PLUGIN(ProjectionRenderer, tetra::Renderer)
