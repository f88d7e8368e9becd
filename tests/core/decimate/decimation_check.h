// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/orientation.h"

#include "tests/core/decimate/test_meshes.h"
#include "tests/core/refine/recorded_history.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tetra {

/// The mesh of a history's first sites, in the numbers of the input's points.
struct MeshOfPrefix {
    TestTetrahedra tetrahedra;
    std::vector<const RecordedHistory::Tetrahedron*> claims;

    MeshOfPrefix(const RecordedHistory& history, std::size_t sites)
    {
        for (const RecordedHistory::Tetrahedron& tetrahedron : history.tetrahedra) {
            if (!history.alive(tetrahedron, sites))
                continue;
            claims.push_back(&tetrahedron);
            auto& vertices = tetrahedra.emplace_back();
            for (std::size_t i = 0; i < 4; ++i)
                vertices[i] = static_cast<std::uint32_t>(history.points[tetrahedron.sites[i]]);
        }
    }
};

/// Checks every point of the input against a prefix's claims, point by point and tetrahedron by tetrahedron.
class ClaimCheck {
public:
    ClaimCheck(const TestMesh& mesh, const MeshOfPrefix& prefix, const TetrahedraTopology& topology)
        : mesh_(mesh), prefix_(prefix), topology_(topology)
    {
    }

    std::string invertedFault() const
    {
        for (const auto& t : prefix_.tetrahedra)
            if (orientationSign(at(t[0]), at(t[1]), at(t[2]), at(t[3])) <= 0)
                return "a tetrahedron is not positive";
        return {};
    }

    /// Whether a tetrahedron that has the point, or the largest claim of all for points outside, bounds its error and,
    /// in a mesh with physical places, its warping.
    std::string errorFault(std::uint32_t point) const
    {
        const double weight = mesh_.weights.empty() ? 1 : static_cast<double>(mesh_.weights[point]);
        bool inside = false;
        for (std::size_t i = 0; i < prefix_.tetrahedra.size(); ++i) {
            const auto& t = prefix_.tetrahedra[i];
            const Eigen::Vector4d weights = weightsIn(t, mesh_.positions[point]);
            if (weights.minCoeff() < -1e-9)
                continue;
            inside = true;
            double value = 0;
            Eigen::Vector3d place = Eigen::Vector3d::Zero();
            for (std::size_t k = 0; k < 4; ++k) {
                value += weights[static_cast<int>(k)] * mesh_.values[t[k]];
                if (!mesh_.physical.empty())
                    place += weights[static_cast<int>(k)] * mesh_.physical[t[k]];
            }
            const bool near = weight * std::abs(value - mesh_.values[point]) <= double(prefix_.claims[i]->error) + 1e-9;
            const bool unwarped = mesh_.physical.empty() || weight * (place - mesh_.physical[point]).norm() <=
                                                                double(prefix_.claims[i]->warping) + 1e-9;
            if (near && unwarped)
                return {};
        }
        if (inside)
            return "point " + std::to_string(point) + " is farther off than its tetrahedra claim";
        return {};
    }

    /// Of a point outside: whether there is a boundary triangle within the claimed warping, at whose nearest place the
    /// claim bounds its error.
    std::string outsideFault(std::uint32_t point) const
    {
        for (const auto& t : prefix_.tetrahedra)
            if (weightsIn(t, mesh_.positions[point]).minCoeff() >= -1e-9)
                return {};
        const double weight = mesh_.weights.empty() ? 1 : static_cast<double>(mesh_.weights[point]);
        bool borne = false;
        visitNearest(mesh_.positions[point], [&](double distance, double value) {
            borne |= weight * distance <= largestWarping() + 1e-9 &&
                     weight * std::abs(value - mesh_.values[point]) <= largestError() + 1e-9;
        });
        return borne ? "" : "point " + std::to_string(point) + " outside has a larger error than is claimed";
    }

    /// Of a point of the original boundary.
    std::string warpingFault(std::uint32_t point) const
    {
        const double weight = mesh_.weights.empty() ? 1 : static_cast<double>(mesh_.weights[point]);
        if (weight * distanceFrom(mesh_.positions[point]) > largestWarping() + 1e-9)
            return "point " + std::to_string(point) + " of the boundary is farther off than is claimed";
        return {};
    }

    double largestError() const
    {
        double largest = 0;
        for (const auto* claim : prefix_.claims)
            largest = std::max(largest, static_cast<double>(claim->error));
        return largest;
    }
    double largestWarping() const
    {
        double largest = 0;
        for (const auto* claim : prefix_.claims)
            largest = std::max(largest, static_cast<double>(claim->warping));
        return largest;
    }

private:
    std::array<double, 3> at(std::uint32_t vertex) const
    {
        const Eigen::Vector3d& position = mesh_.positions[vertex];
        return {position.x(), position.y(), position.z()};
    }

    Eigen::Vector4d weightsIn(const std::array<std::uint32_t, 4>& t, const Eigen::Vector3d& place) const
    {
        Eigen::Matrix3d edges;
        for (std::size_t i = 0; i < 3; ++i)
            edges.col(static_cast<int>(i)) = mesh_.positions[t[i + 1]] - mesh_.positions[t[0]];
        const Eigen::Vector3d rest = edges.inverse() * (place - mesh_.positions[t[0]]);
        return {1 - rest.sum(), rest[0], rest[1], rest[2]};
    }

    double distanceFrom(const Eigen::Vector3d& place) const
    {
        double least = std::numeric_limits<double>::infinity();
        visitNearest(place, [&least](double distance, double) { least = std::min(least, distance); });
        return least;
    }

    /// Calls visit(distance, value) for the nearest place of each boundary triangle, and for some of their others: the
    /// feet on their planes and edges.
    template <class Visit> void visitNearest(const Eigen::Vector3d& place, Visit&& visit) const
    {
        for (const auto& triangle : topology_.boundary) {
            const Eigen::Vector3d a = mesh_.positions[triangle[0]];
            const Eigen::Vector3d u = mesh_.positions[triangle[1]] - a, v = mesh_.positions[triangle[2]] - a;
            Eigen::Matrix2d gram;
            gram << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
            const Eigen::Vector2d st = gram.inverse() * Eigen::Vector2d(u.dot(place - a), v.dot(place - a));
            if (st.minCoeff() >= 0 && st.sum() <= 1)
                visit((a + st[0] * u + st[1] * v - place).norm(), (1 - st.sum()) * mesh_.values[triangle[0]] +
                                                                      st[0] * mesh_.values[triangle[1]] +
                                                                      st[1] * mesh_.values[triangle[2]]);
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
                const Eigen::Vector3d along = mesh_.positions[to] - mesh_.positions[from];
                const double t = std::clamp(along.dot(place - mesh_.positions[from]) / along.squaredNorm(), 0.0, 1.0);
                visit((mesh_.positions[from] + t * along - place).norm(),
                      (1 - t) * mesh_.values[from] + t * mesh_.values[to]);
            }
        }
    }

    const TestMesh& mesh_;
    const MeshOfPrefix& prefix_;
    const TetrahedraTopology& topology_;
};

/// The first thing that is wrong with the mesh of the first `sites` sites; empty if nothing is.
inline std::string prefixFault(const TestMesh& mesh, const RecordedHistory& history, std::size_t sites,
                               const TetrahedraTopology& original)
{
    const MeshOfPrefix prefix(history, sites);
    const TetrahedraTopology topology = topologyOf(prefix.tetrahedra);
    if (!topology.fault.empty())
        return topology.fault;
    if (!(topology == original))
        return "the mesh has another topology than the input";
    const ClaimCheck check(mesh, prefix, topology);
    if (std::string fault = check.invertedFault(); !fault.empty())
        return fault;
    for (std::uint32_t point = 0; point < mesh.positions.size(); ++point) {
        if (std::string fault = check.errorFault(point); !fault.empty())
            return fault;
        if (std::string fault = mesh.box ? "" : check.outsideFault(point); !fault.empty())
            return fault;
    }
    if (mesh.box)
        return {};
    for (const auto& triangle : original.boundary)
        for (const std::uint32_t point : triangle)
            if (std::string fault = check.warpingFault(point); !fault.empty())
                return fault;
    return {};
}

} // namespace tetra
