// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What was changed to make a sound mesh of cells as they came.
struct Mending {
    std::uint64_t flatShapes = 0;  ///< vertices, lines and polygons, left out
    std::uint64_t blanked = 0;     ///< cells that the file hides
    std::uint64_t notFinite = 0;   ///< cells without a finite value
    std::uint64_t repeated = 0;    ///< cells with a repeated corner that have no volume
    std::uint64_t flat = 0;        ///< cells without volume
    std::uint64_t turned = 0;      ///< cells numbered the other way round
    std::uint64_t cells = 0;       ///< that were left
    std::uint64_t welded = 0;      ///< points joined with another on their place
    std::uint64_t conflicting = 0; ///< places whose points had different values
    std::uint64_t unused = 0;      ///< points of no cell
    std::uint64_t middles = 0;     ///< nodes in the middle of edges and faces that were not used
    std::uint64_t recut = 0;       ///< cells with other diagonals than the rule's
    std::uint64_t warped = 0;      ///< cells that have no cut, left out
    std::uint64_t duplicates = 0;  ///< tetrahedra that were there twice
    std::uint64_t pinching = 0;    ///< tetrahedra left out where parts touched in an edge or a point
    bool cellValues = false;       ///< brought to the points
};

/// In sentences for the user; what did not happen is not said.
std::vector<std::string> mendingRemarks(const Mending& mending);

} // namespace tetra
