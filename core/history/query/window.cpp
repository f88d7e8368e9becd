// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/window.h"

#include "core/base/flat_index.h"
#include "core/base/guarded.h"
#include "core/history/query/error_field.h"
#include "core/mesh/topology.h"

#include <tan/query.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace tetra {

bool canContain(const std::array<float, 4>& values, std::span<const ValueRange> ranges)
{
    const double least = std::min(std::min(values[0], values[1]), std::min(values[2], values[3]));
    const double largest = std::max(std::max(values[0], values[1]), std::max(values[2], values[3]));
    const auto overlaps = [least, largest](const ValueRange& range) {
        return largest >= range.minimum && least <= range.maximum && range.minimum <= range.maximum;
    };
    return ranges.empty() || std::ranges::any_of(ranges, overlaps);
}

BoxSides::BoxSides(const Box& box, std::span<const Eigen::Vector3d> positions)
    : box_(box), positions_(positions), sides_(positions.size())
{
    const bool isEmpty = (box.least.array() > box.largest.array()).any();
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        unsigned sides = isEmpty ? ~0u : 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = positions[vertex][axis];
            sides |= unsigned(coordinate < box.least[axis]) << 2 * axis;
            sides |= unsigned(coordinate > box.largest[axis]) << (2 * axis + 1);
        }
        sides_[vertex] = static_cast<std::uint8_t>(sides);
    }
}

bool BoxSides::meets(const std::array<std::uint32_t, 4>& tetrahedron) const
{
    if (const Place place = placeOf(tetrahedron); place != Place::Across)
        return place == Place::Inside;
    Corners corners;
    for (int corner = 0; corner < 4; ++corner) {
        if (sides_[tetrahedron[corner]] == 0)
            return true;
        corners[corner] = positions_[tetrahedron[corner]];
    }
    return tetrahedronMeetsBox(corners, box_, 0);
}

namespace {

/// Up to three tetrahedra that part of another one is made of.
struct TetrahedronPieces {
    int count = 0;
    std::array<std::array<std::uint32_t, 4>, 3> tetrahedra;

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) { tetrahedra[count++] = {a, b, c, d}; }
};

// Quadrilaterals are split by the diagonal from their vertex of least number: so neighbours do the same.

/// The ways to turn a prism, by which each of its vertices can be made the first.
constexpr std::array<std::array<int, 6>, 6> turns = {{{0, 1, 2, 3, 4, 5},
                                                      {1, 2, 0, 4, 5, 3},
                                                      {2, 0, 1, 5, 3, 4},
                                                      {3, 5, 4, 0, 2, 1},
                                                      {4, 3, 5, 1, 0, 2},
                                                      {5, 4, 3, 2, 1, 0}}};

/// A prism with the bottom a, b, c and the top d, e, f, where (a, b, c, d) is positive, as positive tetrahedra.
TetrahedronPieces splitPrism(const std::array<std::uint32_t, 6>& prism)
{
    // From the vertex of least number go the diagonals of both quadrilaterals that have it; the third is free.
    const auto& turn = turns[static_cast<std::size_t>(std::ranges::min_element(prism) - prism.begin())];
    std::array<std::uint32_t, 6> p{};
    std::ranges::transform(turn, p.begin(), [&prism](int place) { return prism[static_cast<std::size_t>(place)]; });
    TetrahedronPieces pieces;
    if (std::min(p[1], p[5]) < std::min(p[2], p[4])) {
        pieces.add(p[0], p[1], p[2], p[5]);
        pieces.add(p[0], p[1], p[5], p[4]);
    } else {
        pieces.add(p[0], p[1], p[2], p[4]);
        pieces.add(p[0], p[4], p[2], p[5]);
    }
    pieces.add(p[0], p[4], p[5], p[3]);
    return pieces;
}

/// A pyramid with the base a, b, c, d, in this order around it, where (a, b, top, c) is positive, likewise.
TetrahedronPieces splitPyramid(const std::array<std::uint32_t, 4>& base, std::uint32_t top)
{
    const auto [a, b, c, d] = base;
    TetrahedronPieces pieces;
    if (std::min(a, c) < std::min(b, d)) {
        pieces.add(a, b, top, c);
        pieces.add(a, c, top, d);
    } else {
        pieces.add(a, b, top, d);
        pieces.add(d, b, top, c);
    }
    return pieces;
}

/// Sorts the vertices so that their sides fall, but for those that are not positive if there is only one that is, which
/// come in any order. Orientation is kept.
void orderBySigns(std::array<std::uint32_t, 4>& tetrahedron, std::array<int, 4>& sides)
{
    bool odd = false;
    const auto swap = [&](std::size_t i) {
        std::swap(sides[i], sides[i + 1]);
        std::swap(tetrahedron[i], tetrahedron[i + 1]);
        odd = !odd;
    };
    for (std::size_t end = 3; end > 0; --end)
        for (std::size_t i = 0; i < end; ++i)
            if (sides[i] < sides[i + 1])
                swap(i);
    if (odd)
        swap(sides[1] > 0 ? 0 : 2); // among equals, or where the order does not matter
}

using CutPlace = BoxSides::Place;

constexpr MarkedText cuttingAtWindow = Message::marked("Cutting at the crop box");
/// Tetrahedra between two looks at whether the work was cancelled, and at how many vertices there are.
constexpr std::size_t cutAtOnce = 1 << 16;
constexpr std::size_t mostVertices = 0xfffffffe;

/// A plane across an axis; what is kept is where direction * coordinate is not less than in it.
struct Plane {
    int axis;
    int direction;
    double coordinate;
};

/// Cuts tetrahedra at one plane, with new vertices behind those of the mesh.
class PlaneCut {
public:
    PlaneCut(const Plane& plane, TetrahedralMesh& mesh)
        : plane_(plane), mesh_(mesh), first_(static_cast<std::uint32_t>(mesh.positions.size()))
    {
    }

    /// Appends what remains of the tetrahedron, without parts that have no volume.
    void cut(Tetrahedron tetrahedron, Buffer<Tetrahedron>& kept)
    {
        std::array<int, 4> sides{};
        std::ranges::transform(tetrahedron, sides.begin(), [this](std::uint32_t vertex) { return sideOf(vertex); });
        const auto [least, largest] = std::ranges::minmax(sides);
        if (largest <= 0)
            return;
        if (least >= 0) {
            kept.push_back(tetrahedron);
            return;
        }
        orderBySigns(tetrahedron, sides);
        const TetrahedronPieces pieces = piecesOf(tetrahedron, sides);
        kept.insert(kept.end(), pieces.tetrahedra.begin(), pieces.tetrahedra.begin() + pieces.count);
    }

private:
    int sideOf(std::uint32_t vertex) const
    {
        const double coordinate = mesh_.positions[vertex][plane_.axis];
        return plane_.direction * (int(coordinate > plane_.coordinate) - int(coordinate < plane_.coordinate));
    }

    /// `t` is ordered by its sides, of which there are both.
    TetrahedronPieces piecesOf(const Tetrahedron& t, const std::array<int, 4>& sides)
    {
        const auto on = [&](int positive, int negative) { return vertexOn(t[positive], t[negative]); };
        if (sides[2] > 0)
            return splitPrism({t[0], t[1], t[2], on(0, 3), on(1, 3), on(2, 3)});
        if (sides[1] > 0 && sides[2] == 0)
            return splitPyramid({t[0], t[1], on(1, 3), on(0, 3)}, t[2]);
        if (sides[1] > 0)
            return splitPrism({t[0], on(0, 2), on(0, 3), t[1], on(1, 2), on(1, 3)});
        const auto inPlane = [&](int other) { return sides[other] < 0 ? on(0, other) : t[other]; };
        TetrahedronPieces one;
        one.add(t[0], inPlane(1), inPlane(2), inPlane(3));
        return one;
    }

    std::uint32_t vertexOn(std::uint32_t one, std::uint32_t other)
    {
        const EdgeKey edge = edgeKey(one, other);
        const std::uint32_t vertex = first_ + cutEdges_.numberOf(edge);
        if (vertex == mesh_.positions.size())
            addVertex(edge);
        return vertex;
    }

    /// Goes from the smaller end to the larger one, so that the place is the same whichever tetrahedron comes first.
    void addVertex(EdgeKey edge)
    {
        const auto [from, to] = endsOf(edge);
        const Eigen::Vector3d a = mesh_.positions[from];
        const Eigen::Vector3d b = mesh_.positions[to];
        const double start = a[plane_.axis];
        const double part = (plane_.coordinate - start) / (b[plane_.axis] - start);
        const auto between = [part](double first, double second) {
            // Never beyond the ends, so never beyond a plane that was cut at before.
            return std::clamp(first + (second - first) * part, std::min(first, second), std::max(first, second));
        };
        Eigen::Vector3d position(between(a[0], b[0]), between(a[1], b[1]), between(a[2], b[2]));
        position[plane_.axis] = plane_.coordinate;
        const auto value = static_cast<float>(between(mesh_.values[from], mesh_.values[to]));
        mesh_.positions.push_back(position);
        mesh_.values.push_back(value);
    }

    const Plane plane_;
    TetrahedralMesh& mesh_;
    const std::uint32_t first_; ///< of the new vertices, which are in the order of the edges that they lie on
    FlatIndex<EdgeKey> cutEdges_;
};

/// Tetrahedra, and for each the number of the one that it is a piece of; pieces of the same follow each other.
struct Pieces {
    Buffer<Tetrahedron> tetrahedra;
    Buffer<std::uint32_t> origins;
};

/// Leaves those that lie in the box, in order, and takes those out that lie across its border.
Status takeOutThoseAcross(TetrahedralMesh& mesh, const BoxSides& sides, Pieces& across, const Progress& progress)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        if (t % cutAtOnce == 0 && progress.cancelled())
            return cancelledError(cuttingAtWindow);
        const Tetrahedron tetrahedron = mesh.tetrahedra[t];
        const CutPlace place = sides.placeOf(tetrahedron);
        if (place == CutPlace::Across) {
            across.tetrahedra.push_back(tetrahedron);
            across.origins.push_back(static_cast<std::uint32_t>(t));
        }
        mesh.tetrahedra[kept] = tetrahedron;
        kept += place == CutPlace::Inside ? 1 : 0;
    }
    mesh.tetrahedra.resize(kept);
    return {};
}

Status cutAt(const Plane& plane, TetrahedralMesh& mesh, Pieces& pieces, const Progress& progress)
{
    PlaneCut cutter(plane, mesh);
    const Buffer<Tetrahedron>& tetrahedra = pieces.tetrahedra;
    Pieces kept;
    kept.tetrahedra.reserve(tetrahedra.size());
    kept.origins.reserve(tetrahedra.size());
    for (std::size_t first = 0; first < tetrahedra.size(); first += cutAtOnce) {
        const std::size_t end = std::min(first + cutAtOnce, tetrahedra.size());
        if (progress.cancelled())
            return cancelledError(cuttingAtWindow);
        if (mesh.positions.size() + 4 * (end - first) > mostVertices)
            return Error{
                ErrorKind::OutOfResource,
                Message::say(
                    "The mesh cut at the crop box has too many vertices: choose a larger error or a smaller box.")};
        progress.report(static_cast<double>(first) / static_cast<double>(tetrahedra.size()), cuttingAtWindow);
        for (std::size_t t = first; t < end; ++t) {
            cutter.cut(tetrahedra[t], kept.tetrahedra);
            kept.origins.resize(kept.tetrahedra.size(), pieces.origins[t]);
        }
    }
    std::swap(pieces, kept);
    return {};
}

std::uint64_t countOrigins(const Pieces& pieces)
{
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < pieces.origins.size(); ++i)
        count += i == 0 || pieces.origins[i] != pieces.origins[i - 1] ? 1 : 0;
    return count;
}

/// What is made of them, diagonals and numbers of vertices, is then the same in whatever order the mesh has them, which
/// depends on the meshes that were extracted before.
void putInOrder(Pieces& pieces)
{
    std::vector<std::pair<Tetrahedron, std::uint32_t>> ordered;
    ordered.reserve(pieces.tetrahedra.size());
    for (std::size_t i = 0; i < pieces.tetrahedra.size(); ++i)
        ordered.emplace_back(pieces.tetrahedra[i], pieces.origins[i]);
    std::ranges::sort(ordered);
    for (std::size_t i = 0; i < ordered.size(); ++i)
        std::tie(pieces.tetrahedra[i], pieces.origins[i]) = ordered[i];
}

/// Cuts a mesh off at a box, in whose faces the new vertices lie exactly. One plane after the other; what is cut are
/// the edges from one side of a plane to the other. Tetrahedra that lie in the box stay first and in order; those that
/// are cut follow. Gives how many of the mesh's tetrahedra there is something left of. Errors: cancelled, out of
/// resource. May throw std::bad_alloc.
Result<std::uint64_t> cutAtWindow(TetrahedralMesh& mesh, const Box& window, const Progress& progress)
{
    Pieces across;
    if (const Status taken = takeOutThoseAcross(mesh, BoxSides(window, mesh.positions), across, progress); !taken)
        return taken.error();
    putInOrder(across);
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const bool isLower = face % 2 == 0;
        const double coordinate = isLower ? window.least[axis] : window.largest[axis];
        const Status cut =
            cutAt({axis, isLower ? 1 : -1, coordinate}, mesh, across, progress.part(face / 6.0, (face + 1) / 6.0));
        if (!cut)
            return cut.error();
    }
    const std::uint64_t left = mesh.tetrahedra.size() + countOrigins(across);
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), across.tetrahedra.begin(), across.tetrahedra.end());
    return left;
}

/// Tetrahedra between two looks at whether the work was cancelled.
constexpr std::size_t filteredAtOnce = 1 << 16;
constexpr MarkedText choosingCells = Message::marked("Selecting tetrahedra from the mesh");

/// Keeps those that the test is true of, in order.
template <class Test> Status keepIf(Buffer<Tetrahedron>& tetrahedra, const Progress& progress, const Test& test)
{
    const std::size_t count = tetrahedra.size();
    std::size_t kept = 0;
    for (std::size_t first = 0; first < count; first += filteredAtOnce) {
        if (progress.cancelled())
            return cancelledError(choosingCells);
        progress.report(static_cast<double>(first) / static_cast<double>(count), choosingCells);
        for (std::size_t t = first; t < std::min(first + filteredAtOnce, count); ++t) {
            const Tetrahedron tetrahedron = tetrahedra[t];
            tetrahedra[kept] = tetrahedron;
            kept += test(tetrahedron) ? 1 : 0;
        }
    }
    tetrahedra.resize(kept);
    return {};
}

Result<std::uint64_t> keepWindowUnguarded(TetrahedralMesh& mesh, const Window& window, const Progress& progress)
{
    if (window.border == WindowBorder::Clipped)
        return cutAtWindow(mesh, window.box, progress);
    const BoxSides sides(window.box, mesh.positions);
    const bool whole = window.border == WindowBorder::Contained;
    const Status kept = keepIf(mesh.tetrahedra, progress, [&sides, whole](const Tetrahedron& t) {
        return whole ? sides.placeOf(t) == BoxSides::Place::Inside : sides.meets(t);
    });
    if (!kept)
        return kept.error();
    return std::uint64_t(mesh.tetrahedra.size());
}

} // namespace

Status keepValues(TetrahedralMesh& mesh, std::span<const ValueRange> ranges, const Progress& progress)
{
    if (ranges.empty())
        return {};
    const float* const values = mesh.values.data();
    return keepIf(mesh.tetrahedra, progress, [ranges, values](const Tetrahedron& t) {
        return canContain({values[t[0]], values[t[1]], values[t[2]], values[t[3]]}, ranges);
    });
}

Result<std::uint64_t> keepWindow(TetrahedralMesh& mesh, const Window& window, const Progress& progress)
{
    return guarded(
        Message::marked(
            "Not enough memory to cut a mesh of %1 tetrahedra at a crop box. Choose a larger error or a smaller box."),
        [&] { return keepWindowUnguarded(mesh, window, progress); }, mesh.tetrahedra.size());
}

void dropUnusedVertices(ExtractedMesh& extracted)
{
    TetrahedralMesh& mesh = extracted.mesh;
    const std::size_t count = mesh.positions.size();
    const std::size_t beforeCutting = extracted.sites.size();
    const auto fillUp = [count](Buffer<std::uint32_t>& numbers) {
        const std::size_t known = std::min(numbers.size(), count);
        numbers.resize(count);
        std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(known), numbers.end(), ExtractedMesh::noSite);
    };
    fillUp(extracted.sites);
    if (!extracted.points.empty())
        fillUp(extracted.points);
    const std::vector<std::uint32_t> used = renumberUsed(mesh.tetrahedra, count);
    const std::size_t kept = used.size();
    extracted.keptSites = 0;
    for (std::size_t number = 0; number < kept; ++number) {
        const std::uint32_t vertex = used[number];
        extracted.keptSites += vertex < beforeCutting ? 1 : 0;
        mesh.positions[number] = mesh.positions[vertex];
        mesh.values[number] = mesh.values[vertex];
        extracted.sites[number] = extracted.sites[vertex];
        if (!extracted.points.empty())
            extracted.points[number] = extracted.points[vertex];
    }
    mesh.positions.resize(kept);
    mesh.values.resize(kept);
    extracted.sites.resize(kept);
    if (!extracted.points.empty())
        extracted.points.resize(kept);
}

} // namespace tetra
