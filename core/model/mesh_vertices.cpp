// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/mesh_vertices.h"

#include "core/model/findings.h"
#include "core/model/scattered_cells.h"
#include "core/model/verify_parts.h"

#include <optional>

namespace tetra {

namespace {

Eigen::Vector3f floatPosition(const Dataset& original, std::uint64_t point)
{
    return original.position(point).cast<float>();
}

class VertexCheck {
public:
    VertexCheck(const Model& model, const Dataset& original, const ExtractedMesh& mesh)
        : model_(model), original_(original), mesh_(mesh), taken_(original.pointCount())
    {
    }

    std::vector<std::uint32_t> run(std::vector<std::string>& failures)
    {
        std::vector<std::uint32_t> points;
        points.reserve(mesh_.sites.size());
        for (std::uint32_t vertex = 0; vertex < mesh_.sites.size(); ++vertex)
            if (const auto point = pointOf(vertex)) {
                points.push_back(*point);
                checkPoint(vertex, *point);
            }
        noPoint_.moveTo(failures);
        wrongValue_.moveTo(failures);
        twice_.moveTo(failures);
        return points.size() == mesh_.sites.size() ? points : std::vector<std::uint32_t>();
    }

private:
    std::optional<std::uint32_t> pointOf(std::uint32_t vertex)
    {
        const std::uint32_t site = mesh_.sites[vertex];
        std::optional<std::uint32_t> point;
        if (site < model_.siteCount())
            point = model_.points()[site];
        else if (site == ExtractedMesh::noSite && vertex < mesh_.points.size())
            point = mesh_.points[vertex];
        if (point &&
            (*point >= original_.pointCount() || floatPosition(original_, *point) != mesh_.mesh.positions[vertex]))
            point.reset();
        if (!point)
            noPoint_.add(vertex, [&] {
                return name(vertex) + (site == ExtractedMesh::noSite
                                           ? " is no point of the dataset."
                                           : " does not lie where site " + std::to_string(site) + " does.");
            });
        return point;
    }

    void checkPoint(std::uint32_t vertex, std::uint32_t point)
    {
        const double sample = original_.values.at(point);
        if (mesh_.mesh.values[vertex] != static_cast<float>(sample))
            wrongValue_.add(vertex, [&] {
                return name(vertex) + " has the value " + textOf(static_cast<double>(mesh_.mesh.values[vertex])) +
                       "; the original has " + textOf(sample) + " at that point.";
            });
        if (taken_[point])
            twice_.add(vertex, [&] { return name(vertex) + " is the same point as an earlier one."; });
        taken_[point] = true;
    }

    std::string name(std::uint32_t vertex) const
    {
        return "Vertex " + std::to_string(vertex) + " at " +
               textOf(Eigen::Vector3d(mesh_.mesh.positions[vertex].cast<double>()));
    }

    const Model& model_;
    const Dataset& original_;
    const ExtractedMesh& mesh_;
    std::vector<bool> taken_;
    Findings noPoint_;
    Findings wrongValue_;
    Findings twice_;
};

} // namespace

std::vector<std::uint32_t> pointsOfVertices(const Model& model, const Dataset& original, const ExtractedMesh& mesh,
                                            std::vector<std::string>& failures)
{
    return VertexCheck(model, original, mesh).run(failures);
}

} // namespace tetra
