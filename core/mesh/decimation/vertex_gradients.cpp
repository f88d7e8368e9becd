// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/vertex_gradients.h"

#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace tetra {

Eigen::Vector3d vertexGradient(const CollapsibleMesh& mesh, std::span<const Eigen::Vector3d> positions,
                               std::span<const double> values, std::uint32_t vertex)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double angles = 0;
    for (const std::uint32_t slot : mesh.star(vertex)) {
        const auto& vertices = mesh.vertices(slot);
        const auto& others = cornersOfFace[indexOf(vertices, vertex)];
        Eigen::Matrix3d edges;
        Eigen::Vector3d steps;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t other = vertices[others[static_cast<std::size_t>(i)]];
            edges.row(i) = positions[other] - positions[vertex];
            steps[i] = values[other] - values[vertex];
        }
        const Eigen::Vector3d a = edges.row(0), b = edges.row(1), c = edges.row(2);
        const double angle =
            2 * std::atan2(std::abs(edges.determinant()), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                              a.dot(c) * b.norm() + b.dot(c) * a.norm());
        sum += angle * (edges.inverse() * steps);
        angles += angle;
    }
    return angles > 0 ? Eigen::Vector3d(sum / angles) : sum;
}

double distanceFromBoundaryPlane(const CollapsibleMesh& mesh, std::span<const Eigen::Vector3d> positions,
                                 std::uint32_t vertex)
{
    std::vector<std::uint32_t> around;
    for (const std::uint32_t slot : mesh.star(vertex))
        for (const std::uint32_t neighbour : mesh.neighbours(slot)) {
            if (!CollapsibleMesh::isTriangle(neighbour))
                continue;
            const auto corners = mesh.cornersOf(neighbour);
            if (std::ranges::find(corners, vertex) != corners.end())
                std::ranges::copy_if(corners, std::back_inserter(around), [vertex](auto c) { return c != vertex; });
        }
    std::ranges::sort(around);
    around.erase(std::ranges::unique(around).begin(), around.end());
    if (around.empty())
        return 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::uint32_t other : around)
        middle += positions[other];
    middle /= static_cast<double>(around.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::uint32_t other : around)
        spread += (positions[other] - middle) * (positions[other] - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    return std::abs(axes.eigenvectors().col(0).dot(positions[vertex] - middle));
}

} // namespace tetra
