// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/queried_mesh.h"

#include <QJsonDocument>

#include <vector>

namespace tetra {

void tellEmptySurfaces(std::span<const double> isovalues, const ValueRange& range, Outcome& outcome)
{
    std::vector<Message> remarks;
    for (const double isovalue : isovalues)
        if (isovalue < range.minimum || isovalue > range.maximum)
            remarks.emplace_back("The surface of " + formatNumber(isovalue) + " is empty: the data lie between " +
                                 formatNumber(range.minimum) + " and " + formatNumber(range.maximum) + ".");
    addRemarks(remarks, outcome);
}

QJsonObject figuresOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(meshFigures(model, query, mesh))).object();
}

} // namespace tetra
