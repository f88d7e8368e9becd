// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/clean_cells.h"

#include "core/base/flat_index.h"
#include "core/data/cells/cell_complex.h"
#include "core/data/cells/polyhedron.h"
#include "core/mesh/topology.h"

#include <tan/data.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tetra {

MarkedText cellFaultText(CellFault fault) noexcept
{
    switch (fault) {
    case CellFault::NotFinite: return Message::marked("it has a value that is not finite");
    case CellFault::NoVolume: return Message::marked("it has no volume");
    case CellFault::Warped: return Message::marked("it is too warped to be cut into tetrahedra");
    case CellFault::Duplicate: return Message::marked("it appears twice");
    case CellFault::CrowdedFace: return Message::marked("more than two cells share one of its faces");
    case CellFault::Folded: return Message::marked("it is inverted and overlaps its neighbours");
    case CellFault::Overlap: break;
    }
    return Message::marked("it overlaps others");
}

namespace {

void addPolyhedra(const Repairs& repairs, std::vector<Message>& remarks)
{
    if (repairs.polyhedra == 1)
        remarks.push_back(repairs.centres == 0
                              ? Message::say("1 polyhedron was cut into tetrahedra.")
                              : Message::say("1 polyhedron was cut into tetrahedra around a point in its middle."));
    else if (repairs.polyhedra > 1)
        remarks.push_back(
            repairs.centres == 0
                ? Message::say("%1 polyhedra were cut into tetrahedra.", repairs.polyhedra)
                : Message::say("%1 polyhedra were cut into tetrahedra; %2 of them got a point in the middle.",
                               repairs.polyhedra, repairs.centres));
    if (repairs.uncut > 0)
        remarks.push_back(
            repairs.centresTried
                ? Message::say("Polyhedra left out because no point in them sees all of their faces: %1.",
                               repairs.uncut)
                : Message::say("Polyhedra left out because no tetrahedra between their own points fill them: %1. With "
                               "'--polyhedra centre' they get a point in the middle.",
                               repairs.uncut));
    if (repairs.open > 0)
        remarks.push_back(
            Message::say("Polyhedra left out because their faces do not enclose a volume: %1.", repairs.open));
}

} // namespace

std::vector<Message> repairRemarks(const Repairs& repairs)
{
    std::vector<Message> remarks;
    const auto add = [&](std::uint64_t count, const Message& one, const Message& several) {
        if (count > 0)
            remarks.push_back(count == 1 ? one : several);
    };
    if (repairs.cellValues)
        remarks.push_back(Message::say("The values belong to cells: each point got the mean of the cells around it."));
    add(repairs.flatShapes,
        Message::say("1 cell is a vertex, line or polygon without volume and not part of the mesh."),
        Message::say("%1 cells are vertices, lines or polygons without volume and not part of the mesh.",
                     repairs.flatShapes));
    add(repairs.blanked, Message::say("1 cell is blanked out in the file: a hole."),
        Message::say("%1 cells are blanked out in the file: holes.", repairs.blanked));
    add(repairs.notFinite, Message::say("1 cell has a value that is not finite and became a hole."),
        Message::say("%1 cells have a value that is not finite and became holes.", repairs.notFinite));
    add(repairs.repeated, Message::say("1 cell uses a corner twice, has no volume and was left out."),
        Message::say("%1 cells use a corner twice, have no volume and were left out.", repairs.repeated));
    add(repairs.flat, Message::say("1 cell without volume was left out."),
        Message::say("%1 cells without volume were left out.", repairs.flat));
    const bool areAllTurned = repairs.turned > 0 && repairs.turned == repairs.cells;
    if (areAllTurned && !repairs.ofGrid)
        remarks.push_back(Message::say("All cells had inverted orientation and were corrected."));
    else if (!areAllTurned)
        add(repairs.turned, Message::say("1 cell had inverted orientation and was corrected."),
            Message::say("%1 cells had inverted orientation and were corrected.", repairs.turned));
    add(repairs.welded, Message::say("1 point at the same place as another was merged with it."),
        Message::say("%1 points at the same place as another were merged with it.", repairs.welded));
    add(repairs.conflicting, Message::say("1 place had several different values and got their mean."),
        Message::say("%1 places had several different values and got their mean.", repairs.conflicting));
    add(repairs.middles,
        Message::say("1 node in the middle of an edge or face was left out: not all cells there have it, or the cells "
                     "bend too much."),
        Message::say("%1 nodes in the middle of edges and faces were left out: not all cells there have them, or the "
                     "cells bend too much.",
                     repairs.middles));
    add(repairs.resplit, Message::say("1 cell was cut along other diagonals, because its faces are not flat."),
        Message::say("%1 cells were cut along other diagonals, because their faces are not flat.", repairs.resplit));
    add(repairs.warped, Message::say("1 cell was left out: too warped to be cut into tetrahedra without a new point."),
        Message::say("%1 cells were left out: too warped to be cut into tetrahedra without a new point.",
                     repairs.warped));
    addPolyhedra(repairs, remarks);
    add(repairs.duplicates, Message::say("1 tetrahedron appeared twice."),
        Message::say("%1 tetrahedra appeared twice.", repairs.duplicates));
    const auto countOf = [&repairs](CellFault fault) {
        return static_cast<std::uint64_t>(std::ranges::count(repairs.faulty, fault, &FaultyCell::fault));
    };
    const std::uint64_t crowded = countOf(CellFault::CrowdedFace), folded = countOf(CellFault::Folded),
                        overlapping = countOf(CellFault::Overlap);
    add(crowded, Message::say("1 cell was left out: more than two cells share one of its faces."),
        Message::say("%1 cells were left out: more than two cells share one of their faces.", crowded));
    add(folded, Message::say("1 cell was left out: it is inverted and overlaps its neighbours."),
        Message::say("%1 cells were left out: they are inverted and overlap their neighbours.", folded));
    add(overlapping, Message::say("1 cell was left out: it overlaps others."),
        Message::say("%1 cells were left out: they overlap others.", overlapping));
    add(repairs.unused, Message::say("1 point belongs to no cell with a volume and was left out."),
        Message::say("%1 points belong to no cell with a volume and were left out.", repairs.unused));
    return remarks;
}

namespace {

/// Hashes points by their positions.
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
        first[point] = used[point] ? places.firstLike(point) : point;
    return first;
}

namespace {

Error badCells(Message text)
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
        return badCells(Message::say("The mesh has no cells or no points."));
    if (!(complex.mostFaulty >= 0 && complex.mostFaulty <= 1))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The share of cells that may be faulty is %1; it must be from 0 to 1.",
                                  formatNumber(complex.mostFaulty))};
    if (complex.positions.size() >= std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource,
                     Message::say("The mesh has %1 points; at most 4294967294 can be numbered. Take a part of it.",
                                  complex.positions.size())};
    if (complex.offsets.size() != cells + 1 || complex.offsets.front() != 0 ||
        complex.offsets.back() != complex.corners.size() || !std::ranges::is_sorted(complex.offsets))
        return badCells(Message::say("The cells' lists of corners are inconsistent: their offsets do not rise from 0 "
                                     "to the number of corners."));
    if (!complex.blanked.empty() && complex.blanked.size() != cells)
        return badCells(
            Message::say("The mesh has %1 cells, but blanking flags for %2.", cells, complex.blanked.size()));
    const std::size_t wanted = values.perCell ? cells : complex.positions.size();
    if (values.values.size() != wanted)
        return badCells(values.perCell
                            ? Message::say("The mesh has %1 cells, but %2 values.", wanted, values.values.size())
                            : Message::say("The mesh has %1 points, but %2 values.", wanted, values.values.size()));
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
    std::uint64_t count() const { return count_; }
    std::size_t first() const { return first_; }

private:
    std::uint64_t count_ = 0;
    std::size_t first_ = 0;
};

bool hasValue(const ComplexValues& values, std::size_t cell, std::span<const std::uint64_t> points)
{
    if (values.perCell)
        return std::isfinite(values.values[cell]);
    return std::ranges::all_of(points, [&](std::uint64_t point) { return std::isfinite(values.values[point]); });
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
        Refusals faces, counts, range, places;
        for (std::size_t cell = 0; cell < complex_.shapes.size(); ++cell) {
            const CellShape shape = complex_.shapes[cell];
            const auto points = pointsOf(complex_, cell, points_);
            if (!complex_.blanked.empty() && complex_.blanked[cell] != 0)
                ++repairs_.blanked;
            else if (shape == CellShape::Flat)
                ++repairs_.flatShapes;
            else if (!points)
                faces.add(cell);
            else if (shape != CellShape::Polyhedron && points->size() != nodeCount(shape))
                counts.add(cell);
            else if (std::ranges::any_of(*points, [&](std::uint64_t p) { return p >= complex_.positions.size(); }))
                range.add(cell);
            else if (!hasValue(values_, cell, *points)) {
                ++repairs_.notFinite;
                repairs_.faulty.push_back({cell, CellFault::NotFinite});
            } else if (!std::ranges::all_of(*points,
                                            [&](std::uint64_t p) { return isUsablePlace(complex_.positions[p]); }))
                places.add(cell);
            else
                chosen_.push_back(cell);
        }
        if (range.count() > 0)
            return badCells(Message::say("Cells refer to points that do not exist (%1 in all, the first is cell %2). "
                                         "The mesh has %3 points: the file is damaged.",
                                         range.count(), range.first(), complex_.positions.size()));
        if (counts.count() > 0)
            return badCells(Message::say("Cells do not have the number of corners of their shape (%1 in all, the first "
                                         "is cell %2). The file is damaged.",
                                         counts.count(), counts.first()));
        if (faces.count() > 0)
            return badCells(Message::say("Faces of polyhedra have more points than are listed (%1 in all, the first is "
                                         "of cell %2). The file is damaged.",
                                         faces.count(), faces.first()));
        if (places.count() > 0)
            return badCells(Message::say("Cells have a corner whose position is not finite, or too large to compute "
                                         "with (%1 in all, the first is cell %2). Correct the points, or blank the "
                                         "cells.",
                                         places.count(), places.first()));
        if (chosen_.empty())
            return badCells(Message::say("No cell of the mesh has a volume and finite values: nothing is left."));
        return {};
    }

    std::vector<std::uint32_t> weld()
    {
        std::vector<bool> used(complex_.positions.size());
        for (const std::size_t cell : chosen_) {
            const auto points = pointsOf(complex_, cell, points_);
            for (const std::uint64_t point : *points)
                used[point] = true;
        }
        std::vector<std::uint32_t> first = firstOnPlace(complex_.positions, used);
        for (std::size_t point = 0; point < first.size(); ++point)
            repairs_.welded += first[point] != point;
        return first;
    }

    void add(std::size_t cell, const std::vector<std::uint32_t>& first)
    {
        const CellShape shape = complex_.shapes[cell];
        const auto corners = cornersOf(complex_, cell);
        if (shape == CellShape::Polyhedron) {
            addPolyhedron(cell, corners, first);
            return;
        }
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

    /// Edges whose ends lie on one place are none, and faces without three points either.
    void addPolyhedron(std::size_t cell, std::span<const std::uint64_t> faces, const std::vector<std::uint32_t>& first)
    {
        std::vector<std::uint32_t> face;
        (void)forFaces(faces, [&](std::span<const std::uint64_t> points) {
            face.clear();
            for (const std::uint64_t point : points)
                if (face.empty() || face.back() != first[point])
                    face.push_back(first[point]);
            while (face.size() > 1 && face.front() == face.back())
                face.pop_back();
            if (face.size() < 3)
                return;
            cells_.faces.push_back(static_cast<std::uint32_t>(face.size()));
            cells_.faces.insert(cells_.faces.end(), face.begin(), face.end());
            cells_.nodes.insert(cells_.nodes.end(), face.begin(), face.end());
        });
        const auto begin = cells_.nodes.begin() + static_cast<std::ptrdiff_t>(cells_.offsets.back());
        std::sort(begin, cells_.nodes.end());
        cells_.nodes.erase(std::unique(begin, cells_.nodes.end()), cells_.nodes.end());
        cells_.shapes.push_back(CellShape::Polyhedron);
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
        cells_.faceOffsets.push_back(cells_.faces.size());
        cells_.origins.push_back(cell);
    }

    const CellComplex& complex_;
    const ComplexValues& values_;
    Repairs& repairs_;
    std::vector<std::size_t> chosen_;
    std::vector<std::uint64_t> points_; ///< of one polyhedron
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

std::optional<std::span<const std::uint64_t>> pointsOf(const CellComplex& complex, std::size_t cell,
                                                       std::vector<std::uint64_t>& memory)
{
    const auto corners = cornersOf(complex, cell);
    if (complex.shapes[cell] != CellShape::Polyhedron)
        return corners;
    memory.clear();
    const bool whole = forFaces(
        corners, [&](std::span<const std::uint64_t> face) { memory.insert(memory.end(), face.begin(), face.end()); });
    return whole ? std::optional<std::span<const std::uint64_t>>(memory) : std::nullopt;
}

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
        const CellShape shape = cells.shapes[cell];
        const auto nodes = cells.nodesOf(cell);
        const std::size_t kept = shape == CellShape::Polyhedron ? nodes.size() : cellTopology(shape).cornerCount;
        linear.shapes.push_back(withoutMiddles(shape));
        linear.nodes.insert(linear.nodes.end(), nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(kept));
        dropped.insert(dropped.end(), nodes.begin() + static_cast<std::ptrdiff_t>(kept), nodes.end());
        linear.offsets.push_back(linear.nodes.size());
    }
    linear.faceOffsets = std::move(cells.faceOffsets);
    linear.faces = std::move(cells.faces);
    std::ranges::sort(dropped);
    repairs.middles += static_cast<std::uint64_t>(std::ranges::unique(dropped).begin() - dropped.begin());
    linear.origins = std::move(cells.origins);
    cells = std::move(linear);
}

bool dropMiddlesIfMixed(CleanCells& cells, Repairs& repairs)
{
    if (std::ranges::none_of(cells.shapes, isQuadratic))
        return false;
    if (std::ranges::find(cells.shapes, CellShape::Polyhedron) != cells.shapes.end()) { // they have no such nodes
        dropMiddles(cells, repairs);
        return true;
    }
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
