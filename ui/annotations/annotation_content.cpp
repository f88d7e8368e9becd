// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/annotations/annotation_content.h"

#include "ui/annotations/field_name.h"
#include "ui/session/mesh_text.h"
#include "ui/session/target_path.h"
#include "ui/session/workbench.h"

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

AnnotationContent annotationContent(Workbench& workbench, const Camera& camera, const Colour& background)
{
    AnnotationContent content;
    const Session& session = workbench.session();
    content.state = session.view().annotations();
    content.camera = camera;
    content.background = background;
    content.font = QGuiApplication::font();
    if (!session.model())
        return content;
    content.range = session.range();
    const auto parameters = workbench.matteringParameters();
    if (hasParameter<TransferFunction>(parameters))
        content.transfer = session.view().look().transfer;
    if (hasParameter<std::vector<Isovalue>>(parameters))
        content.isovalues = seenOnes(session.view().isovalues());
    if (const auto& preview = workbench.previewedFrame()) {
        if (content.transfer)
            content.transfer = preview->transfer;
        if (content.isovalues)
            content.isovalues = seenOnes(preview->isovalues);
    }
    content.field = fieldName(session.model()->description());
    content.title = QFileInfo(pathText(session.model()->path())).completeBaseName();
    if (session.shown())
        content.accuracy = accuracyText(*session.shown());
    return content;
}

AnnotationContent atFrame(AnnotationContent content, const FilmFrame& frame, const ShownMesh& mesh)
{
    content.camera = frame.camera;
    if (content.transfer)
        content.transfer = frame.transfer;
    if (content.isovalues)
        content.isovalues = seenOnes(frame.isovalues);
    content.accuracy = accuracyText(mesh);
    return content;
}

} // namespace tetra
