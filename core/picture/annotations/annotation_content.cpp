// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/annotation_content.h"

#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "core/picture/annotations/field_name.h"
#include "core/view/appearance.h"

#include <algorithm>

namespace tetra {
namespace {

std::vector<Isovalue> seenOnes(std::vector<Isovalue> isovalues)
{
    std::erase_if(isovalues, [](const Isovalue& isovalue) { return !isovalue.visible; });
    return isovalues;
}

} // namespace

std::string usualQuantity(const ModelDescription& description, const AnnotationLanguage& language)
{
    return holdsLogarithms(description.parameters) ? visibleText(nameOfLogarithms(description.valueName))
                                                   : fieldName(description, language);
}

std::string usualUnit(const ModelDescription& description)
{
    const auto unit = std::ranges::find(description.taken, TakenPart::Unit, &Taken::part);
    return unit != description.taken.end() ? visibleText(unit->what.text()) : std::string();
}

std::string usualTitle(const Model& model)
{
    return visibleText(completeBaseName(model.path().native()));
}

AnnotationContent annotationContent(const Model& model, const std::vector<Parameter>& parameters, const ViewValue& view,
                                    const std::string& accuracy, const AnnotationLanguage& language)
{
    const ModelDescription& description = model.description();
    AnnotationContent content;
    content.range = description.range;
    if (const Parameter* function = mainTransfer(parameters)) {
        const TransferFunction* chosen = chosenTransfer(function->id, view.appearance);
        content.transferParameter = function->id;
        content.transfer = chosen != nullptr ? *chosen : std::get<TransferFunction>(function->defaultValue);
    }
    if (hasParameter(parameters, isovaluesId))
        content.isovalues = seenOnes(view.isovalues);
    content.logarithms = holdsLogarithms(description.parameters);
    content.field = usualQuantity(description, language);
    content.unit = usualUnit(description);
    if (description.space.find_first_not_of("RLAPSI") == std::string::npos)
        content.space = description.space;
    content.lengthUnit = visibleText(description.lengthUnit);
    content.box = description.bounds;
    content.title = usualTitle(model);
    content.accuracy = accuracy;
    content.state = view.annotations;
    content.camera = view.camera;
    content.background = view.background.value_or(content.background);
    content.language = language;
    return content;
}

AnnotationContent inView(AnnotationContent content, const ViewValue& view, const std::string& accuracy)
{
    content.camera = view.camera;
    if (const TransferFunction* chosen = chosenTransfer(content.transferParameter, view.appearance);
        content.transfer && chosen != nullptr)
        content.transfer = *chosen;
    if (content.isovalues)
        content.isovalues = seenOnes(view.isovalues);
    content.accuracy = accuracy;
    return content;
}

} // namespace tetra
