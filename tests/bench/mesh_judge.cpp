// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/mesh_judge.h"

#include "core/geometry/orientation.h"
#include "core/mesh/topology.h"
#include "tests/bench/box_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tetra {

namespace {

std::vector<Triangle> boundaryOf(const PlainMesh& mesh)
{
    std::vector<Triangle> faces;
    for (const auto& t : mesh.tetrahedra) {
        for (std::size_t apex = 0; apex < 4; ++apex) {
            Triangle face{t[(apex + 1) % 4], t[(apex + 2) % 4], t[(apex + 3) % 4]};
            std::ranges::sort(face);
            faces.push_back(face);
        }
    }
    std::ranges::sort(faces);
    std::vector<Triangle> boundary;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t next = i + 1;
        while (next < faces.size() && faces[next] == faces[i])
            ++next;
        if (next - i == 1)
            boundary.push_back(faces[i]);
        i = next;
    }
    return boundary;
}

template <class Cells>
std::vector<Eigen::AlignedBox3d> boxesOf(const PlainMesh& mesh, const Cells& cells, double margin)
{
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(cells.size());
    for (const auto& cell : cells) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t vertex : cell)
            box.extend(mesh.positions[vertex]);
        box.min().array() -= margin;
        box.max().array() += margin;
        boxes.push_back(box);
    }
    return boxes;
}

/// Weights of the corners of the place of a segment that is nearest to p.
std::array<double, 2> nearestOnSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p)
{
    const Eigen::Vector3d along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
    return {1 - share, share};
}

/// A place of a triangle.
struct Place {
    std::array<double, 3> weights{};
    double squaredDistance = 0;
};

Place nearestOnTriangle(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& p)
{
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double area = normal.squaredNorm();
    Place place;
    bool inside = area > 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
        place.weights[i] = area > 0 ? normal.dot((a - p).cross(b - p)) / area : 0;
        inside = inside && place.weights[i] >= 0;
    }
    if (inside) {
        const double height = normal.dot(p - corners[0]);
        place.squaredDistance = height * height / area;
        return place;
    }
    place.squaredDistance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const auto weights = nearestOnSegment(corners[i], corners[next], p);
        const double distance = (weights[0] * corners[i] + weights[1] * corners[next] - p).squaredNorm();
        if (distance >= place.squaredDistance)
            continue;
        place.weights = {};
        place.weights[i] = weights[0];
        place.weights[next] = weights[1];
        place.squaredDistance = distance;
    }
    return place;
}

class Judge {
public:
    explicit Judge(const PlainMesh& mesh, double margin)
        : mesh_(mesh), boundary_(boundaryOf(mesh)), cells_(boxesOf(mesh, mesh.tetrahedra, margin)),
          faces_(boxesOf(mesh, boundary_, 0))
    {
    }

    /// The interpolated value if a tetrahedron contains the point, of several the one that it lies deepest in.
    std::optional<double> valueInside(const Eigen::Vector3d& p) const
    {
        double deepest = -1e-9;
        std::optional<double> value;
        cells_.visitAt(p, [&](std::uint32_t number) {
            const auto& t = mesh_.tetrahedra[number];
            Eigen::Matrix3d edges;
            for (int i = 0; i < 3; ++i)
                edges.col(i) = mesh_.positions[t[std::size_t(i)]] - mesh_.positions[t[3]];
            const Eigen::Vector3d weights = edges.inverse() * (p - mesh_.positions[t[3]]);
            const double last = 1 - weights.sum();
            const double least = std::min(weights.minCoeff(), last);
            if (!(least >= deepest))
                return;
            deepest = least;
            value = last * mesh_.values[t[3]];
            for (int i = 0; i < 3; ++i)
                *value += weights[i] * mesh_.values[t[std::size_t(i)]];
        });
        return value;
    }

    struct Projection {
        double value = 0;
        double distance = 0;
    };
    Projection project(const Eigen::Vector3d& p) const
    {
        const auto placeOn = [&](std::uint32_t number) {
            const Triangle& t = boundary_[number];
            return nearestOnTriangle({mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]}, p);
        };
        const std::uint32_t nearest =
            faces_.nearest(p, [&](std::uint32_t number) { return placeOn(number).squaredDistance; });
        const Place place = placeOn(nearest);
        Projection projection{.value = 0, .distance = std::sqrt(place.squaredDistance)};
        for (std::size_t i = 0; i < 3; ++i)
            projection.value += place.weights[i] * mesh_.values[boundary_[nearest][i]];
        return projection;
    }

private:
    const PlainMesh& mesh_;
    std::vector<Triangle> boundary_;
    BoxTree cells_, faces_;
};

std::uint64_t countInverted(const PlainMesh& mesh)
{
    const auto at = [&](std::uint32_t vertex) {
        const Eigen::Vector3d& p = mesh.positions[vertex];
        return std::array<double, 3>{p.x(), p.y(), p.z()};
    };
    return static_cast<std::uint64_t>(std::ranges::count_if(
        mesh.tetrahedra, [&](const auto& t) { return orientationSign(at(t[0]), at(t[1]), at(t[2]), at(t[3])) <= 0; }));
}

} // namespace

MeshJudgement judge(const PlainMesh& original, const PlainMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : original.positions)
        box.extend(position);
    const double diagonal = box.diagonal().norm();
    const auto [low, high] = std::ranges::minmax(original.values);
    const auto [ownLow, ownHigh] = std::ranges::minmax(mesh.values);
    const double percent = (high - low) / 100;
    MeshJudgement result;
    result.inverted = countInverted(mesh);
    result.overshoot = std::max({low - ownLow, ownHigh - high, 0.0}) / percent;
    const Judge places(mesh, 1e-12 * diagonal);
    double sum = 0;
    for (std::size_t i = 0; i < original.positions.size(); ++i) {
        std::optional<double> value = places.valueInside(original.positions[i]);
        if (!value) {
            const Judge::Projection projection = places.project(original.positions[i]);
            value = projection.value;
            ++result.outside;
            result.farthestOutside = std::max(result.farthestOutside, 100 * projection.distance / diagonal);
        }
        const double error = std::abs(*value - original.values[i]) / percent;
        result.largestError = std::max(result.largestError, error);
        sum += error;
    }
    result.meanError = sum / static_cast<double>(original.positions.size());
    return result;
}

} // namespace tetra
