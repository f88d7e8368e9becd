// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/mesh_vertices.h"

#include "core/model/findings.h"
#include "core/model/scattered_cells.h"
#include "core/model/verify_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

Eigen::Vector3f floatPosition(const Dataset& original, std::uint64_t point)
{
    return original.position(point).cast<float>();
}

/// Finds the point of a dataset that lies at a position, and nothing where there are several or none.
class PointFinder {
public:
    explicit PointFinder(const Dataset& original) : original_(original) {}

    std::optional<std::uint32_t> at(const Eigen::Vector3f& position)
    {
        if (!position.allFinite())
            return {};
        return original_.positions ? amongPositions(position) : onLattice(position);
    }

private:
    std::optional<std::uint32_t> onLattice(const Eigen::Vector3f& position) const
    {
        const Lattice& lattice = original_.lattice;
        std::array<std::uint32_t, 3> place{};
        for (int axis = 0; axis < 3; ++axis) {
            const double last = lattice.size[static_cast<std::size_t>(axis)] - 1.0;
            const auto coordinate = static_cast<double>(position[axis]);
            const double middle = std::round((coordinate - lattice.origin[axis]) / lattice.spacing[axis]);
            int found = 0;
            for (const double number : {middle - 1, middle, middle + 1}) {
                if (number < 0 || number > last ||
                    static_cast<float>(lattice.origin[axis] + lattice.spacing[axis] * number) != position[axis])
                    continue;
                place[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(number);
                ++found;
            }
            if (found != 1)
                return {};
        }
        return static_cast<std::uint32_t>(lattice.index(place[0], place[1], place[2]));
    }

    std::optional<std::uint32_t> amongPositions(const Eigen::Vector3f& position)
    {
        const auto less = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
            return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        };
        const auto placeOf = [this](std::uint32_t point) { return floatPosition(original_, point); };
        if (inOrder_.empty()) {
            inOrder_.resize(original_.pointCount());
            std::iota(inOrder_.begin(), inOrder_.end(), 0U);
            std::ranges::sort(inOrder_, less, placeOf);
        }
        const auto found = std::ranges::equal_range(inOrder_, position, less, placeOf);
        return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
    }

    const Dataset& original_;
    std::vector<std::uint32_t> inOrder_; ///< of positions; made when it is needed
};

class VertexCheck {
public:
    VertexCheck(const Model& model, const Dataset& original, const ExtractedMesh& mesh)
        : model_(model), original_(original), mesh_(mesh), finder_(original), taken_(original.pointCount())
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
        const Eigen::Vector3f& position = mesh_.mesh.positions[vertex];
        std::optional<std::uint32_t> point;
        if (site == ExtractedMesh::noSite)
            point = finder_.at(position);
        else if (site < model_.siteCount() && model_.points()[site] < original_.pointCount() &&
                 floatPosition(original_, model_.points()[site]) == position)
            point = model_.points()[site];
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
    PointFinder finder_;
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
