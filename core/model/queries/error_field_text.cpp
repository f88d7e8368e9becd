// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/error_field_text.h"

#include "core/base/number_text.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace tetra {

namespace {

using Node = ErrorField::Node;

constexpr std::array<std::string_view, 4> operationNames = {"sum", "product", "min", "max"};

std::string_view nameOf(FieldOperation operation)
{
    return operationNames[static_cast<std::size_t>(operation)];
}

void writeNumbers(std::initializer_list<double> numbers, std::string& text)
{
    const char* separator = "";
    for (const double number : numbers) {
        text += separator + formatNumber(number);
        separator = ", ";
    }
}

void writeRegion(const Box& box, std::string& text)
{
    text += "box(";
    writeNumbers({box.least.x(), box.least.y(), box.least.z(), box.largest.x(), box.largest.y(), box.largest.z()},
                 text);
}

void writeRegion(const Sphere& sphere, std::string& text)
{
    text += sphere.radius == 0 ? "camera(" : "sphere(";
    writeNumbers({sphere.centre.x(), sphere.centre.y(), sphere.centre.z()}, text);
    if (sphere.radius != 0)
        text += ", " + formatNumber(sphere.radius);
}

void writeRegion(const HalfSpace& half, std::string& text)
{
    text += "halfspace(";
    writeNumbers({half.normal.x(), half.normal.y(), half.normal.z(), half.offset}, text);
}

void write(const SpaceRamp& ramp, std::string& text)
{
    std::visit([&text](const auto& body) { writeRegion(body, text); }, ramp.region);
    text += "; ";
    writeNumbers({ramp.inner, ramp.outer, ramp.falloff}, text);
    text += ')';
}

void write(const ValueRamp& ramp, std::string& text)
{
    text += "values(";
    const char* separator = "";
    for (const auto& [value, error] : ramp.knots) {
        text += separator + formatNumber(value) + ':' + formatNumber(error);
        separator = ", ";
    }
    text += ')';
}

void write(const ErrorField& field, std::string& text);

/// The operands, which are combined from the left.
void writeOperands(FieldOperation operation, const ErrorField& field, std::string& text)
{
    const auto* const pair = std::get_if<Node::Pair>(&field.root().content);
    if (pair == nullptr || pair->operation != operation)
        return write(field, text);
    writeOperands(operation, pair->first, text);
    text += ", ";
    write(pair->second, text);
}

void write(const ErrorField& field, std::string& text)
{
    const Node& node = field.root();
    if (const double* const number = std::get_if<double>(&node.content)) {
        text += formatNumber(*number);
    } else if (const SpaceRamp* const inSpace = std::get_if<SpaceRamp>(&node.content)) {
        write(*inSpace, text);
    } else if (const ValueRamp* const overValues = std::get_if<ValueRamp>(&node.content)) {
        write(*overValues, text);
    } else {
        const FieldOperation operation = std::get_if<Node::Pair>(&node.content)->operation;
        text += std::string(nameOf(operation)) + '(';
        writeOperands(operation, field, text);
        text += ')';
    }
}

} // namespace

std::string toText(const ErrorField& field)
{
    std::string text;
    write(field, text);
    return text;
}

} // namespace tetra
