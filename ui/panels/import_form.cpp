// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/import_form.h"

#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <span>

namespace tetra {
namespace {

class ImportForms {
    Q_DECLARE_TR_FUNCTIONS(ImportForm)
};

constexpr std::array<std::string_view, 4> layoutIds = {"size", "type", "byte-order", "skip"};
constexpr std::array<std::string_view, 3> placeIds = {"spacing", "origin", "unit"};
/// What only files of one kind leave to the user: beside others it would be a riddle.
constexpr std::array<std::string_view, 1> rareIds = {"axes"};
constexpr std::array<std::string_view, 2> cellIds = {"faulty", "polyhedra"};
constexpr std::array<std::string_view, 3> blockIds = {"part", "block", "grid"};

template <std::size_t Count> bool isOneOf(const std::array<std::string_view, Count>& ids, const std::string& id)
{
    return std::ranges::find(ids, id) != ids.end();
}

bool isText(const Parameter& parameter)
{
    return std::holds_alternative<std::string>(parameter.defaultValue);
}

/// Names of arrays stay, unless the reader knows them beforehand.
QString arrayText(const Parameter& parameter, const FileArray& array)
{
    const bool isKnown = std::ranges::find(parameter.choices, array.name) != parameter.choices.end();
    QString text = isKnown ? translatedText(array.name) : shownText(array.name);
    if (array.components > 1)
        text = ImportForms::tr("%1, %2 components").arg(text).arg(array.components);
    if (array.perCell)
        text = ImportForms::tr("%1 (of the cells)").arg(text);
    return text;
}

std::vector<ParameterChoice> arrayChoices(const Parameter& parameter, const FileContents& contents)
{
    std::vector<ParameterChoice> choices;
    const auto byDefault = std::get<std::string>(parameter.defaultValue);
    if (std::ranges::find(contents.arrays, byDefault, &FileArray::name) == contents.arrays.end())
        choices.push_back({byDefault, translatedText(byDefault.empty() ? "automatic" : byDefault)}); // its own choice
    for (const FileArray& array : contents.arrays)
        choices.push_back({array.name, arrayText(parameter, array)});
    return choices;
}

/// Of the array that is chosen; the reader takes the first one by itself.
int componentsOf(const FileContents& contents, const ParameterValues& values)
{
    if (contents.arrays.empty())
        return 1;
    const auto chosen = values.find("array");
    const auto* const name = chosen != values.end() ? std::get_if<std::string>(&chosen->second) : nullptr;
    const auto found =
        name != nullptr ? std::ranges::find(contents.arrays, *name, &FileArray::name) : contents.arrays.end();
    return found != contents.arrays.end() ? found->components : contents.arrays.front().components;
}

std::vector<ParameterChoice> componentChoices(int components)
{
    std::vector<ParameterChoice> choices = {{std::string("magnitude"), ImportForms::tr("Magnitude")}};
    for (int component = 0; component < components; ++component) {
        const QString number = QString::number(component);
        const QString name =
            components == 3 ? QString("%1 (%2)").arg(number, QString("xyz").mid(component, 1)) : number;
        choices.push_back({std::to_string(component), name});
    }
    return choices;
}

/// A default of 0 is the reader's own choice.
std::vector<ParameterChoice> timeChoices(const Parameter& parameter, const FileContents& contents)
{
    std::vector<ParameterChoice> choices;
    if (parameter.defaultValue == ParameterValue(std::int64_t(0)))
        choices.push_back({parameter.defaultValue, ImportForms::tr("Automatic")});
    std::int64_t number = 0;
    for (const double time : contents.timeSteps) {
        ++number;
        choices.push_back({number, ImportForms::tr("%1: t = %2").arg(number).arg(QLocale().toString(time, 'g', 6))});
    }
    return choices;
}

std::vector<ParameterChoice> blockChoices(const Parameter& parameter, const FileContents& contents)
{
    std::vector<ParameterChoice> choices;
    // Levels of a picture and zones that overlap do not fit together: the reader takes one of them.
    const bool takesOne = std::ranges::find(contents.taken, TakenPart::Block, &Taken::part) != contents.taken.end();
    if (isText(parameter) || parameter.defaultValue == ParameterValue(std::int64_t(0)))
        choices.push_back({parameter.defaultValue,
                           takesOne ? ImportForms::tr("Automatic") : ImportForms::tr("All that go together")});
    for (std::size_t block = 0; block < contents.blocks.size(); ++block) {
        const std::string& name = contents.blocks[block];
        const ParameterValue value =
            isText(parameter) ? ParameterValue(name) : ParameterValue(static_cast<std::int64_t>(block) + 1);
        choices.push_back({value, shownText(name)});
    }
    return choices;
}

/// By name; the first way is the reader's own.
std::vector<ParameterChoice> nameChoices(const Parameter& parameter, std::span<const std::string> names)
{
    std::vector<ParameterChoice> choices = {{parameter.defaultValue, ImportForms::tr("Automatic")}};
    for (const std::string& name : names)
        choices.push_back({name, shownText(name)});
    return choices;
}

/// Nothing: the reader's own way to choose. One: nothing to choose.
std::vector<ParameterChoice> choicesOf(const Parameter& parameter, const FileContents& contents,
                                       const ParameterValues& values)
{
    const bool hasNames = std::ranges::any_of(contents.arrays, [](const FileArray& one) { return !one.name.empty(); });
    if (parameter.id == "array" && isText(parameter) && contents.domain && !hasNames)
        return std::vector<ParameterChoice>(1); // the file has one, and no name for it
    if (parameter.id == "array" && isText(parameter) && !contents.arrays.empty())
        return arrayChoices(parameter, contents);
    if (parameter.id == "component" && isText(parameter) && (contents.domain || !contents.arrays.empty())) {
        const int components = componentsOf(contents, values);
        return components > 1 ? componentChoices(components) : std::vector<ParameterChoice>(1);
    }
    if (parameter.id == "time" && std::holds_alternative<std::int64_t>(parameter.defaultValue))
        return contents.timeSteps.size() > 1 ? timeChoices(parameter, contents) : std::vector<ParameterChoice>(1);
    if (parameter.id == "solution" && contents.domain && contents.domain != DomainClass::Curvilinear)
        return std::vector<ParameterChoice>(1);
    if (parameter.id == "series" && isText(parameter))
        return contents.series.size() > 1 ? nameChoices(parameter, contents.series) : std::vector<ParameterChoice>(1);
    if (parameter.id == "channel" && isText(parameter))
        return contents.channels.size() > 1 ? nameChoices(parameter, contents.channels)
                                            : std::vector<ParameterChoice>(1);
    if (isOneOf(cellIds, parameter.id) && contents.domain && contents.domain != DomainClass::Irregular &&
        contents.blocks.size() < 2)
        return std::vector<ParameterChoice>(1);
    if (isOneOf(blockIds, parameter.id))
        return contents.blocks.size() > 1 ? blockChoices(parameter, contents) : std::vector<ParameterChoice>(1);
    return {};
}

} // namespace

bool ImportForm::looksLike(const ImportForm& other) const
{
    const auto sameChoice = [](const ParameterChoice& a, const ParameterChoice& b) {
        return a.value == b.value && a.label == b.label;
    };
    return std::ranges::equal(parameters, other.parameters, {}, &Parameter::id, &Parameter::id) &&
           std::ranges::equal(choices, other.choices, [&](const auto& a, const auto& b) {
               return a.first == b.first && std::ranges::equal(a.second, b.second, sameChoice);
           });
}

bool needsLayout(const std::vector<Parameter>& parameters, const FileContents& contents)
{
    const auto has = [&](const char* id) {
        return std::ranges::find(parameters, id, &Parameter::id) != parameters.end();
    };
    return has("size") && has("skip") && contents.points == 0;
}

ImportForm importForm(const std::vector<Parameter>& parameters, const FileContents& contents,
                      const ParameterValues& values, bool withLayout)
{
    const bool isKnown = contents.domain.has_value() || !contents.arrays.empty();
    ImportForm form;
    for (const Parameter& parameter : parameters) {
        const bool isLayout = needsLayout(parameters, {}) && isOneOf(layoutIds, parameter.id);
        const bool isUntold = std::ranges::find(contents.untold, parameter.id) != contents.untold.end();
        const bool isTold = isOneOf(placeIds, parameter.id) && !isUntold;
        if (((isLayout || isTold) && !withLayout) || (isOneOf(rareIds, parameter.id) && !isUntold))
            continue;
        const auto choices = isKnown ? choicesOf(parameter, contents, values) : std::vector<ParameterChoice>();
        if (choices.size() == 1)
            continue;
        form.parameters.push_back(parameter);
        if (!choices.empty())
            form.choices[parameter.id] = choices;
    }
    return form;
}

} // namespace tetra
