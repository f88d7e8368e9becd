// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/colour_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

} // namespace tetra
