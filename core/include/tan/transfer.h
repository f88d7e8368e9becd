// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/transfer.h: the transfer function, which says what a value of the field looks like; its text form, and those
/// of other programs.
///
/// ~~~{.cpp}
/// /// Blue and faint where values are small, yellow and dense where they are large, as JSON.
/// tetra::Result<std::string> blueToYellow(double least, double largest, double thickness)
/// {
///     tetra::TransferFunction function;
///     function.colours = {{least, {0.1f, 0.2f, 0.8f}}, {largest, {1, 0.9f, 0.3f}}};
///     function.opacities = {{least, 0.02f}, {largest, 0.6f}};
///     function.unitDistance = thickness; // a layer so thick has these opacities
///     if (const tetra::Status usable = tetra::checkTransferFunction(function); !usable)
///         return usable.error();
///     return tetra::transferFunctionToText(function);
/// }
/// ~~~

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A control point of the colours.
struct ColourPoint {
    double value = 0;                     ///< of the field
    std::array<float, 3> colour{1, 1, 1}; ///< sRGB, each channel in [0, 1]
    std::optional<int> group{};           ///< 0 to 9: a label for the editor, which changes nothing of the look
    bool operator==(const ColourPoint&) const = default;
};

/// A control point of the opacities.
struct OpacityPoint {
    double value = 0;           ///< of the field
    float opacity = 0;          ///< in [0, 1], of the unit distance
    std::optional<int> group{}; ///< as of a colour
    bool operator==(const OpacityPoint&) const = default;
};

/// The closed range of values that is shown.
struct TransferMask {
    double least = 0;
    double largest = 0;
    bool operator==(const TransferMask&) const = default;
};

inline constexpr int largestTransferGroup = 9;

/// What a value of the field looks like (R18): two curves over one axis of values, colour and extinction, each linear
/// between its own control points and constant beyond its first and its last. A value with value semantics.
///
/// The points of a curve are in ascending order of value. Two points of one value are a step (R22): the first ends what
/// lies below, the second begins what lies above, and the value itself belongs to the upper side, as it does for
/// isosurfaces (S16).
///
/// Opacity is what a layer of `unitDistance` would have if the value did not change in it; the extinction there is
/// -ln(1 - opacity) / unitDistance. It is the extinction that is linear between the points, so that the optical depth
/// of a slab is exact in closed form (S15). An opacity of 1 counts as `largestOpacity`.
struct TransferFunction {
    std::vector<ColourPoint> colours{};    ///< none: everything is white
    std::vector<OpacityPoint> opacities{}; ///< none: everything is transparent
    double unitDistance = 1;               ///< in the units of the dataset
    std::optional<TransferMask> mask{};    ///< what lies outside of it is transparent, whatever the opacities say
    bool operator==(const TransferFunction&) const = default;
};

/// A point of both curves: many functions have a colour and an opacity at the same values.
struct TransferPoint {
    double value = 0;
    std::array<float, 3> colour{1, 1, 1};
    float opacity = 0;
    std::optional<int> group{};
    bool operator==(const TransferPoint&) const = default;
};

/// The function whose curves both have these points.
TAN_API TransferFunction transferFunctionFromPoints(std::span<const TransferPoint> points, double unitDistance = 1);
inline TransferFunction transferFunctionFromPoints(std::initializer_list<TransferPoint> points, double unitDistance = 1)
{
    return transferFunctionFromPoints(std::span(points.begin(), points.size()), unitDistance);
}

/// A point at every value at which either curve has one; the other curve's part of it is what that curve is there. Of a
/// function from points these are the points, to the bit. O(points).
TAN_API std::vector<TransferPoint> transferPoints(const TransferFunction& function);

/// The largest opacity that is used: one unit distance transmits 2^-24.
inline constexpr double largestOpacity = 1 - 1.0 / (1 << 24);

/// What a place in the field looks like.
struct TransferSample {
    std::array<double, 3> colour{0, 0, 0};
    double extinction = 0; ///< per unit of length of the dataset
};

/// An error if the mask is no range.
TAN_API Status checkMask(const TransferMask& mask);

/// An error if the points of a curve are not in order, more than two have one value, a number is not finite or out of
/// its range, or the mask is no range.
TAN_API Status checkTransferFunction(const TransferFunction& function);

/// Per unit of length, for an opacity that is reached in `unitDistance`: -log(1 - opacity) / unitDistance.
TAN_API double extinctionOf(double opacity, double unitDistance) noexcept;

/// O(log points). NaN is transparent.
TAN_API TransferSample evaluate(const TransferFunction& function, double value);

/// The same without the mask: what an editor shows as the curve.
TAN_API TransferSample evaluateUnmasked(const TransferFunction& function, double value);

/// A range of values, [begin, end), in which colour and extinction are affine:
/// atOrigin + (value - origin) * perValue.
struct TransferSegment {
    double begin = 0; ///< minus infinity for the first
    double end = 0;   ///< infinity for the last
    double origin = 0;
    TransferSample atOrigin;
    TransferSample perValue;

    /// Nothing of these values is seen.
    bool transparent() const noexcept { return atOrigin.extinction == 0 && perValue.extinction == 0; }
};

/// The opacities that are seen, as knots (value, share of the largest one), linear between, two of one value at a step:
/// what ErrorField::byOpacity() takes. None if all is transparent. O(points).
TAN_API std::vector<std::array<double, 2>> opacityKnots(const TransferFunction& function);

/// The segments between the points of both curves of a function that checkTransferFunction() accepts, from minus to
/// plus infinity, plus one on either side of its mask; one transparent segment if it has no opacities. O(points).
TAN_API std::vector<TransferSegment> transferSegments(const TransferFunction& function);

/// A transfer function as a JSON text (R18), and back to the same bits:
///
///     {
///       "format": "tan-transfer-function",
///       "version": 2,
///       "unitDistance": 2.5,
///       "mask": {"least": 1, "largest": 6},
///       "colours": [
///         {"value": 0, "colour": [0, 0.2, 1]},
///         {"value": 7, "colour": [1, 1, 0.5]}
///       ],
///       "opacities": [
///         {"value": 0, "opacity": 0.02},
///         {"value": 5, "opacity": 0.8, "group": 3}
///       ]
///     }
///
/// "format", "version", "colours" and "opacities" must be there; "unitDistance" is 1 if it is not, and there is no mask
/// and no group where none is written. A member of another name is an error, so that a misspelt name is reported.
/// Version 1 is read, too: it has "points" instead of the two lists, each with a value, a colour, an opacity and, if it
/// has one, a group.
TAN_API std::string transferFunctionToText(const TransferFunction& function);

/// The error says what is wrong and in which line and column.
TAN_API Result<TransferFunction> transferFunctionFromText(std::string_view text);

/// How many values lie in each of some equal parts of a range.
struct TAN_API ValueHistogram {
    double least = 0;
    double largest = 0;
    std::vector<std::uint64_t> counts; ///< from the least values to the largest

    std::uint64_t highest() const noexcept;
};

/// The largest value counts as of the last part; values outside of [least, largest] and NaN are not counted. No counts
/// if the range is not finite or `parts` is not above zero; all in the first part if the range has no extent.
/// O(values).
TAN_API ValueHistogram valueHistogram(std::span<const float> values, double least, double largest, int parts);

/// The same over the natural logarithms of values: `least` and `largest` are values, those of the histogram logarithms.
/// No counts if `least` is not above zero. O(values).
TAN_API ValueHistogram logarithmicHistogram(std::span<const float> values, double least, double largest, int parts);

/// The height of a bar, in [0, 1] of the highest: linear, or logarithmic so that rare values are seen, too.
TAN_API double barHeight(std::uint64_t count, std::uint64_t highest, bool logarithmic) noexcept;

// Transfer functions to begin with, for values in [smallest, largest]; the colours can be told apart also by people
// who do not see red or green as others do. `unitDistance` is usually a fortieth of the domain's diagonal. If the
// range is empty or not finite, all values look the same.

/// Dark blue over green to yellow, darkest where the value is small, opacity rising with the value: after the colour
/// map viridis by N. Smith and S. van der Walt (CC0).
TAN_API TransferFunction sequentialTransferFunction(double smallest, double largest, double unitDistance);

/// Blue over a pale middle to orange, opaque at both ends: for values that deviate to two sides. After the colours blue
/// and vermilion of Okabe and Ito (2008).
TAN_API TransferFunction divergingTransferFunction(double smallest, double largest, double unitDistance);

/// The values of what fills most of a domain and is no part of what was measured: the air around a scanned part, the
/// undisturbed flow around a body. They scatter about the commonest one, by noise.
struct BackgroundValues {
    double least = 0;
    double commonest = 0;
    double largest = 0;
};

/// The background, given how the values share the domain's volume (volumeHistogram(): vertices of an adaptive mesh are
/// dense where there is something to see, and say nothing of that). Its values are the commonest ones and those beside
/// them, as long as each has a tenth of the commonest's share, together an eighth of the range at most. None if the
/// commonest values are not much more frequent than the others. O(parts).
TAN_API std::optional<BackgroundValues> backgroundValues(const ValueHistogram& volumes);

/// A transfer function to begin with, given how the values share the domain's volume. What fills most of it, as the air
/// around a scanned part or the undisturbed flow around a body, is transparent, rare values are the more opaque, and
/// the volume stays translucent as a whole; at equal shares, large values are more opaque than small ones. Colours go
/// from blue over cream to orange, closer where more is seen. `unitDistance` is as a rule a fortieth of the
/// domain's diagonal, and less where that is flat. Without a histogram it is sequentialTransferFunction(). O(parts).
///
/// `error` is how far the values of the mesh that is drawn may be off, in their own units: no value that is within it
/// of the background is opaque at all, so that nothing is painted into the background that the error alone has made.
/// From there the opacity rises over the width of another such error. An eighth of the range stays visible whatever the
/// error.
TAN_API TransferFunction fittedTransferFunction(const ValueHistogram& volumes, double unitDistance, double error = 0);

/// A closed range of values.
struct TransferLimits {
    double least = 0;
    double largest = 1;
};

/// Something that is made visible though the error of the mesh alone may have made it.
struct ErrorRemark {
    enum class Kind {
        IsovalueAtEnd,        ///< an isovalue within the error of the least or the largest value of the data
        IsovalueAtBackground, ///< ... or of the background
        OpacityAtBackground,  ///< opacities rise within the error of a background that is transparent itself
        NarrowOpacity,        ///< the values that are visible are fewer than the error is wide
    };
    Kind kind = Kind::IsovalueAtEnd;
    double value = 0;  ///< the isovalue; where the opacities begin; the middle of the narrow ones
    double other = 0;  ///< the value that the error may take for it; of narrow opacities the same value
    double error = 0;  ///< in units of the values, there
    double enough = 0; ///< an error with which this is not so any more; 0 if none is small enough
    bool operator==(const ErrorRemark&) const = default;
};

/// What the remarks are of.
struct ErrorRemarkInput {
    TransferLimits range{};                       ///< of the data's values
    std::optional<BackgroundValues> background{}; ///< if it is known
    std::span<const double> isovalues{};          ///< whose surfaces are shown
    const TransferFunction* transfer = nullptr;   ///< of the volume that is shown; null: none is
    /// The largest error that the mesh may have where the data have this value, in units of the values.
    std::function<double(double value)> errorAt{};
};

/// Where what is shown lies within the error that is shown: in a picture it cannot be told from the data. Isovalues
/// first, in their order. O(isovalues + points).
TAN_API std::vector<ErrorRemark> errorRemarks(const ErrorRemarkInput& input);

/// What a remark says, in a sentence; `ofLogarithms`: of a field of logarithms to base 10, with values as they are
/// typed, log10(3e-5), and the error as a factor.
TAN_API Message errorRemarkText(const ErrorRemark& remark, bool ofLogarithms = false);

/// The error that is small enough, in % of the range's extent, as a round number that is not larger; 0 if none is.
TAN_API double enoughPercent(const ErrorRemark& remark, const TransferLimits& range);

/// What helps, in a sentence.
TAN_API Message errorCureText(const ErrorRemark& remark, const TransferLimits& range, bool ofLogarithms = false);

/// A colour at a share of the range.
struct ColourMapNode {
    double share = 0; ///< in [0, 1]
    std::array<float, 3> colour{};
};

/// Colours for a range of values without opacities, linear between nodes; two nodes of one share are a step. All but
/// "turbo" can be told apart by people who do not see red or green as others do; "viridis", "cividis", "inferno",
/// "plasma" and "grey" by their lightness alone.
struct ColourMap {
    std::string id;                   ///< stable: "viridis"
    std::string source;               ///< whose it is, and the licence
    std::vector<ColourMapNode> nodes; ///< ascending, from 0 to 1
};

/// viridis, cividis, inferno, cool-warm, grey, plasma, turbo, blue-orange, categories: in this order.
TAN_API std::span<const ColourMap> colourMaps();

/// The map's colour, linear between its nodes, at a share of the range that is brought into [0, 1].
TAN_API std::array<float, 3> colourAt(const ColourMap& map, double share);

/// The function with the map's colours from limits.least to limits.largest in place of its own. Limits that are not a
/// range change nothing.
TAN_API TransferFunction withColourMap(const TransferFunction& function, const ColourMap& map,
                                       const TransferLimits& limits);

/// What completes a file of colours or opacities alone, and where presets without values of their own go.
struct ImportContext {
    TransferFunction present{};
    std::optional<TransferLimits> limits{}; ///< presets from 0 to 1 are spread over these; none: they stay
};

/// A transfer function of a file and what it is called there.
struct ImportedTransfer {
    std::string name; ///< may be empty
    TransferFunction function;
    bool coloursOnly = false; ///< the opacities are those of `present`
    bool spread = false;      ///< the file has values from 0 to 1, spread over ImportContext::limits
};

/// The transfer functions of a file, one or more: one of ours (transferFunctionToText()), or ParaView's presets, JSON
/// or XML. Errors (BadInput): none of these, or one that is incomplete; the text says what and in which line or entry.
TAN_API Result<std::vector<ImportedTransfer>> importTransferFunctions(std::string_view text,
                                                                      const ImportContext& context);

/// A file for ParaView that looks as the function does.
TAN_API std::string transferFunctionToParaview(const TransferFunction& function, const std::string& name);

} // namespace tetra
