// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/queried_mesh.h"

#include "app/command_line/error_statistics.h"
#include "app/command_line/table.h"

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

std::string reachedText(const QJsonObject& figures)
{
    if (!figures.contains("reached_error"))
        return "";
    std::string text = ", with " + errorsUpTo(figures["reached_error"].toDouble(), figures);
    if (const double warping = figures["reached_warping"].toDouble(); warping > 0)
        text += (figures.contains("error_in_space") ? ", and a warping of up to " : " and a warping of up to ") +
                rounded(warping) + " %";
    return text;
}

QJsonObject figuresOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(meshFigures(model, query, mesh))).object();
}

} // namespace tetra
