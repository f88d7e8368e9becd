// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/annotation_options.h"

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
        {AnnotationKind::Title,
         {.name = "title", .placeholder = "TEXT", .explanation = "Writes a text into the upper left corner."}}};
    return all;
}

constexpr const char* barRange = "bar-range";
constexpr const char* barQuantity = "bar-quantity";
constexpr const char* barUnit = "bar-unit";
constexpr const char* barNumbers = "bar-numbers";

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
         .explanation = "The unit of the values, written in brackets behind their name."},
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
Result<NumberFormat> numbersOf(const Arguments& arguments)
{
    const auto text = arguments.value(barNumbers);
    if (!text || *text == "auto")
        return NumberFormat();
    const auto colon = std::min(text->find(':'), text->size());
    const std::string_view style = std::string_view(*text).substr(0, colon);
    const auto decimals = parseNumber<int>(std::string_view(*text).substr(std::min(colon + 1, text->size())));
    const bool isPlain = style == "plain";
    if ((!isPlain && style != "powers") || !decimals || *decimals < 0 || *decimals > mostDecimals)
        return Error{ErrorKind::WrongUsage, "'" + *text +
                                                "' does not fit '--bar-numbers': it takes auto, plain:N or powers:N, "
                                                "with N decimals from 0 to " +
                                                std::to_string(mostDecimals) + ", like plain:1."};
    return NumberFormat{isPlain ? NumberFormat::Style::Plain : NumberFormat::Style::Powers, *decimals};
}

/// Options of the colour bar say something of a bar that is there.
Status checkBar(const Arguments& arguments)
{
    if (arguments.has("colour-bar"))
        return {};
    for (const Option& option : barOptions())
        if (arguments.has(option.name))
            return Error{ErrorKind::WrongUsage,
                         "'--" + option.name + "' is for the colour bar: it needs '--colour-bar'."};
    return {};
}

} // namespace

std::vector<Option> annotationOptions()
{
    std::vector<Option> options;
    for (const KindOption& entry : kindOptions())
        options.push_back(entry.option);
    options.insert(options.begin() + 1, barOptions().begin(), barOptions().end());
    return options;
}

Result<AnnotationState> annotationsOf(const Arguments& arguments)
{
    if (const Status some = checkBar(arguments); !some)
        return some.error();
    const auto ends = barEndsOf(arguments);
    if (!ends)
        return ends.error();
    const auto numbers = numbersOf(arguments);
    if (!numbers)
        return numbers.error();
    AnnotationState state;
    state.barEnds = *ends;
    state.numbers = *numbers;
    for (const auto& [kind, option] : kindOptions())
        state[kind].shown = arguments.has(option.name);
    state.title = arguments.value("title").value_or("");
    state[AnnotationKind::Title].shown = !state.title.empty();
    state.quantity = arguments.value(barQuantity).value_or("");
    state.unit = arguments.value(barUnit).value_or("");
    return state;
}

} // namespace tetra
