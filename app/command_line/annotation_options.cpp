// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/annotation_options.h"

#include "app/command_line/option_values.h"
#include "core/base/text.h"
#include "core/data/value_scale.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace tetra {
namespace {

struct KindOption {
    AnnotationKind kind;
    Option option;
};

const std::vector<KindOption>& kindOptions()
{
    static const std::vector<KindOption> all{
        {AnnotationKind::ColourBar,
         {.name = "colour-bar",
          .placeholder = "",
          .explanation = "Adds a legend of the colours to the picture: the transfer function, the isovalues."}},
        {AnnotationKind::Axes,
         {.name = "axes", .placeholder = "", .explanation = "Shows the directions of the axes in a corner."}},
        {AnnotationKind::ScaleBar,
         {.name = "scale-bar",
          .placeholder = "",
          .explanation = "Shows a length in data units; in perspective it applies at the camera's target."}},
        {AnnotationKind::BoxAxes,
         {.name = "box-axes",
          .placeholder = "",
          .explanation = "Shows axes with numbers along the edges of the box around the data, with their names and the "
                         "unit of length, if that is known."}},
        {AnnotationKind::Title,
         {.name = "title", .placeholder = "TEXT", .explanation = "Writes a text into the upper left corner."}}};
    return all;
}

constexpr const char* barRange = "bar-range";
constexpr const char* barQuantity = "bar-quantity";
constexpr const char* barUnit = "bar-unit";
constexpr const char* barNumbers = "bar-numbers";
constexpr const char* lengthNumbers = "length-numbers";
constexpr const char* textSize = "text-size";
constexpr const char* boldText = "bold-text";

const std::vector<Option>& barOptions()
{
    static const std::vector<Option> all{
        {.name = barRange,
         .placeholder = "A:B",
         .explanation = "The values at the ends of the colour bar, so that several pictures have the same one.",
         .byDefault = "the range of the data"},
        {.name = barQuantity,
         .placeholder = "TEXT",
         .explanation = "What the colour bar shows, such as Density.",
         .byDefault = "the name of the values"},
        {.name = barUnit,
         .placeholder = "TEXT",
         .explanation = "The unit of the values, written in brackets behind their name.",
         .byDefault = "that of the data, if they state one"},
        {.name = barNumbers,
         .placeholder = "FORMAT",
         .explanation = "How the numbers at the colour bar are written: auto, as short as tells them apart; plain:N, "
                        "with N decimals; powers:N, in powers of ten with N decimals.",
         .byDefault = "auto"}};
    return all;
}

Result<std::optional<BarEnds>> barEndsOf(const Arguments& arguments)
{
    const auto text = arguments.value(barRange);
    if (!text)
        return std::optional<BarEnds>();
    const auto colon = text->find(':');
    const std::string_view words = *text;
    const auto least = parseFieldValue(words.substr(0, colon));
    const auto largest =
        colon == std::string::npos ? std::optional<double>() : parseFieldValue(words.substr(colon + 1));
    const BarEnds ends{least.value_or(0), largest.value_or(0)};
    if (!least || !largest || !isUsable(ends))
        return Error{ErrorKind::WrongUsage, "'" + *text +
                                                "' does not fit '--bar-range': it takes A:B, two values of the data, A "
                                                "below B, like 20:95."};
    return std::optional<BarEnds>(ends);
}

/// "auto", or a style with its decimals, like "plain:2".
Result<NumberFormat> numbersOf(const Arguments& arguments, const std::string& option)
{
    const auto text = arguments.value(option);
    if (!text || *text == "auto")
        return NumberFormat();
    const auto colon = std::min(text->find(':'), text->size());
    const std::string_view style = std::string_view(*text).substr(0, colon);
    const auto decimals = parseNumber<int>(std::string_view(*text).substr(std::min(colon + 1, text->size())));
    const bool isPlain = style == "plain";
    if ((!isPlain && style != "powers") || !decimals || *decimals < 0 || *decimals > mostDecimals)
        return Error{ErrorKind::WrongUsage, "'" + *text + "' does not fit '--" + option +
                                                "': it takes auto, plain:N or powers:N, with N decimals from 0 to " +
                                                std::to_string(mostDecimals) + ", like plain:1."};
    return NumberFormat{isPlain ? NumberFormat::Style::Plain : NumberFormat::Style::Powers, *decimals};
}

/// What is common to several annotations.
const std::vector<Option>& lookOptions()
{
    static const std::vector<Option> all{
        {.name = lengthNumbers,
         .placeholder = "FORMAT",
         .explanation = "How the numbers of the scale bar and of the axes with numbers are written, as in "
                        "--bar-numbers.",
         .byDefault = "auto"},
        {.name = textSize,
         .placeholder = "N",
         .explanation = "How large the texts of annotations are, from 6 to 48, in units of which a picture is 768 "
                        "high; bars, arrows and lines grow with them.",
         .byDefault = "12"},
        {.name = boldText, .placeholder = "", .explanation = "Writes all annotations in bold letters."}};
    return all;
}

/// Options of the colour bar say something of a bar that is there, and so do others.
Status checkShown(const Arguments& arguments)
{
    const auto needs = [&](const std::string& option, const std::string& what, const std::string& others) {
        return Error{ErrorKind::WrongUsage, "'--" + option + "' is for " + what + ": it needs " + others + "."};
    };
    if (!arguments.has("colour-bar"))
        for (const Option& option : barOptions())
            if (arguments.has(option.name))
                return needs(option.name, "the colour bar", "'--colour-bar'");
    if (arguments.has(lengthNumbers) && !arguments.has("scale-bar") && !arguments.has("box-axes"))
        return needs(lengthNumbers, "lengths", "'--scale-bar' or '--box-axes'");
    const bool isAny =
        std::ranges::any_of(kindOptions(), [&](const KindOption& kind) { return arguments.has(kind.option.name); });
    for (const char* option : {textSize, boldText})
        if (arguments.has(option) && !isAny)
            return needs(option, "annotations", "one, such as '--colour-bar'");
    return {};
}

} // namespace

std::vector<Option> annotationOptions()
{
    std::vector<Option> options;
    for (const KindOption& entry : kindOptions())
        options.push_back(entry.option);
    options.insert(options.begin() + 1, barOptions().begin(), barOptions().end());
    options.insert(options.end(), lookOptions().begin(), lookOptions().end());
    return options;
}

Result<AnnotationState> annotationsOf(const Arguments& arguments)
{
    if (const Status some = checkShown(arguments); !some)
        return some.error();
    const auto ends = barEndsOf(arguments);
    if (!ends)
        return ends.error();
    const auto numbers = numbersOf(arguments, barNumbers);
    if (!numbers)
        return numbers.error();
    const auto lengths = numbersOf(arguments, lengthNumbers);
    if (!lengths)
        return lengths.error();
    const auto size = numberOption(arguments, textSize, usualTextSize, smallestTextSize, largestTextSize);
    if (!size)
        return size.error();
    AnnotationState state;
    state.barEnds = *ends;
    state.numbers = *numbers;
    state.lengths = *lengths;
    state.textSize = *size;
    state.boldText = arguments.has(boldText);
    for (const auto& [kind, option] : kindOptions())
        state[kind].shown = arguments.has(option.name);
    state.title = arguments.value("title").value_or("");
    state[AnnotationKind::Title].shown = !state.title.empty();
    state.quantity = arguments.value(barQuantity).value_or("");
    state.unit = arguments.value(barUnit).value_or("");
    return state;
}

} // namespace tetra
