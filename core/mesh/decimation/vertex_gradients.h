// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/collapsible_mesh.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace tetra {

/// The gradient of the field at a vertex: the mean of the gradients of the tetrahedra around it, weighted by their
/// solid angles there (3.1.2).
Eigen::Vector3d vertexGradient(const CollapsibleMesh& mesh, std::span<const Eigen::Vector3d> positions,
                               std::span<const double> values, std::uint32_t vertex);

/// How far a boundary vertex lies from the plane that fits the boundary vertices around it best (3.1.2).
double distanceFromBoundaryPlane(const CollapsibleMesh& mesh, std::span<const Eigen::Vector3d> positions,
                                 std::uint32_t vertex);

} // namespace tetra
