// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/cells/cell_complex.h"

#include <tan/data.h>

#include <Eigen/Geometry>

#include <vector>

namespace tetra {

/// The corners of a positive cell of unit size with flat faces, and the middles of its edges if it is quadratic.
inline std::vector<Eigen::Vector3d> referenceNodes(CellShape shape)
{
    const CellTopology& topology = cellTopology(shape);
    std::vector<Eigen::Vector3d> nodes;
    switch (topology.cornerCount) {
    case 4: nodes = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}; break;
    case 5: nodes = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}}; break;
    case 6: nodes = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}}; break;
    case 8: nodes = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}; break;
    default: break;
    }
    if (isQuadratic(shape))
        for (const auto& [a, b] : topology.edges)
            nodes.push_back((nodes[a] + nodes[b]) / 2);
    if (shape == CellShape::TriquadraticHexahedron)
        nodes.insert(nodes.end(), {{0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}, {1, 1, 1}});
    return nodes;
}

/// Of the cell of referenceNodes(), times six.
inline double referenceVolume6(CellShape shape)
{
    switch (cellTopology(shape).cornerCount) {
    case 4: return 8;
    case 5: return 16;
    case 6: return 24;
    default: return 48;
    }
}

} // namespace tetra
