// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/window_cut.h"

#include "core/model/queries/edge_vertices.h"
#include "core/model/queries/tetrahedron_filters.h"
#include "core/model/queries/tetrahedron_pieces.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace tetra {

namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;
using CutPlace = BoxSides::Place;

constexpr std::string_view cuttingAtWindow = "Cutting at the window";
/// Tetrahedra between two looks at whether the work was cancelled, and at how many vertices there are.
constexpr std::size_t cutAtOnce = 1 << 16;
constexpr std::size_t mostVertices = 0xfffffffe;

Box roundedToFloats(const Box& box)
{
    const auto rounded = [](const Eigen::Vector3d& corner) -> Eigen::Vector3d {
        constexpr double most = std::numeric_limits<float>::max();
        return corner.cwiseMax(-most).cwiseMin(most).cast<float>().cast<double>();
    };
    return {rounded(box.least), rounded(box.largest)};
}

/// A plane across an axis; what is kept is where direction * coordinate is not less than in it.
struct Plane {
    int axis;
    int direction;
    float coordinate;
};

/// Cuts tetrahedra at one plane, with new vertices behind those of the mesh.
class PlaneCut {
public:
    PlaneCut(const Plane& plane, TetrahedralMesh& mesh) : plane_(plane), mesh_(mesh) {}

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
        orderBySides(tetrahedron, sides);
        const TetrahedronPieces pieces = piecesOf(tetrahedron, sides);
        kept.insert(kept.end(), pieces.tetrahedra.begin(), pieces.tetrahedra.begin() + pieces.count);
    }

private:
    int sideOf(std::uint32_t vertex) const
    {
        const float coordinate = mesh_.positions[vertex][plane_.axis];
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
        const auto [smaller, larger] = std::minmax(one, other); // always the same way, as the neighbours do
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const std::uint32_t vertex = vertices_.on(smaller, larger, next);
        if (vertex == next)
            addVertex(smaller, larger);
        return vertex;
    }

    void addVertex(std::uint32_t from, std::uint32_t to)
    {
        const Eigen::Vector3f a = mesh_.positions[from];
        const Eigen::Vector3f b = mesh_.positions[to];
        const double start = a[plane_.axis];
        const double part = (plane_.coordinate - start) / (b[plane_.axis] - start);
        const auto between = [part](float first, float second) {
            const double found = first + (double(second) - first) * part;
            // Never beyond the ends, so never beyond a plane that was cut at before.
            return static_cast<float>(
                std::clamp(found, double(std::min(first, second)), double(std::max(first, second))));
        };
        Eigen::Vector3f position(between(a[0], b[0]), between(a[1], b[1]), between(a[2], b[2]));
        position[plane_.axis] = plane_.coordinate;
        const float value = between(mesh_.values[from], mesh_.values[to]);
        mesh_.positions.push_back(position);
        mesh_.values.push_back(value);
    }

    const Plane plane_;
    TetrahedralMesh& mesh_;
    EdgeVertices vertices_;
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
            return Error{ErrorKind::OutOfResource, "The mesh that is cut at the window has more vertices than fit: "
                                                   "choose a larger error or a smaller window."};
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

} // namespace

Result<std::uint64_t> cutAtWindow(TetrahedralMesh& mesh, const Box& box, const Progress& progress)
{
    const Box window = roundedToFloats(box);
    Pieces across;
    if (const Status taken = takeOutThoseAcross(mesh, BoxSides(window, mesh.positions), across, progress); !taken)
        return taken.error();
    putInOrder(across);
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const bool isLower = face % 2 == 0;
        const auto coordinate = static_cast<float>(isLower ? window.least[axis] : window.largest[axis]);
        const Status cut =
            cutAt({axis, isLower ? 1 : -1, coordinate}, mesh, across, progress.part(face / 6.0, (face + 1) / 6.0));
        if (!cut)
            return cut.error();
    }
    const std::uint64_t left = mesh.tetrahedra.size() + countOrigins(across);
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), across.tetrahedra.begin(), across.tetrahedra.end());
    return left;
}

} // namespace tetra
