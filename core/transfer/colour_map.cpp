// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/colour_map.h"

#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tetra {

namespace {

constexpr double pi = std::numbers::pi;

SrgbColour mixed(const SrgbColour& from, const SrgbColour& to, double s)
{
    SrgbColour result{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        result[channel] = (1 - s) * from[channel] + s * to[channel];
    return result;
}

SrgbColour hsvOf(const SrgbColour& colour)
{
    const auto& [red, green, blue] = colour;
    const double largest = std::max({red, green, blue}), extent = largest - std::min({red, green, blue});
    if (!(largest > 0) || !(extent > 0))
        return {0, 0, largest};
    double sixth = 4 + (red - green) / extent;
    if (red == largest)
        sixth = (green - blue) / extent;
    else if (green == largest)
        sixth = 2 + (blue - red) / extent;
    return {(sixth < 0 ? sixth + 6 : sixth) / 6, extent / largest, largest};
}

SrgbColour colourOfHsv(const SrgbColour& hsv)
{
    const auto channel = [&hsv](double shift) {
        const double place = std::fmod(hsv[0] * 6 + shift, 6);
        return hsv[2] * (1 - hsv[1] * std::clamp(std::min(place, 4 - place), 0.0, 1.0));
    };
    return {channel(5), channel(3), channel(1)};
}

SrgbColour betweenHsv(const SrgbColour& from, const SrgbColour& to, double s, bool wrapped)
{
    SrgbColour first = hsvOf(from), second = hsvOf(to);
    if (wrapped && std::abs(first[0] - second[0]) > 0.5)
        (first[0] > second[0] ? first[0] : second[0]) -= 1;
    SrgbColour hsv = mixed(first, second, s);
    hsv[0] += hsv[0] < 0 ? 1 : 0;
    return colourOfHsv(hsv);
}

constexpr SrgbColour whiteOfD65 = {0.9505, 1.0, 1.0890};

double linearLight(double channel)
{
    return channel > 0.04045 ? std::pow((channel + 0.055) / 1.055, 2.4) : channel / 12.92;
}

double standardChannel(double light)
{
    return light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light;
}

double labCurve(double share)
{
    return share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116;
}

double labCurveInverse(double value)
{
    const double cube = value * value * value;
    return cube > 0.008856 ? cube : (value - 16.0 / 116) / 7.787;
}

SrgbColour labOf(const SrgbColour& colour)
{
    const double red = linearLight(colour[0]), green = linearLight(colour[1]), blue = linearLight(colour[2]);
    const double x = labCurve((red * 0.4124 + green * 0.3576 + blue * 0.1805) / whiteOfD65[0]);
    const double y = labCurve((red * 0.2126 + green * 0.7152 + blue * 0.0722) / whiteOfD65[1]);
    const double z = labCurve((red * 0.0193 + green * 0.1192 + blue * 0.9505) / whiteOfD65[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Colours that no screen has are darkened until the largest channel fits, then negative ones cut, as VTK does.
SrgbColour colourOfLab(const SrgbColour& lab)
{
    const double middle = (lab[0] + 16) / 116;
    const double x = whiteOfD65[0] * labCurveInverse(middle + lab[1] / 500);
    const double y = whiteOfD65[1] * labCurveInverse(middle);
    const double z = whiteOfD65[2] * labCurveInverse(middle - lab[2] / 200);
    SrgbColour colour = {standardChannel(x * 3.2406 + y * -1.5372 + z * -0.4986),
                         standardChannel(x * -0.9689 + y * 1.8758 + z * 0.0415),
                         standardChannel(x * 0.0557 + y * -0.2040 + z * 1.0570)};
    const double largest = std::max(1.0, *std::ranges::max_element(colour));
    for (double& channel : colour)
        channel = std::max(0.0, channel / largest);
    return colour;
}

/// Moreland's polar form of CIELAB: magnitude, saturation and hue as angles.
struct Msh {
    double magnitude, saturation, hue;
};

Msh mshOf(const SrgbColour& colour)
{
    const SrgbColour lab = labOf(colour);
    const double magnitude = std::hypot(lab[0], lab[1], lab[2]);
    const double saturation = magnitude > 0.001 ? std::acos(lab[0] / magnitude) : 0;
    return {magnitude, saturation, saturation > 0.001 ? std::atan2(lab[2], lab[1]) : 0};
}

SrgbColour colourOfMsh(const Msh& msh)
{
    const double radius = msh.magnitude * std::sin(msh.saturation);
    return colourOfLab(
        {msh.magnitude * std::cos(msh.saturation), radius * std::cos(msh.hue), radius * std::sin(msh.hue)});
}

/// The hue for an end without saturation, turned so that the way to it looks even.
double hueToward(const Msh& saturated, double magnitude)
{
    if (saturated.magnitude >= magnitude - 0.1)
        return saturated.hue;
    const double turn = saturated.saturation *
                        std::sqrt(magnitude * magnitude - saturated.magnitude * saturated.magnitude) /
                        (saturated.magnitude * std::sin(saturated.saturation));
    return saturated.hue > -0.3 * pi ? saturated.hue + turn : saturated.hue - turn;
}

SrgbColour betweenDiverging(const SrgbColour& from, const SrgbColour& to, double s)
{
    constexpr double unsaturated = 0.05;
    Msh first = mshOf(from), second = mshOf(to);
    double angle = std::abs(first.hue - second.hue);
    angle = std::min(angle, 2 * pi - angle);
    if (first.saturation > unsaturated && second.saturation > unsaturated && angle > 0.33 * pi) {
        const Msh white{std::max({88.0, first.magnitude, second.magnitude}), 0, 0};
        (s < 0.5 ? second : first) = white;
        s = s < 0.5 ? 2 * s : 2 * s - 1;
    }
    if (first.saturation < unsaturated && second.saturation > unsaturated)
        first.hue = hueToward(second, first.magnitude);
    else if (second.saturation < unsaturated && first.saturation > unsaturated)
        second.hue = hueToward(first, second.magnitude);
    return colourOfMsh({std::lerp(first.magnitude, second.magnitude, s),
                        std::lerp(first.saturation, second.saturation, s), std::lerp(first.hue, second.hue, s)});
}

} // namespace

SrgbColour between(const SrgbColour& from, const SrgbColour& to, double s, ColourSpace space)
{
    switch (space) {
    case ColourSpace::Rgb: return mixed(from, to, s);
    case ColourSpace::Hsv: return betweenHsv(from, to, s, false);
    case ColourSpace::HsvWrapped: return betweenHsv(from, to, s, true);
    case ColourSpace::Lab: return colourOfLab(mixed(labOf(from), labOf(to), s));
    case ColourSpace::Diverging: return betweenDiverging(from, to, s);
    case ColourSpace::Step: return s > 0 ? to : from;
    }
    return from;
}

namespace {

/// Every sixteenth of the 256 colours that the authors published, by its number, and the last one; of turbo, which
/// turns more often, every eighth.
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

constexpr PublishedColour plasma[] = {
    {0, {0.050f, 0.030f, 0.528f}},   {16, {0.193f, 0.018f, 0.590f}},  {32, {0.300f, 0.010f, 0.632f}},
    {48, {0.399f, 0.001f, 0.656f}},  {64, {0.495f, 0.012f, 0.658f}},  {80, {0.584f, 0.069f, 0.633f}},
    {96, {0.665f, 0.139f, 0.586f}},  {112, {0.736f, 0.209f, 0.528f}}, {128, {0.798f, 0.280f, 0.470f}},
    {144, {0.853f, 0.352f, 0.414f}}, {160, {0.902f, 0.425f, 0.360f}}, {176, {0.943f, 0.503f, 0.306f}},
    {192, {0.973f, 0.586f, 0.252f}}, {208, {0.991f, 0.675f, 0.198f}}, {224, {0.993f, 0.772f, 0.155f}},
    {240, {0.974f, 0.875f, 0.144f}}, {255, {0.940f, 0.975f, 0.131f}}};

constexpr PublishedColour turbo[] = {
    {0, {0.190f, 0.072f, 0.232f}},   {8, {0.225f, 0.164f, 0.451f}},   {16, {0.251f, 0.252f, 0.634f}},
    {24, {0.268f, 0.338f, 0.780f}},  {32, {0.276f, 0.421f, 0.891f}},  {40, {0.275f, 0.501f, 0.966f}},
    {48, {0.259f, 0.580f, 0.999f}},  {56, {0.214f, 0.659f, 0.980f}},  {64, {0.158f, 0.736f, 0.923f}},
    {72, {0.112f, 0.806f, 0.845f}},  {80, {0.093f, 0.866f, 0.762f}},  {88, {0.120f, 0.912f, 0.687f}},
    {96, {0.197f, 0.949f, 0.595f}},  {104, {0.305f, 0.977f, 0.490f}}, {112, {0.428f, 0.994f, 0.386f}},
    {120, {0.547f, 0.999f, 0.296f}}, {128, {0.644f, 0.990f, 0.234f}}, {136, {0.726f, 0.965f, 0.206f}},
    {144, {0.805f, 0.925f, 0.205f}}, {152, {0.875f, 0.873f, 0.216f}}, {160, {0.933f, 0.812f, 0.227f}},
    {168, {0.973f, 0.747f, 0.225f}}, {176, {0.993f, 0.674f, 0.203f}}, {184, {0.996f, 0.587f, 0.169f}},
    {192, {0.984f, 0.493f, 0.128f}}, {200, {0.958f, 0.400f, 0.088f}}, {208, {0.921f, 0.315f, 0.055f}},
    {216, {0.874f, 0.245f, 0.033f}}, {224, {0.816f, 0.185f, 0.018f}}, {232, {0.746f, 0.131f, 0.009f}},
    {240, {0.664f, 0.084f, 0.004f}}, {248, {0.571f, 0.045f, 0.005f}}, {255, {0.480f, 0.016f, 0.011f}}};

ColourMap published(std::string id, std::string source, std::span<const PublishedColour> colours)
{
    ColourMap map{std::move(id), std::move(source), {}};
    for (const PublishedColour& colour : colours)
        map.nodes.push_back({static_cast<double>(colour.number) / lastNumber, colour.colour});
    return map;
}

/// From one hue over white to another through a space in which it looks even.
ColourMap diverging(std::string id, std::string source, const SrgbColour& from, const SrgbColour& to)
{
    constexpr int steps = 32;
    ColourMap map{std::move(id), std::move(source), {}};
    for (int step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        const SrgbColour colour = between(from, to, share, ColourSpace::Diverging);
        map.nodes.push_back(
            {share, {static_cast<float>(colour[0]), static_cast<float>(colour[1]), static_cast<float>(colour[2])}});
    }
    return map;
}

/// Equal parts, each of one colour.
ColourMap inParts(std::string id, std::string source, std::span<const std::array<float, 3>> colours)
{
    ColourMap map{std::move(id), std::move(source), {}};
    const auto count = static_cast<double>(colours.size());
    for (std::size_t part = 0; part < colours.size(); ++part) {
        map.nodes.push_back({static_cast<double>(part) / count, colours[part]});
        map.nodes.push_back({static_cast<double>(part + 1) / count, colours[part]});
    }
    return map;
}

constexpr SrgbColour coolBlue = {0.230, 0.299, 0.754}, warmRed = {0.706, 0.016, 0.150};
constexpr SrgbColour okabeBlue = {0.000, 0.447, 0.698}, okabeVermilion = {0.835, 0.369, 0.000};

/// In their order, but for black, in which nothing is seen before a dark ground.
constexpr std::array<float, 3> okabeIto[] = {
    {0.902f, 0.624f, 0.000f}, {0.337f, 0.706f, 0.914f}, {0.000f, 0.620f, 0.451f}, {0.941f, 0.894f, 0.259f},
    {0.000f, 0.447f, 0.698f}, {0.835f, 0.369f, 0.000f}, {0.800f, 0.475f, 0.655f}};

} // namespace

std::span<const ColourMap> colourMaps()
{
    static const std::vector<ColourMap> maps = {
        published("viridis", "N. Smith, S. van der Walt, CC0", viridis),
        published("cividis", "J. Nunez, C. Anderton, R. Renslow, 2018, CC0", cividis),
        published("inferno", "N. Smith, S. van der Walt, CC0", inferno),
        diverging("cool-warm", "K. Moreland, 2009, formula", coolBlue, warmRed),
        {"grey", "", {{0, {0, 0, 0}}, {1, {1, 1, 1}}}},
        published("plasma", "N. Smith, S. van der Walt, CC0", plasma),
        published("turbo", "A. Mikhailov, 2019, Apache-2.0", turbo),
        diverging("blue-orange", "K. Moreland, 2009, formula; colours of M. Okabe, K. Ito, 2008", okabeBlue,
                  okabeVermilion),
        inParts("categories", "M. Okabe, K. Ito, 2008", okabeIto),
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
    coloured.colours.clear();
    for (const ColourMapNode& node : map.nodes)
        coloured.colours.push_back({std::lerp(limits.least, limits.largest, node.share), node.colour});
    return coloured;
}

} // namespace tetra
