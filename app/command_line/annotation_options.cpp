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

Result<std::optional<BarEnds>> barEndsOf(const Arguments& arguments)
{
    const auto text = arguments.value(barRange);
    if (!text)
        return std::optional<BarEnds>();
    if (!arguments.has("colour-bar"))
        return Error{ErrorKind::WrongUsage, "'--bar-range' sets the ends of the colour bar: it needs '--colour-bar'."};
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

} // namespace

std::vector<Option> annotationOptions()
{
    std::vector<Option> options;
    for (const KindOption& entry : kindOptions())
        options.push_back(entry.option);
    options.insert(options.begin() + 1, {.name = barRange,
                                         .placeholder = "A:B",
                                         .explanation = "The values at the ends of the colour bar, so that several "
                                                        "pictures have the same one.",
                                         .byDefault = "the range of the data"});
    return options;
}

Result<AnnotationContent> annotationsOf(const Arguments& arguments)
{
    const auto ends = barEndsOf(arguments);
    if (!ends)
        return ends.error();
    AnnotationContent content;
    content.state.barEnds = *ends;
    for (const auto& [kind, option] : kindOptions())
        content.state[kind].shown = arguments.has(option.name);
    content.title = arguments.value("title").value_or("");
    return content;
}

} // namespace tetra
