// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// What was changed to make a sound mesh of cells as they came.
struct Repairs {
    std::uint64_t flatShapes = 0;   ///< vertices, lines and polygons, left out
    std::uint64_t blanked = 0;      ///< cells that the file hides
    std::uint64_t notFinite = 0;    ///< cells without a finite value
    std::uint64_t repeated = 0;     ///< cells with a repeated corner that have no volume
    std::uint64_t flat = 0;         ///< cells without volume
    std::uint64_t turned = 0;       ///< cells numbered the other way round
    std::uint64_t cells = 0;        ///< that were left
    std::uint64_t welded = 0;       ///< points joined with another on their place
    std::uint64_t conflicting = 0;  ///< places whose points had different values
    std::uint64_t unused = 0;       ///< points of no cell
    std::uint64_t middles = 0;      ///< nodes in the middle of edges and faces that were not used
    std::uint64_t resplit = 0;      ///< cells with other diagonals than the rule's
    std::uint64_t warped = 0;       ///< cells that have no cut, left out
    std::uint64_t polyhedra = 0;    ///< that were cut
    std::uint64_t centres = 0;      ///< polyhedra that got a point in the middle
    std::uint64_t uncut = 0;        ///< polyhedra that have no cut, left out
    bool centresTried = false;      ///< also with a point in the middle
    std::uint64_t open = 0;         ///< polyhedra whose faces do not close, left out
    std::uint64_t duplicates = 0;   ///< tetrahedra that were there twice
    bool cellValues = false;        ///< brought to the points
    bool ofGrid = false;            ///< whose axes may run backwards: then all cells are numbered so
    std::vector<FaultyCell> faulty; ///< of the complex, in any order
};

/// In sentences for the user; what did not happen is not said.
TAN_INTERNAL std::vector<Message> repairRemarks(const Repairs& repairs);

/// irregularDataset() of a complex without the cells that `holes` counts.
Result<Dataset> irregularDatasetBeside(const Repairs& holes, const CellComplex& complex, const ComplexValues& values,
                                       const Source& source, const Progress& progress);

/// For each point, the first of those on exactly its place (so its own number if it is the first, or alone); only
/// points with `used`, which are finite, count, the others get their own. O(points); fewer than 2^32 - 1 points.
std::vector<std::uint32_t> firstOnPlace(std::span<const Eigen::Vector3d> positions, const std::vector<bool>& used);

/// Cells whose numbers are sound and few kinds: voxels are hexahedra, triquadratic cells eight of them, what has no
/// value, no volume or no place in the domain is gone.
struct CleanCells {
    std::vector<CellShape> shapes;
    std::vector<std::uint64_t> offsets{0}; ///< the nodes of cell c are nodes[offsets[c]] up to nodes[offsets[c + 1]]
    std::vector<std::uint32_t> nodes;      ///< of a polyhedron its points, each once, ascending
    /// The faces of cell c, if it is a polyhedron, are faces[faceOffsets[c]] up to faces[faceOffsets[c + 1]]: of each
    /// the number of its points, three at least, then these.
    std::vector<std::uint64_t> faceOffsets{0};
    std::vector<std::uint32_t> faces;
    std::vector<std::uint64_t> origins; ///< the cell of the complex that each comes from

    std::size_t count() const { return shapes.size(); }
    std::span<const std::uint32_t> nodesOf(std::size_t cell) const
    {
        return std::span(nodes).subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
    }
    std::span<const std::uint32_t> facesOf(std::size_t cell) const
    {
        return std::span(faces).subspan(faceOffsets[cell], faceOffsets[cell + 1] - faceOffsets[cell]);
    }
};

/// The points of a cell of the complex, in its order; those of a polyhedron as often as its faces have them, for which
/// `memory` is. Nothing if such faces are not whole.
std::optional<std::span<const std::uint64_t>> pointsOf(const CellComplex& complex, std::size_t cell,
                                                       std::vector<std::uint64_t>& memory);

/// Sorts out what irregularDataset() cannot use and joins points on one place. `repairs` is told. Errors: BadInput for
/// arrays that do not fit together, numbers of points out of range, points of cells at places that are not finite;
/// OutOfResource for more points than 32 bits number.
Result<CleanCells> cleanCells(const CellComplex& complex, const ComplexValues& values, Repairs& repairs);

/// Leaves out the nodes in the middle of edges where cells do not agree on them: all of them, so that the mesh
/// conforms. Returns whether there were such cells.
bool dropMiddlesIfMixed(CleanCells& cells, Repairs& repairs);
/// Makes all cells linear.
void dropMiddles(CleanCells& cells, Repairs& repairs);

} // namespace tetra
