// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/shown_mesh_text.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/annotation_language.h"
#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace tetra {
namespace {

class MeshText {
    Q_DECLARE_TR_FUNCTIONS(MeshText)
};

/// Nothing differs by more; what is more is not worth a digit.
constexpr double mostShownNumber = 100;

QString keptText(double percent, double scale)
{
    return percentText(std::min(keptPercent(percent, scale), mostShownNumber));
}

QString limitText(const ShownMesh& mesh)
{
    // A little more is rounding.
    const bool isMore = mesh.scale > 1.001;
    if (mesh.query.budget && isMore)
        return MeshText::tr("Limited by the budget of %1 tetrahedra.").arg(countText(*mesh.query.budget));
    if (mesh.query.budget)
        return MeshText::tr("Full resolution of the model.");
    return isMore ? MeshText::tr("The model contains no finer level.") : QString();
}

QString partText(const ShownMesh& mesh)
{
    if (mesh.isBlended || (!mesh.query.window && mesh.query.values.empty()))
        return {};
    return MeshText::tr("%1 of its %2 tetrahedra are shown.")
        .arg(countText(mesh.keptTetrahedra), countText(mesh.wholeTetrahedra));
}

} // namespace

QString errorText(const ShownMesh& mesh)
{
    return translatedMessage(errorMessage(mesh, numberSigns(QLocale())));
}

std::string accuracyText(const ShownMesh& mesh)
{
    QString text = errorText(mesh);
    return text.replace(0, 1, text.left(1).toUpper()).toStdString();
}

QString errorPlaceText(ErrorMeaning meaning, const std::optional<double>& errorInSpace)
{
    if (meaning == ErrorMeaning::InGrid && errorInSpace)
        return MeshText::tr("in the grid; in space up to %1").arg(percentText(*errorInSpace));
    return translatedText(textFor(errorPlaces, meaning));
}

QString errorPromiseText(ErrorMeaning meaning, bool isMeasured)
{
    const QString promise = translatedText(textFor(errorPromises, meaning));
    const bool isAdvised = meaning == ErrorMeaning::InGrid && !isMeasured;
    return isAdvised ? promise + ' ' + translatedText(errorInSpaceAdvice) : promise;
}

QString piecesText(const ShownMesh& mesh)
{
    if (mesh.tetrahedra == mesh.keptTetrahedra)
        return {};
    return MeshText::tr("%1 tetrahedra in %2 pieces, cut by the crop box")
        .arg(countText(mesh.keptTetrahedra), countText(mesh.tetrahedra));
}

QString meshText(const ShownMesh& mesh, const Model& model)
{
    const QString errors = errorText(mesh);
    if (mesh.query.range)
        return MeshText::tr("Shown: tetrahedra of the meshes of %1. %2 of %3 are selected.")
            .arg(errors, countText(mesh.keptTetrahedra), countText(mesh.wholeTetrahedra));
    const double warping = mesh.query.warping.bounds().maximum;
    const bool warps = model.description().warpingWeight > 0;
    QStringList sentences{
        !warps                                   ? MeshText::tr("Shown: %1.").arg(errors)
        : mesh.query.warping == mesh.query.error ? MeshText::tr("Shown: %1, and the same warping.").arg(errors)
        : warping < anyWarping ? MeshText::tr("Shown: %1, warping %2.").arg(errors, keptText(warping, mesh.scale))
                               : MeshText::tr("Shown: %1, with any warping.").arg(errors)};
    sentences << limitText(mesh) << partText(mesh);
    sentences.removeAll(QString());
    return sentences.join(' ');
}

} // namespace tetra
