// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/annotations/annotation_content.h"

#include "core/data/value_scale.h"
#include "core/view/appearance.h"
#include "plugins/api/scene_parameters.h"
#include "ui/annotations/field_name.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/session/shown_mesh.h"

#include <tan/model.h>

#include <QFileInfo>
#include <QGuiApplication>

namespace tetra {
namespace {

std::vector<Isovalue> seenOnes(std::vector<Isovalue> isovalues)
{
    std::erase_if(isovalues, [](const Isovalue& isovalue) { return !isovalue.visible; });
    return isovalues;
}

QString accuracyText(const ShownMesh& mesh)
{
    QString text = errorText(mesh);
    return text.replace(0, 1, text.left(1).toUpper());
}

} // namespace

AnnotationContent annotationContent(const Model& model, const std::vector<Parameter>& parameters, const ViewValue& view,
                                    const ShownMesh* mesh)
{
    AnnotationContent content;
    if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) != nullptr) // else no text will be painted
        content.font = QGuiApplication::font();
    content.range = model.description().range;
    if (const Parameter* function = mainTransfer(parameters)) {
        const TransferFunction* chosen = chosenTransfer(function->id, view.appearance);
        content.transferParameter = function->id;
        content.transfer = chosen != nullptr ? *chosen : std::get<TransferFunction>(function->defaultValue);
    }
    if (hasParameter(parameters, isovaluesId))
        content.isovalues = seenOnes(view.isovalues);
    content.field = fieldName(model.description());
    content.logarithms = holdsLogarithms(model.description().parameters);
    if (content.logarithms)
        content.field = shownText(nameOfLogarithms(model.description().valueName));
    if (const std::string& space = model.description().space; space.find_first_not_of("RLAPSI") == std::string::npos)
        content.space = QString::fromStdString(space);
    content.lengthUnit = shownText(model.description().lengthUnit);
    content.title = QFileInfo(pathText(model.path())).completeBaseName();
    if (mesh != nullptr)
        content.accuracy = accuracyText(*mesh);
    content.state = view.annotations;
    content.camera = view.camera;
    content.background = view.background.value_or(content.background);
    return content;
}

AnnotationContent inView(AnnotationContent content, const ViewValue& view, const ShownMesh& mesh)
{
    content.camera = view.camera;
    if (const TransferFunction* chosen = chosenTransfer(content.transferParameter, view.appearance);
        content.transfer && chosen != nullptr)
        content.transfer = *chosen;
    if (content.isovalues)
        content.isovalues = seenOnes(view.isovalues);
    content.accuracy = accuracyText(mesh);
    return content;
}

} // namespace tetra
