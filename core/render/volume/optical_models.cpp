// SPDX-License-Identifier: GPL-3.0-or-later

#include <tan/render.h>

#include <algorithm>
#include <limits>
#include <string>

namespace tetra {
namespace {

/// The nearest float that is finite: a shader has no word for the infinity that the reciprocal of a tiny range is, and
/// nothing times infinity would be no number.
float finiteFloat(double number)
{
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(number, -most, most));
}

/// The numbers of a model, which its function and its shader share.
struct ModelNumbers {
    float least, perValue; ///< (value - least) * perValue is in [0, 1] within the range
    Colour colour;

    ModelNumbers(double from, double to, const Colour& ofLight)
        : least(finiteFloat(from)), perValue(to > from ? finiteFloat(1 / (to - from)) : 0), colour(ofLight)
    {
    }

    void set(const OpticalPieces& pieces, std::size_t i, float opacity) const
    {
        pieces.red[i] = colour.red * opacity;
        pieces.green[i] = colour.green * opacity;
        pieces.blue[i] = colour.blue * opacity;
        pieces.transmittance[i] = 1 - opacity;
    }

    /// A shader that gives this opacity, an expression of the function's arguments, `least` and `perValue`. All names
    /// are local to the function: global ones could clash with those of the back end.
    std::string shader(const std::string& opacity) const
    {
        return "vec4 lightOfPiece(float entry, float exit, float way, float gradient)\n{\n    float least = " +
               inGlsl(least) + ", perValue = " + inGlsl(perValue) + ";\n    float opacity = " + opacity +
               ";\n    return vec4(vec3(" + inGlsl(colour.red) + ", " + inGlsl(colour.green) + ", " +
               inGlsl(colour.blue) + ") * opacity, opacity);\n}\n";
    }

    /// With float(), as a 1 alone is an integer in GLSL.
    static std::string inGlsl(float number) { return "float(" + formatNumber(number) + ")"; }
};

} // namespace

std::shared_ptr<const OpticalModel> maximumIntensity(double least, double largest, const Colour& colour)
{
    const ModelNumbers numbers(least, largest, colour);
    OpticalModel model;
    model.combiner = Combiner::Maximum;
    model.evaluate = [numbers](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            const float most = std::max(pieces.entry[i], pieces.exit[i]);
            numbers.set(pieces, i, std::clamp((most - numbers.least) * numbers.perValue, 0.0f, 1.0f));
        }
    };
    model.shader = numbers.shader("clamp((max(entry, exit) - least) * perValue, 0.0, 1.0)");
    return std::make_shared<const OpticalModel>(std::move(model));
}

std::shared_ptr<const OpticalModel> xRay(double least, double largest, double opaqueLength, const Colour& colour)
{
    const ModelNumbers numbers(least, largest, colour);
    const auto perLength = finiteFloat(opaqueLength > 0 ? 1 / opaqueLength : 0);
    OpticalModel model;
    model.combiner = Combiner::Sum;
    model.evaluate = [numbers, perLength](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            const float mean = (pieces.entry[i] + pieces.exit[i]) / 2;
            const float share = std::clamp((mean - numbers.least) * numbers.perValue, 0.0f, 1.0f);
            numbers.set(pieces, i, std::min(share * pieces.length[i] * perLength, 1.0f));
        }
    };
    model.shader = numbers.shader("min(clamp(((entry + exit) * 0.5 - least) * perValue, 0.0, 1.0) * way * " +
                                  ModelNumbers::inGlsl(perLength) + ", 1.0)");
    return std::make_shared<const OpticalModel>(std::move(model));
}

} // namespace tetra
