// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/queried_mesh.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace tetra {

void tellEmptySurfaces(std::span<const double> isovalues, const ValueRange& range, Outcome& outcome)
{
    QJsonArray remarks;
    for (const double isovalue : isovalues)
        if (isovalue < range.minimum || isovalue > range.maximum) {
            const std::string remark = "The surface of " + formatNumber(isovalue) + " is empty: the data lie between " +
                                       formatNumber(range.minimum) + " and " + formatNumber(range.maximum) + ".";
            outcome.text += remark + "\n";
            remarks.append(QString::fromStdString(remark));
        }
    if (!remarks.isEmpty())
        outcome.figures["remarks"] = remarks;
}

QJsonObject figuresOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(meshFigures(model, query, mesh))).object();
}

} // namespace tetra
