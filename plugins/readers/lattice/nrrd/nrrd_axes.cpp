// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_axes.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

constexpr std::size_t largestDimension = 16; // of the format
constexpr std::string_view blanks = " \t";

Error wrongField(const std::string& field, std::string_view value, const Message& why)
{
    return {ErrorKind::BadInput, Message::say("'%1: %2' in its header %3", field, printable(value), why)};
}

/// The words of a field that has one for each axis; none if the field is not there.
Result<std::vector<std::string_view>> wordsOf(const NrrdFields& fields, const std::string& field, std::size_t dimension)
{
    std::vector<std::string_view> words = split(fields[field], blanks);
    if (fields.has(field) && words.size() != dimension)
        return wrongField(field, fields[field],
                          Message::say("must have one entry for each of the %1 axes.", dimension));
    return words;
}

Result<std::size_t> parseDimension(const NrrdFields& fields)
{
    const auto dimension = parseNumber<std::size_t>(fields["dimension"]);
    if (!fields.has("dimension"))
        return Error{ErrorKind::BadInput, Message::say("its header has no field 'dimension'.")};
    if (!dimension || *dimension == 0 || *dimension > largestDimension)
        return wrongField("dimension", fields["dimension"], Message::say("must be a number from 1 to 16."));
    return *dimension;
}

Status parseSizes(const NrrdFields& fields, std::vector<NrrdAxis>& axes)
{
    if (!fields.has("sizes"))
        return Error{ErrorKind::BadInput, Message::say("its header has no field 'sizes'.")};
    const auto words = wordsOf(fields, "sizes", axes.size());
    if (!words)
        return words.error();
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const auto size = parseNumber<std::uint64_t>((*words)[axis]);
        if (!size || *size == 0)
            return wrongField("sizes", fields["sizes"], Message::say("must be whole numbers from 1."));
        axes[axis].size = *size;
    }
    return {};
}

Status parseNumbers(const NrrdFields& fields, const std::string& field, std::vector<NrrdAxis>& axes,
                    std::optional<double> NrrdAxis::*member)
{
    const auto words = wordsOf(fields, field, axes.size());
    if (!words)
        return words.error();
    for (std::size_t axis = 0; axis < words->size(); ++axis) {
        const auto number = parseNumber<double>((*words)[axis]);
        if (!number)
            return wrongField(field, fields[field], Message::say("must be numbers."));
        if (std::isfinite(*number))
            axes[axis].*member = *number;
    }
    return {};
}

Status parseKindsAndCenters(const NrrdFields& fields, std::vector<NrrdAxis>& axes)
{
    const auto kinds = wordsOf(fields, "kinds", axes.size());
    if (!kinds)
        return kinds.error();
    for (std::size_t axis = 0; axis < kinds->size(); ++axis)
        if (const std::string kind = lowerCase((*kinds)[axis]); kind != "???" && kind != "none")
            axes[axis].kind = kind;
    const auto centers = wordsOf(fields, "centers", axes.size());
    if (!centers)
        return centers.error();
    for (std::size_t axis = 0; axis < centers->size(); ++axis)
        axes[axis].centeredInCells = lowerCase((*centers)[axis]) == "cell";
    return {};
}

/// Separates "(1,0,0) none (0, 1, 0)"; a parenthesis that is not closed reaches to the end.
std::vector<std::string_view> splitVectors(std::string_view text)
{
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t last = text.front() == '(' ? text.find(')') : text.find_first_of(" \t(", 1) - 1;
        const std::size_t length = last >= text.size() ? text.size() : last + 1;
        words.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return words;
}

Status parseDirections(const NrrdFields& fields, std::vector<NrrdAxis>& axes)
{
    const std::string field = "space directions";
    if (!fields.has(field))
        return {};
    const std::vector<std::string_view> words = splitVectors(fields[field]);
    if (words.size() != axes.size())
        return wrongField(field, fields[field],
                          Message::say("must have one entry for each of the %1 axes.", axes.size()));
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (lowerCase(words[axis]) == "none")
            continue;
        const auto vector = parseNrrdVector(words[axis], nrrdSpaceHasTime(fields));
        if (!vector)
            return wrongField(field, fields[field],
                              Message::say("must be 'none' or three numbers in parentheses for each axis."));
        if (vector->place.array().isNaN().all()) // as programs wrote 'none' before the format had the word
            continue;
        axes[axis].direction = vector->place;
        axes[axis].runsThroughTime = vector->time != 0;
    }
    return {};
}

bool holdsPoints(const NrrdAxis& axis)
{
    return axis.kind.empty() || axis.kind == "domain" || axis.kind == "space" || axis.kind == "time";
}

bool holdsSteps(const NrrdAxis& axis)
{
    return axis.kind == "time" || axis.kind == "list" || axis.runsThroughTime;
}

/// The axis without a direction beside three that have one; none if that is not so.
std::optional<std::size_t> axisOutsideSpace(const std::vector<NrrdAxis>& axes, const std::vector<std::size_t>& several)
{
    std::optional<std::size_t> outside;
    std::size_t inSpace = 0;
    for (const std::size_t axis : several)
        if (axes[axis].direction)
            ++inSpace;
        else
            outside = axis;
    return inSpace == 3 && several.size() == 4 ? outside : std::nullopt;
}

/// Of more than three axes with points or steps the one that holds steps, or components without saying so.
void takeFourth(const std::vector<NrrdAxis>& axes, std::vector<std::size_t>& several, NrrdRoles& roles)
{
    if (several.size() != 4)
        return;
    auto fourth = std::ranges::find_if(several, [&](std::size_t axis) { return holdsSteps(axes[axis]); });
    if (const auto outside = axisOutsideSpace(axes, several); fourth == several.end() && outside)
        fourth = std::ranges::find(several, *outside);
    if (fourth == several.end())
        return;
    const bool areComponents = *fourth == 0 && !roles.components && !holdsSteps(axes[0]);
    (areComponents ? roles.components : roles.steps) = *fourth;
    several.erase(fourth);
}

} // namespace

Result<NrrdRoles> nrrdRoles(const std::vector<NrrdAxis>& axes)
{
    constexpr std::uint64_t mostComponents = 1'000'000;
    NrrdRoles roles;
    std::vector<std::size_t> several;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (axes.size() > 3 && axes[axis].size == 1)
            continue;
        const bool isOfPoint = !holdsPoints(axes[axis]) && axes[axis].kind != "list";
        if (isOfPoint && axes.size() > 3 && !roles.components && axes[axis].size <= mostComponents)
            roles.components = axis;
        else
            several.push_back(axis);
    }
    takeFourth(axes, several, roles);
    for (const std::size_t axis : several)
        if (!holdsPoints(axes[axis]))
            return Error{
                ErrorKind::BadInput,
                Message::say("one of its axes, of size %1, holds '%2' instead of points. Take out one component first.",
                             axes[axis].size, printable(axes[axis].kind))};
    if (several.size() != 3)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 dimensions, %2 of them with more than one point. A volume has three: take "
                                  "out a part that has, such as one component or one time step.",
                                  axes.size(), several.size())};
    std::ranges::copy(several, roles.points.begin());
    return roles;
}

bool nrrdSpaceHasTime(const NrrdFields& fields)
{
    const std::string space = lowerCase(fields["space"]);
    return space.ends_with("-time") || space == "rast" || space == "last" || space == "lpst" ||
           fields["space dimension"] == "4";
}

std::optional<NrrdVector> parseNrrdVector(std::string_view text, bool withTime)
{
    text = trimmed(text);
    if (!text.starts_with('(') || !text.ends_with(')'))
        return {};
    const std::vector<std::string_view> words = split(text.substr(1, text.size() - 2), ",");
    if (words.size() != (withTime ? 4 : 3))
        return {};
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto number = parseNumber<double>(trimmed(words[i]));
        if (!number)
            return {};
        numbers[i] = *number;
    }
    return NrrdVector{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

Result<std::vector<NrrdAxis>> parseNrrdAxes(const NrrdFields& fields)
{
    const Result<std::size_t> dimension = parseDimension(fields);
    if (!dimension)
        return dimension.error();
    std::vector<NrrdAxis> axes(*dimension);
    for (const Status& parsed : {parseSizes(fields, axes), parseNumbers(fields, "spacings", axes, &NrrdAxis::spacing),
                                 parseNumbers(fields, "axis mins", axes, &NrrdAxis::minimum),
                                 parseNumbers(fields, "axis maxs", axes, &NrrdAxis::maximum),
                                 parseKindsAndCenters(fields, axes), parseDirections(fields, axes)})
        if (!parsed)
            return parsed.error();
    return axes;
}

} // namespace tetra
