// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/queried_mesh.h"

#include "app/command_line/query_options.h"
#include "app/command_line/table.h"
#include "core/history/query_words.h"
#include "core/verify/verify_mesh.h"

#include <utility>

namespace tetra {

Status checkNotEmpty(const Arguments& arguments, const Model& model, const TetrahedralMesh& mesh)
{
    if (!mesh.tetrahedra.empty())
        return {};
    const ModelDescription& data = model.description();
    const auto place = [](const Eigen::Vector3d& p) {
        return "(" + rounded(p[0], 6) + ", " + rounded(p[1], 6) + ", " + rounded(p[2], 6) + ")";
    };
    const bool window = arguments.has("window"), values = arguments.has("values");
    const std::string asked = arguments.has("births") || arguments.has("deaths") ? "has such a life there"
                              : !window                                          ? "has such values"
                              : values                                           ? "is in that window with such values"
                                                                                 : "is in that window";
    return Error{ErrorKind::WrongUsage, "No tetrahedron " + asked + ", so nothing was written. The data lie between " +
                                            place(data.bounds.min()) + " and " + place(data.bounds.max()) +
                                            ", with values from " + rangeText(data.range.minimum, data.range.maximum) +
                                            "."};
}

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
    const auto ofMesh = [](const MeshSize& size) {
        return QJsonObject{{"error", size.error},
                           {"warping", size.warping},
                           {"sites", static_cast<qint64>(size.sites)},
                           {"tetrahedra", static_cast<qint64>(size.tetrahedra)}};
    };
    if (query.range) {
        if (model.elsewhere() != nullptr) // these are known only about
            return {{"sites", static_cast<qint64>(mesh.mesh.positions.size())},
                    {"tetrahedra", static_cast<qint64>(mesh.mesh.tetrahedra.size())}};
        MeshSize coarse = meshSizeAt(model, query.range->one), fine = meshSizeAt(model, query.range->other);
        if (coarse.sites > fine.sites)
            std::swap(coarse, fine);
        return {{"sites", static_cast<qint64>(mesh.mesh.positions.size())},
                {"tetrahedra", static_cast<qint64>(mesh.mesh.tetrahedra.size())},
                {"coarse", ofMesh(coarse)},
                {"fine", ofMesh(fine)}};
    }
    const Accuracy kept = keptEverywhere(query, mesh.scale);
    const bool warps = model.description().warpingWeight > 0;
    QJsonObject figures{{"sites", static_cast<qint64>(mesh.mesh.positions.size())},
                        {"tetrahedra", static_cast<qint64>(mesh.mesh.tetrahedra.size())},
                        {"error", kept.error},
                        {"warping", warps ? kept.warping : 0},
                        {"scale", mesh.scale},
                        {"method", wordOf(methodWords, mesh.method)},
                        {"kept_sites", static_cast<qint64>(mesh.keptSites)},
                        {"kept_tetrahedra", static_cast<qint64>(mesh.keptTetrahedra)},
                        {"whole_sites", static_cast<qint64>(mesh.wholeSites)},
                        {"whole_tetrahedra", static_cast<qint64>(mesh.wholeTetrahedra)}};
    // Of a mesh of one accuracy it is known what it reaches, which may be less than what was asked for.
    if (query.error.isConstant() && query.warping.isConstant() && model.elsewhere() == nullptr) {
        const MeshSize reached = meshSizeAt(model, kept);
        figures["reached_error"] = reached.error;
        figures["reached_warping"] = warps ? reached.warping : 0;
    }
    return figures;
}

} // namespace tetra
