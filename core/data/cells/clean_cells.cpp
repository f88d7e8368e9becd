// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/clean_cells.h"

#include "core/base/flat_index.h"
#include "core/data/cells/cell_complex.h"
#include "core/mesh/topology.h"

#include <tan/data.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

namespace tetra {

namespace {

class Remarks {
public:
    /// "3 cells were left out: ..." or "1 cell was left out: ..."
    void add(std::uint64_t count, std::string_view one, std::string_view several, std::string_view rest)
    {
        if (count > 0)
            sentences.push_back(std::to_string(count) + " " + std::string(count == 1 ? one : several) +
                                std::string(rest));
    }
    std::vector<std::string> sentences;
};

} // namespace

std::vector<std::string> repairRemarks(const Repairs& repairs)
{
    Remarks remarks;
    if (repairs.cellValues)
        remarks.sentences.emplace_back("The values belong to cells: each point got the mean of the cells around it.");
    remarks.add(repairs.flatShapes, "cell is", "cells are",
                " a vertex, line or polygon without volume and not part of the mesh.");
    remarks.add(repairs.blanked, "cell is", "cells are", " blanked out in the file: a hole.");
    remarks.add(repairs.notFinite, "cell has", "cells have", " a value that is not finite and became a hole.");
    remarks.add(repairs.repeated, "cell names a corner twice, has no volume and was",
                "cells name a corner twice, have no volume and were", " left out.");
    remarks.add(repairs.flat, "cell without volume was", "cells without volume were", " left out.");
    if (repairs.turned > 0 && repairs.turned == repairs.cells)
        remarks.sentences.emplace_back("All cells had inverted orientation and were corrected.");
    else
        remarks.add(repairs.turned, "cell had inverted orientation and was", "cells had inverted orientation and were",
                    " corrected.");
    remarks.add(repairs.welded, "point", "points", " on the place of another one joined with it.");
    remarks.add(repairs.conflicting, "place had", "places had", " different values and got their mean.");
    remarks.add(repairs.middles, "node in the middle of an edge or face was",
                "nodes in the middle of edges and faces were",
                " left out: not all cells there have them, or cells bend too much.");
    remarks.add(repairs.resplit, "cell was", "cells were",
                " cut along other diagonals, because the faces are not flat.");
    remarks.add(repairs.warped, "cell was", "cells were",
                " left out: too warped to be cut into tetrahedra without a new point.");
    remarks.add(repairs.duplicates, "tetrahedron was", "tetrahedra were", " there twice.");
    remarks.add(repairs.pinching, "tetrahedron was", "tetrahedra were",
                " left out where parts of the mesh touched in an edge or a point only.");
    remarks.add(repairs.unused, "point is", "points are", " of no cell: left out.");
    return std::move(remarks.sentences);
}

namespace {

/// Of points by their places.
struct PlaceHash {
    std::span<const Eigen::Vector3d> positions;
    std::uint64_t operator()(std::uint32_t point) const
    {
        std::uint64_t hash = 0;
        for (const double coordinate : positions[point]) {
            hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0); // -0 and 0 are the same place
            hash *= 0x9e3779b97f4a7c15;
            hash ^= hash >> 32;
        }
        return hash * 0xbf58476d1ce4e5b9;
    }
};

struct SamePlace {
    std::span<const Eigen::Vector3d> positions;
    bool operator()(std::uint32_t one, std::uint32_t other) const { return positions[one] == positions[other]; }
};

} // namespace

std::vector<std::uint32_t> firstOnPlace(std::span<const Eigen::Vector3d> positions, const std::vector<bool>& used)
{
    std::vector<std::uint32_t> first(positions.size());
    FlatIndex<std::uint32_t, PlaceHash, SamePlace> places({positions}, {positions}); // by the first point on each
    places.clear(positions.size());
    for (std::uint32_t point = 0; point < positions.size(); ++point)
        first[point] = used[point] ? places.keys()[places.numberOf(point)] : point;
    return first;
}

namespace {

Error badCells(std::string text)
{
    return {ErrorKind::BadInput, std::move(text)};
}

std::span<const std::uint64_t> cornersOf(const CellComplex& complex, std::size_t cell)
{
    return std::span(complex.corners).subspan(complex.offsets[cell], complex.offsets[cell + 1] - complex.offsets[cell]);
}

Status checkArrays(const CellComplex& complex, const ComplexValues& values)
{
    const std::size_t cells = complex.shapes.size();
    if (cells == 0 || complex.positions.empty())
        return badCells("The mesh has no cells or no points.");
    if (complex.positions.size() >= std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource,
                     Message::say("The mesh has %1 points; at most 4294967294 can be numbered. Take a part of it.",
                                  complex.positions.size())};
    if (complex.offsets.size() != cells + 1 || complex.offsets.front() != 0 ||
        complex.offsets.back() != complex.corners.size() || !std::ranges::is_sorted(complex.offsets))
        return badCells("The cells' lists of corners do not fit together: their offsets do not rise from 0 to the "
                        "number of corners.");
    if (!complex.blanked.empty() && complex.blanked.size() != cells)
        return badCells("The mesh has " + std::to_string(cells) + " cells, but says of " +
                        std::to_string(complex.blanked.size()) + " whether they are blanked out.");
    const std::size_t wanted = values.perCell ? cells : complex.positions.size();
    if (values.values.size() != wanted)
        return badCells("The mesh has " + std::to_string(wanted) + (values.perCell ? " cells" : " points") + ", but " +
                        std::to_string(values.values.size()) + " values.");
    return {};
}

/// One that counts the cells that cannot be used, and names the first.
class Refusals {
public:
    void add(std::size_t cell)
    {
        if (count_++ == 0)
            first_ = cell;
    }
    bool any() const { return count_ > 0; }
    std::string text(std::string_view what) const
    {
        return std::to_string(count_) + (count_ == 1 ? " cell " : " cells ") + std::string(what) +
               ", the first is cell " + std::to_string(first_) + ". ";
    }

private:
    std::uint64_t count_ = 0;
    std::size_t first_ = 0;
};

bool hasValue(const CellComplex& complex, const ComplexValues& values, std::size_t cell)
{
    if (values.perCell)
        return std::isfinite(values.values[cell]);
    return std::ranges::all_of(cornersOf(complex, cell),
                               [&](std::uint64_t point) { return std::isfinite(values.values[point]); });
}

/// The eight corners of the parts of a triquadratic hexahedron among its nodes on a grid of 3 x 3 x 3, x fastest.
constexpr std::array<std::uint8_t, 27> triquadraticGrid = {0,  8,  1,  11, 24, 9,  3, 10, 2,  16, 22, 17, 20, 26,
                                                           21, 19, 23, 18, 4,  12, 5, 15, 25, 13, 7,  14, 6};

class Preparing {
public:
    Preparing(const CellComplex& complex, const ComplexValues& values, Repairs& repairs)
        : complex_(complex), values_(values), repairs_(repairs)
    {
    }

    Result<CleanCells> run()
    {
        if (const Status sound = choose(); !sound)
            return sound.error();
        const std::vector<std::uint32_t> first = weld();
        const auto isTriquadratic = [&](std::size_t cell) {
            return complex_.shapes[cell] == CellShape::TriquadraticHexahedron;
        };
        // Other cells have no nodes in the middle of faces to agree with.
        allTriquadratic_ = std::ranges::all_of(chosen_, isTriquadratic);
        for (const std::size_t cell : chosen_)
            add(cell, first);
        return std::move(cells_);
    }

private:
    Status choose()
    {
        Refusals polyhedra, counts, range, places;
        for (std::size_t cell = 0; cell < complex_.shapes.size(); ++cell) {
            const CellShape shape = complex_.shapes[cell];
            const auto corners = cornersOf(complex_, cell);
            if (!complex_.blanked.empty() && complex_.blanked[cell] != 0)
                ++repairs_.blanked;
            else if (shape == CellShape::Flat)
                ++repairs_.flatShapes;
            else if (shape == CellShape::Polyhedron)
                polyhedra.add(cell);
            else if (corners.size() != nodeCount(shape))
                counts.add(cell);
            else if (std::ranges::any_of(corners, [&](std::uint64_t p) { return p >= complex_.positions.size(); }))
                range.add(cell);
            else if (!hasValue(complex_, values_, cell))
                ++repairs_.notFinite;
            else if (!std::ranges::all_of(corners, [&](std::uint64_t p) { return complex_.positions[p].allFinite(); }))
                places.add(cell);
            else
                chosen_.push_back(cell);
        }
        if (range.any())
            return badCells(range.text("name points that do not exist") + "The mesh has " +
                            std::to_string(complex_.positions.size()) + " points, the file is damaged.");
        if (counts.any())
            return badCells(counts.text("have another number of corners than their shape") + "The file is damaged.");
        if (polyhedra.any())
            return badCells(polyhedra.text("are polyhedra with any number of faces") +
                            "Cut them into tetrahedra first (in ParaView the filter Tetrahedralize).");
        if (places.any())
            return badCells(places.text("have a corner whose place is not finite") +
                            "Correct the points, or blank the cells.");
        if (chosen_.empty())
            return badCells("No cell of the mesh has a volume and finite values: nothing is left.");
        return {};
    }

    std::vector<std::uint32_t> weld()
    {
        std::vector<bool> used(complex_.positions.size());
        for (const std::size_t cell : chosen_)
            for (const std::uint64_t point : cornersOf(complex_, cell))
                used[point] = true;
        std::vector<std::uint32_t> first = firstOnPlace(complex_.positions, used);
        for (std::size_t point = 0; point < first.size(); ++point)
            repairs_.welded += first[point] != point;
        return first;
    }

    void add(std::size_t cell, const std::vector<std::uint32_t>& first)
    {
        const CellShape shape = complex_.shapes[cell];
        const auto corners = cornersOf(complex_, cell);
        if (shape == CellShape::TriquadraticHexahedron) {
            if (allTriquadratic_)
                addParts(cell, corners, first);
            else
                addWithoutCentres(cell, corners, first);
            return;
        }
        cells_.shapes.push_back(shape == CellShape::Voxel ? CellShape::Hexahedron : shape);
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            cells_.nodes.push_back(first[corners[shape == CellShape::Voxel ? hexahedronCorner(i) : i]]);
        close(cell);
    }

    void addParts(std::size_t cell, std::span<const std::uint64_t> corners, const std::vector<std::uint32_t>& first)
    {
        constexpr std::uint32_t row = 3, plane = 9;
        for (std::uint32_t part = 0; part < 8; ++part) {
            const std::uint32_t origin = (part & 1) + row * (part >> 1 & 1) + plane * (part >> 2);
            cells_.shapes.push_back(CellShape::Hexahedron);
            for (std::uint32_t i = 0; i < 8; ++i) {
                const std::uint32_t voxel = hexahedronCorner(i);
                const std::uint32_t node = origin + (voxel & 1) + row * (voxel >> 1 & 1) + plane * (voxel >> 2);
                cells_.nodes.push_back(first[corners[triquadraticGrid[node]]]);
            }
            close(cell);
        }
    }

    void addWithoutCentres(std::size_t cell, std::span<const std::uint64_t> corners,
                           const std::vector<std::uint32_t>& first)
    {
        const std::uint32_t kept = nodeCount(CellShape::QuadraticHexahedron);
        cells_.shapes.push_back(CellShape::QuadraticHexahedron);
        for (const std::uint64_t point : corners.first(kept))
            cells_.nodes.push_back(first[point]);
        repairs_.middles += corners.size() - kept;
        close(cell);
    }

    void close(std::size_t cell)
    {
        cells_.offsets.push_back(cells_.nodes.size());
        cells_.origins.push_back(cell);
    }

    const CellComplex& complex_;
    const ComplexValues& values_;
    Repairs& repairs_;
    std::vector<std::size_t> chosen_;
    bool allTriquadratic_ = false;
    CleanCells cells_;
};

/// The shape with the same corners and straight edges.
CellShape withoutMiddles(CellShape shape)
{
    switch (shape) {
    case CellShape::QuadraticTetrahedron: return CellShape::Tetrahedron;
    case CellShape::QuadraticPyramid: return CellShape::Pyramid;
    case CellShape::QuadraticPrism: return CellShape::Prism;
    case CellShape::Voxel:
    case CellShape::QuadraticHexahedron:
    case CellShape::TriquadraticHexahedron: return CellShape::Hexahedron;
    default: return shape;
    }
}

} // namespace

Result<CleanCells> cleanCells(const CellComplex& complex, const ComplexValues& values, Repairs& repairs)
{
    if (const Status fits = checkArrays(complex, values); !fits)
        return fits.error();
    return Preparing(complex, values, repairs).run();
}

void dropMiddles(CleanCells& cells, Repairs& repairs)
{
    CleanCells linear;
    linear.shapes.reserve(cells.count());
    std::vector<std::uint32_t> dropped;
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        const CellTopology& topology = cellTopology(cells.shapes[cell]);
        const auto nodes = cells.nodesOf(cell);
        linear.shapes.push_back(withoutMiddles(cells.shapes[cell]));
        linear.nodes.insert(linear.nodes.end(), nodes.begin(), nodes.begin() + topology.cornerCount);
        dropped.insert(dropped.end(), nodes.begin() + topology.cornerCount, nodes.end());
        linear.offsets.push_back(linear.nodes.size());
    }
    std::ranges::sort(dropped);
    repairs.middles += static_cast<std::uint64_t>(std::ranges::unique(dropped).begin() - dropped.begin());
    linear.origins = std::move(cells.origins);
    cells = std::move(linear);
}

bool dropMiddlesIfMixed(CleanCells& cells, Repairs& repairs)
{
    if (std::ranges::none_of(cells.shapes, isQuadratic))
        return false;
    constexpr std::uint32_t noMiddle = 0xffffffff;
    FlatIndex<EdgeKey> edges;
    std::vector<std::uint32_t> middles; // of each edge
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        const CellTopology& topology = cellTopology(cells.shapes[cell]);
        const auto nodes = cells.nodesOf(cell);
        for (std::size_t edge = 0; edge < topology.edges.size(); ++edge) {
            const auto [a, b] = topology.edges[edge];
            if (nodes[a] == nodes[b])
                continue;
            const std::uint32_t middle =
                isQuadratic(cells.shapes[cell]) ? nodes[topology.cornerCount + edge] : noMiddle;
            const std::uint32_t number = edges.numberOf(edgeKey(nodes[a], nodes[b]));
            if (number == middles.size())
                middles.push_back(middle);
            if (middles[number] != middle) {
                dropMiddles(cells, repairs);
                return true;
            }
        }
    }
    return false;
}

} // namespace tetra
