// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/shown_mesh.h"

#include "core/base/text.h"
#include "core/data/value_scale.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace tetra {
namespace {

/// Nothing differs by more; what is more is not worth a digit.
constexpr double mostShownPercent = 100;

/// With so many significant digits, and no more than it needs.
std::string digitsOf(double number, int digits, const NumberSigns& signs)
{
    std::array<char, 32> text{}; // -1.79769313486e+308 has 19 characters
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return withSigns({text.data(), end}, signs);
}

Message numberOf(double percent, const ShownMesh& mesh, const NumberSigns& signs)
{
    return errorNumber(std::min(percent, mostShownPercent), mesh.logarithms, signs);
}

/// By the words of the kind of error, without the one in space.
Message keptErrors(const ShownMesh& mesh, const NumberSigns& signs)
{
    const auto kept = [&](double percent) { return numberOf(keptPercent(percent, mesh.scale), mesh, signs); };
    if (const auto& range = mesh.query.range)
        return Message::say("%1 from %2 to %3", textFor(errorsNames, mesh.errorMeaning),
                            numberOf(std::min(range->one.error, range->other.error), mesh, signs),
                            numberOf(std::max(range->one.error, range->other.error), mesh, signs));
    const MarkedText name = textFor(errorNames, mesh.errorMeaning);
    if (const SpaceRamp* const ramp = mesh.query.error.asSpaceRamp())
        return Message::say("%1 %2 in the focus, %3 outside", name, kept(ramp->inner), kept(ramp->outer));
    const ValueRange bounds = mesh.query.error.bounds();
    if (!mesh.query.error.isConstant())
        return Message::say("%1 %2 to %3", name, kept(bounds.minimum), kept(bounds.maximum));
    return Message::say("%1 %2", name, kept(bounds.maximum));
}

} // namespace

std::optional<ValueRange> logarithmsOf(const ModelDescription& model)
{
    return holdsLogarithms(model.parameters) ? std::optional(model.range) : std::nullopt;
}

std::string factorNumber(double percent, const ValueRange& logarithms, const NumberSigns& signs)
{
    const double factor = factorOf(percent, logarithms);
    return digitsOf(factor, factorDigits(factor), signs);
}

Message errorNumber(double percent, const std::optional<ValueRange>& logarithms, const NumberSigns& signs)
{
    constexpr int digits = 3;
    const Message text = Message::say("%1 %", digitsOf(percent, digits, signs));
    if (!logarithms || !(percent > 0))
        return text;
    return Message::say("%1 (%2)", text, Message::say("a factor of %1", factorNumber(percent, *logarithms, signs)));
}

namespace {

Message errorOfMesh(const ShownMesh& mesh, const NumberSigns& signs)
{
    const Message kept = keptErrors(mesh, signs);
    if (!mesh.errorInSpace)
        return kept;
    const Message inSpace = errorNumber(*mesh.errorInSpace, mesh.logarithms, signs);
    return mesh.logarithms ? Message::say("%1, in space up to %2", kept, inSpace)
                           : Message::say("%1 (in space up to %2)", kept, inSpace);
}

} // namespace

Message errorMessage(const ShownMesh& mesh, const NumberSigns& signs)
{
    switch (mesh.shown) {
    case ShownField::Data: return Message::say("the data themselves");
    case ShownField::Difference:
        return Message::say("difference to the data, %1 times as bright, of a mesh with %2", differenceBrightness,
                            errorOfMesh(mesh, signs));
    case ShownField::Mesh: break;
    }
    const Message error = errorOfMesh(mesh, signs);
    switch (mesh.instead) {
    case MeshInstead::OfRange: return Message::say("%1; data are not shown with a range of accuracies", error);
    case MeshInstead::OfWindow: return Message::say("%1; data are not shown with a crop box", error);
    case MeshInstead::OfValues: return Message::say("%1; data are not shown with a filter of values", error);
    case MeshInstead::OfFocus: return Message::say("%1; data are not shown with a focus", error);
    case MeshInstead::No: break;
    }
    return error;
}

std::string accuracyText(const ShownMesh& mesh, const AnnotationLanguage& language)
{
    std::string text = language.say(errorMessage(mesh, language.numbers));
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

} // namespace tetra
