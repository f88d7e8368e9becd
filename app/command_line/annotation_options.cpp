// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/annotation_options.h"

#include <algorithm>

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
          .explanation = "Writes what the colours mean over the picture: the transfer function, the isovalues."}},
        {AnnotationKind::Axes,
         {.name = "axes", .placeholder = "", .explanation = "Shows the directions of the axes in a corner."}},
        {AnnotationKind::ScaleBar,
         {.name = "scale-bar",
          .placeholder = "",
          .explanation = "Shows a length in the units of the data; in perspective it holds at the camera's target."}},
        {AnnotationKind::Title,
         {.name = "title", .placeholder = "TEXT", .explanation = "Writes a text into the upper left corner."}}};
    return all;
}

} // namespace

std::vector<Option> annotationOptions()
{
    std::vector<Option> options;
    for (const KindOption& entry : kindOptions())
        options.push_back(entry.option);
    return options;
}

bool askForAnnotations(std::span<const std::string> words)
{
    const auto isPicture = [&](std::size_t at) {
        return words[at].ends_with(".png") && (at == 0 || !words[at - 1].starts_with('-'));
    };
    for (std::size_t at = 0; at < words.size(); ++at)
        if (words[at].ends_with(".tansession") || isPicture(at))
            return true;
    return std::ranges::any_of(words, [](const std::string& word) {
        const std::string given = word.substr(0, word.find('='));
        return given == "--lens" || std::ranges::any_of(kindOptions(), [&](const KindOption& entry) {
                   return given == "--" + entry.option.name;
               });
    });
}

AnnotationContent annotationsOf(const Arguments& arguments)
{
    AnnotationContent content;
    for (const auto& [kind, option] : kindOptions())
        content.state[kind].shown = arguments.has(option.name);
    content.title = QString::fromStdString(arguments.value("title").value_or(""));
    return content;
}

} // namespace tetra
