// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/shown_mesh.h"

#include "plugins/widgets/number_text.h"

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
    if (mesh.query.range)
        return MeshText::tr("errors from %1 to %2")
            .arg(percentText(std::min(mesh.query.range->one.error, mesh.query.range->other.error)),
                 percentText(std::max(mesh.query.range->one.error, mesh.query.range->other.error)));
    if (const SpaceRamp* ramp = mesh.query.error.asSpaceRamp())
        return MeshText::tr("error %1 in the focus, %2 outside")
            .arg(keptText(ramp->inner, mesh.scale), keptText(ramp->outer, mesh.scale));
    if (!mesh.query.error.isConstant())
        return MeshText::tr("error %1 to %2")
            .arg(keptText(mesh.query.error.bounds().minimum, mesh.scale),
                 keptText(mesh.query.error.bounds().maximum, mesh.scale));
    return MeshText::tr("error %1").arg(keptText(mesh.query.error.bounds().maximum, mesh.scale));
}

QString piecesText(const ShownMesh& mesh)
{
    if (mesh.tetrahedra == mesh.keptTetrahedra)
        return {};
    return MeshText::tr("%1 tetrahedra in %2 pieces, as the window cuts them")
        .arg(countText(mesh.keptTetrahedra), countText(mesh.tetrahedra));
}

QString meshText(const ShownMesh& mesh, const Model& model)
{
    const QString errors = errorText(mesh);
    if (mesh.query.range)
        return MeshText::tr("Shown: tetrahedra of the meshes of %1. %2 of %3 are chosen.")
            .arg(errors, countText(mesh.keptTetrahedra), countText(mesh.wholeTetrahedra));
    const double warping = mesh.query.warping.bounds().maximum;
    const bool warps = model.description().warpingWeight > 0;
    QStringList sentences{
        !warps                                   ? MeshText::tr("Shown: %1.").arg(errors)
        : mesh.query.warping == mesh.query.error ? MeshText::tr("Shown: %1, and the same warping.").arg(errors)
        : warping < anyWarping ? MeshText::tr("Shown: %1, warping %2.").arg(errors, keptText(warping, mesh.scale))
                               : MeshText::tr("Shown: %1, whatever the warping.").arg(errors)};
    sentences << limitText(mesh) << partText(mesh);
    sentences.removeAll(QString());
    return sentences.join(' ');
}

} // namespace tetra
