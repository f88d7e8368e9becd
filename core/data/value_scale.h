// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tetra {

/// How the values of a file become those of a dataset: as they are, or their logarithms to base 10. Of logarithms an
/// error is a factor: a value within e of log10(v) stands for one between v / 10^e and v 10^e.
struct ValueScale {
    bool logarithmic = false;
    /// With logarithms: what smaller values are taken as, positive. Without it every value has to be positive.
    std::optional<double> from{};
    bool operator==(const ValueScale&) const = default;
};

/// "log" or "log:1e-06", as parseScale() reads it; empty for the values as they are.
TAN_INTERNAL std::string scaleText(const ValueScale& scale);
/// "linear", "log" or "log:" and a positive number; an empty text is linear. The error (WrongUsage) says what is wrong.
TAN_INTERNAL Result<ValueScale> parseScale(std::string_view text);

/// The dataset with the logarithms of its values, as floats: Source::valueName says so, the hash is that of the
/// logarithms, and Source::leftOut tells how many values were smaller than `scale.from`. The same dataset where the
/// scale is linear. The same bits on every machine. Errors (WrongUsage): values that are not positive and no
/// `scale.from`, counted, with the smallest positive one; none above it. Cancelled; not enough memory. O(points), on
/// all threads.
TAN_INTERNAL Result<Dataset> scaled(const Dataset& dataset, const ValueScale& scale, const Progress& progress = {});

/// "log10(nut)"; "log10(value)" of values without a name.
TAN_INTERNAL std::string logarithmName(std::string_view valueName);
/// What the values are called whose logarithms have this name: "nut" of "log10(nut)".
TAN_INTERNAL std::string nameOfLogarithms(std::string_view logarithmName);

/// The name among the parameters of a model (ModelDescription::parameters) under which it keeps its scaleText().
inline constexpr std::string_view scaleParameter = "import.scale";
/// Whether a model with these parameters holds logarithms.
TAN_INTERNAL bool holdsLogarithms(std::span<const std::pair<std::string, std::string>> parameters);

/// Among the facts in a file of a mesh (core/serve/mesh_facts.h): that its values are logarithms.
inline constexpr std::string_view scaleFact = "value_scale";
inline constexpr std::string_view logarithmFact = "log10";

/// 10^x of each, in floats: the values whose logarithms these are.
TAN_INTERNAL Buffer<float> valuesOfLogarithms(std::span<const float> logarithms);

/// A value of a field as it is typed: a number or, for a field of logarithms, "log10(3e-5)", the logarithm of a
/// positive value of the data. Nothing if it is neither, or not finite.
TAN_INTERNAL std::optional<double> parseFieldValue(std::string_view text);

/// The factor that an error of so many percent of the range is, where the values are logarithms: 10^(percent/100 *
/// range).
TAN_INTERNAL double factorOf(double percent, const ValueRange& range);

/// The logarithm to base 10 of a positive finite number: the same bits on every machine with IEEE arithmetic, which the
/// C library's is not, and correct to a few units in the last place.
TAN_INTERNAL double portableLogarithm(double x) noexcept;

} // namespace tetra
