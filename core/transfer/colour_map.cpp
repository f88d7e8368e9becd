// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/colour_map.h"

#include "core/transfer/colour_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tetra {
namespace {

/// Every sixteenth of the 256 colours that the authors published, by its number, and the last one.
struct PublishedColour {
    int number;
    std::array<float, 3> colour;
};
constexpr int lastNumber = 255;

constexpr PublishedColour viridis[] = {
    {0, {0.267f, 0.005f, 0.329f}},   {16, {0.282f, 0.095f, 0.417f}},  {32, {0.279f, 0.175f, 0.483f}},
    {48, {0.259f, 0.252f, 0.525f}},  {64, {0.230f, 0.322f, 0.546f}},  {80, {0.199f, 0.388f, 0.555f}},
    {96, {0.173f, 0.449f, 0.558f}},  {112, {0.149f, 0.508f, 0.557f}}, {128, {0.128f, 0.567f, 0.551f}},
    {144, {0.121f, 0.626f, 0.533f}}, {160, {0.158f, 0.684f, 0.502f}}, {176, {0.246f, 0.739f, 0.452f}},
    {192, {0.369f, 0.789f, 0.383f}}, {208, {0.516f, 0.831f, 0.294f}}, {224, {0.678f, 0.864f, 0.190f}},
    {240, {0.846f, 0.887f, 0.100f}}, {255, {0.993f, 0.906f, 0.144f}}};

constexpr PublishedColour cividis[] = {
    {0, {0.000f, 0.135f, 0.305f}},   {16, {0.000f, 0.179f, 0.415f}},  {32, {0.103f, 0.220f, 0.436f}},
    {48, {0.195f, 0.264f, 0.426f}},  {64, {0.264f, 0.308f, 0.423f}},  {80, {0.324f, 0.351f, 0.426f}},
    {96, {0.381f, 0.395f, 0.436f}},  {112, {0.435f, 0.440f, 0.451f}}, {128, {0.489f, 0.485f, 0.471f}},
    {144, {0.548f, 0.532f, 0.472f}}, {160, {0.609f, 0.580f, 0.464f}}, {176, {0.672f, 0.629f, 0.448f}},
    {192, {0.736f, 0.681f, 0.424f}}, {208, {0.803f, 0.734f, 0.390f}}, {224, {0.871f, 0.790f, 0.343f}},
    {240, {0.941f, 0.848f, 0.276f}}, {255, {0.996f, 0.909f, 0.218f}}};

constexpr PublishedColour inferno[] = {
    {0, {0.001f, 0.000f, 0.014f}},   {16, {0.042f, 0.028f, 0.141f}},  {32, {0.129f, 0.047f, 0.291f}},
    {48, {0.238f, 0.037f, 0.396f}},  {64, {0.342f, 0.062f, 0.429f}},  {80, {0.441f, 0.099f, 0.432f}},
    {96, {0.541f, 0.135f, 0.415f}},  {112, {0.640f, 0.171f, 0.381f}}, {128, {0.736f, 0.216f, 0.330f}},
    {144, {0.822f, 0.275f, 0.266f}}, {160, {0.894f, 0.353f, 0.194f}}, {176, {0.947f, 0.449f, 0.115f}},
    {192, {0.978f, 0.558f, 0.035f}}, {208, {0.988f, 0.675f, 0.065f}}, {224, {0.975f, 0.798f, 0.206f}},
    {240, {0.948f, 0.917f, 0.411f}}, {255, {0.988f, 0.998f, 0.645f}}};

ColourMap published(std::string id, std::string source, std::span<const PublishedColour> colours)
{
    ColourMap map{std::move(id), std::move(source), {}};
    for (const PublishedColour& colour : colours)
        map.nodes.push_back({static_cast<double>(colour.number) / lastNumber, colour.colour});
    return map;
}

/// From blue over white to red through a space in which it looks even.
ColourMap coolWarm()
{
    constexpr SrgbColour blue = {0.230, 0.299, 0.754}, red = {0.706, 0.016, 0.150};
    constexpr int steps = 32;
    ColourMap map{"cool-warm", "K. Moreland, 2009, formula", {}};
    for (int step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        const SrgbColour colour = between(blue, red, share, ColourSpace::Diverging);
        map.nodes.push_back(
            {share, {static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2])}});
    }
    return map;
}

} // namespace

std::span<const ColourMap> colourMaps()
{
    static const std::vector<ColourMap> maps = {
        published("viridis", "N. Smith, S. van der Walt, CC0", viridis),
        published("cividis", "J. Nunez, C. Anderton, R. Renslow, 2018, CC0", cividis),
        published("inferno", "N. Smith, S. van der Walt, CC0", inferno),
        coolWarm(),
        {"grey", "", {{0, {0, 0, 0}}, {1, {1, 1, 1}}}},
    };
    return maps;
}

std::array<float, 3> colourAt(const ColourMap& map, double share)
{
    const auto beyond = std::ranges::upper_bound(map.nodes, share, {}, &ColourMapNode::share);
    if (beyond == map.nodes.begin() || beyond == map.nodes.end())
        return (beyond == map.nodes.begin() ? map.nodes.front() : map.nodes.back()).colour;
    const ColourMapNode &from = beyond[-1], &to = *beyond;
    const auto s = static_cast<float>((share - from.share) / (to.share - from.share));
    std::array<float, 3> colour{};
    for (std::size_t channel = 0; channel < colour.size(); ++channel)
        colour[channel] = std::lerp(from.colour[channel], to.colour[channel], s);
    return colour;
}

TransferFunction withColourMap(const TransferFunction& function, const ColourMap& map, const TransferLimits& limits)
{
    if (!(limits.least < limits.largest) || !std::isfinite(limits.largest - limits.least))
        return function;
    TransferFunction coloured = function;
    for (TransferPoint& point : coloured.points)
        point.colour = colourAt(map, (point.value - limits.least) / (limits.largest - limits.least));
    for (const ColourMapNode& node : map.nodes) {
        const double value = std::lerp(limits.least, limits.largest, node.share);
        if (std::ranges::find(function.points, value, &TransferPoint::value) != function.points.end())
            continue;
        const double depth = evaluateUnmasked(function, value).extinction * function.unitDistance;
        coloured.points.push_back({value, node.colour, static_cast<float>(-std::expm1(-depth))});
    }
    std::ranges::stable_sort(coloured.points, {}, &TransferPoint::value);
    return coloured;
}

} // namespace tetra
