// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/volume_mesh.h"

#include "core/render/samples/sampled_field.h"

#include "core/base/disjoint_sets.h"
#include "core/base/guarded.h"
#include "core/mesh/topology.h"

#include <tan/render.h>

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetra {

namespace {

/// The segment of values from a vertex's upwards, and that of values downwards; they differ at a knot.
struct VertexClass {
    std::uint16_t up = CellClass::nothing;
    std::uint16_t down = CellClass::nothing;
};

/// For each segment, how many before it are not transparent.
std::vector<std::uint32_t> countVisible(std::span<const TransferSegment> segments)
{
    std::vector<std::uint32_t> before = {0};
    for (const TransferSegment& segment : segments)
        before.push_back(before.back() + (segment.transparent() ? 0 : 1));
    return before;
}

Buffer<VertexClass> classifyVertices(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments)
{
    std::vector<double> knots;
    for (std::size_t i = 1; i < segments.size(); ++i)
        knots.push_back(segments[i].begin);
    Buffer<VertexClass> classes(mesh.values.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, classes.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            classes[v] = {};
            const double value = mesh.values[v];
            if (!std::isfinite(value) || !mesh.positions[v].allFinite())
                continue;
            classes[v].up = static_cast<std::uint16_t>(std::ranges::upper_bound(knots, value) - knots.begin());
            classes[v].down = static_cast<std::uint16_t>(std::ranges::lower_bound(knots, value) - knots.begin());
        }
    });
    return classes;
}

} // namespace

Buffer<CellClass> classifyCells(const TetrahedralMesh& mesh, std::span<const TransferSegment> segments)
{
    const std::vector<std::uint32_t> visibleBefore = countVisible(segments);
    const Buffer<VertexClass> vertices = classifyVertices(mesh, segments);
    Buffer<CellClass> classes(mesh.tetrahedra.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, classes.size(), 1 << 14), [&](const auto& range) {
        for (std::size_t cell = range.begin(); cell != range.end(); ++cell) {
            const auto& [a, b, c, d] = mesh.tetrahedra[cell];
            const VertexClass &va = vertices[a], &vb = vertices[b], &vc = vertices[c], &vd = vertices[d];
            classes[cell] = {};
            if (std::max({va.up, vb.up, vc.up, vd.up}) == CellClass::nothing)
                continue;
            const std::uint16_t first = std::min({va.up, vb.up, vc.up, vd.up});
            const std::uint16_t last = std::max({first, va.down, vb.down, vc.down, vd.down});
            if (visibleBefore[last + 1u] > visibleBefore[first])
                classes[cell] = {first, last};
        }
    });
    return classes;
}

namespace {

constexpr double deepestDent = 1e-5;

/// An edge of a face of the boundary, and the face's third corner.
struct BoundaryEdge {
    std::uint32_t low, high;
    std::uint32_t third;
    std::uint32_t face; ///< its number among the boundary's
    bool forwards;      ///< seen from outside the face has its corners as low, high, third counterclockwise
    auto operator<=>(const BoundaryEdge&) const = default;
};

std::vector<BoundaryEdge> boundaryEdges(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency)
{
    std::vector<BoundaryEdge> edges;
    for (std::size_t cell = 0; cell < mesh.tetrahedra.size(); ++cell)
        for (std::size_t face = 0; face < 4; ++face) {
            if (adjacency.neighbours[cell][face] != FaceAdjacency::none)
                continue;
            const auto number = static_cast<std::uint32_t>(edges.size() / 3);
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.tetrahedra[cell][cornersOfFace[face][i]];
                const std::uint32_t b = mesh.tetrahedra[cell][cornersOfFace[face][(i + 1) % 3]];
                const std::uint32_t c = mesh.tetrahedra[cell][cornersOfFace[face][(i + 2) % 3]];
                edges.push_back({std::min(a, b), std::max(a, b), c, number, a < b});
            }
        }
    std::ranges::sort(edges);
    return edges;
}

/// How far the third corner of the one face lies before the plane of the other; not a number if that has no plane.
double heightOver(const TetrahedralMesh& mesh, const BoundaryEdge& one, const BoundaryEdge& other)
{
    const auto at = [&](std::uint32_t vertex) -> const Eigen::Vector3d& { return mesh.positions[vertex]; };
    const Eigen::Vector3d start = at(other.low);
    const Eigen::Vector3d normal = (at(other.high) - start).cross(at(other.third) - start).normalized();
    return (other.forwards ? 1 : -1) * normal.dot(at(one.third) - start);
}

} // namespace

bool hasConvexBoundary(const TetrahedralMesh& mesh, const FaceAdjacency& adjacency)
{
    const std::vector<BoundaryEdge> edges = boundaryEdges(mesh, adjacency);
    if (edges.empty() || edges.size() % 2 != 0)
        return false;
    Eigen::AlignedBox3d bounds;
    for (const BoundaryEdge& edge : edges)
        bounds.extend(mesh.positions[edge.third]);
    const double dent = deepestDent * bounds.diagonal().norm();

    DisjointSets surfaces(edges.size() / 3);
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        const BoundaryEdge &one = edges[i], &other = edges[i + 1];
        const bool pair = one.low == other.low && one.high == other.high && one.forwards != other.forwards;
        const bool alone = i + 2 == edges.size() || edges[i + 2].low != one.low || edges[i + 2].high != one.high;
        if (!pair || !alone || !(heightOver(mesh, one, other) <= dent))
            return false;
        surfaces.join(one.face, other.face);
    }
    for (std::uint32_t face = 1; face < surfaces.size(); ++face)
        if (surfaces.root(face) != 0)
            return false;
    return true;
}

namespace {

constexpr MarkedText noMemoryForVolume = Message::marked(
    "Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh.");

Status checkCells(const TetrahedralMesh& mesh)
{
    if (mesh.values.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, Message::say("The mesh and its values do not belong together.")};
    if (mesh.tetrahedra.size() >= largestAdjacentCellCount)
        return Error{
            ErrorKind::OutOfResource,
            Message::say(
                "The mesh has more than a billion tetrahedra, too many to be drawn at once. Lower its accuracy.")};
    const std::size_t vertices = mesh.positions.size();
    const auto exists = [&](std::uint32_t vertex) { return vertex < vertices; };
    if (!std::ranges::all_of(mesh.tetrahedra, [&](const auto& cell) { return std::ranges::all_of(cell, exists); }))
        return Error{ErrorKind::WrongUsage, Message::say("A tetrahedron has a corner that does not exist.")};
    return {};
}

Eigen::AlignedBox3d boundsOf(const TetrahedralMesh& mesh)
{
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& position : mesh.positions)
        if (position.allFinite())
            bounds.extend(position);
    return bounds;
}

/// Of a mesh: lengths of 1 at most, so that squares of them are floats whatever the units; what is no number tells no
/// direction.
void addLightGradients(const TetrahedralMesh& mesh, VolumeMesh& volume)
{
    Buffer<Eigen::Vector3f> gradients = vertexGradients(mesh);
    const tbb::blocked_range<std::size_t> all(0, gradients.size(), 1 << 15);
    const auto largestOf = [&](const tbb::blocked_range<std::size_t>& range, double largest) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            if (gradients[i].allFinite())
                largest = std::max(largest, gradients[i].cast<double>().norm());
        return largest;
    };
    const double largest =
        tbb::parallel_reduce(all, 0.0, largestOf, [](double one, double other) { return std::max(one, other); });
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            gradients[i] = gradients[i].allFinite() && largest > 0
                               ? Eigen::Vector3f((gradients[i].cast<double>() / largest).cast<float>())
                               : Eigen::Vector3f(0, 0, 0);
    });
    volume.gradients = std::move(gradients);
    volume.longestGradient = largest;
}

} // namespace

Result<VolumeMesh> makeVolumeMesh(std::shared_ptr<const TetrahedralMesh> mesh)
{
    if (Status status = checkCells(*mesh); !status)
        return status.error();
    return guarded(noMemoryForVolume, [&]() -> Result<VolumeMesh> {
        VolumeMesh result;
        result.adjacency = matchFaces(mesh->tetrahedra);
        result.bounds = boundsOf(*mesh);
        result.convex = hasConvexBoundary(*mesh, result.adjacency);
        addLightGradients(*mesh, result);
        result.mesh = std::move(mesh);
        return result;
    });
}

Result<VolumeTransfer> makeVolumeTransfer(const TetrahedralMesh& mesh, const TransferFunction& function)
{
    if (Status status = checkTransferFunction(function); !status)
        return status.error();
    return guarded(noMemoryForVolume, [&]() -> Result<VolumeTransfer> {
        VolumeTransfer result;
        result.segments = transferSegments(function);
        if (result.segments.size() > largestSegmentCount)
            return Error{ErrorKind::OutOfResource,
                         Message::say("The transfer function has more than 65,000 points. Leave some out.")};
        result.classes = classifyCells(mesh, result.segments);
        return result;
    });
}

namespace {

bool isSeen(const Volume& volume)
{
    return volume.mesh && volume.transfer;
}

Status checkVolume(const Volume& volume)
{
    if (isSeen(volume) && volume.transfer->classes.size() != volume.mesh->mesh->tetrahedra.size())
        return Error{ErrorKind::WrongUsage,
                     Message::say("A volume of the scene and its transfer function do not belong together.")};
    if (volume.model && (!volume.model->evaluate || volume.model->shader.empty()))
        return Error{ErrorKind::WrongUsage,
                     Message::say("An optical model of the scene lacks its function or its shader. This is a fault of "
                                  "the plugin that made it; tell its author.")};
    return {};
}

} // namespace

const Volume* volumeOf(const Scene& scene)
{
    for (const Drawable& drawable : scene.drawables) {
        const auto* volume = std::get_if<Volume>(&drawable.shape);
        if (const auto* focus = std::get_if<FocusVolume>(&drawable.shape))
            volume = &focus->outside;
        if (volume != nullptr && isSeen(*volume))
            return volume;
    }
    return nullptr;
}

const FocusVolume* focusOf(const Scene& scene)
{
    for (const FocusVolume* focus : shapesOf<FocusVolume>(scene))
        if (isSeen(focus->outside) && isSeen(focus->fine))
            return focus;
    return nullptr;
}

const SampledVolume* samplesOf(const Scene& scene)
{
    const auto all = shapesOf<SampledVolume>(scene);
    return all.empty() ? nullptr : all.front();
}

namespace {

Status checkSamples(const SampledVolume& samples)
{
    if (!samples.samples || !samples.transfer ||
        samples.transfer->distances.size() != samples.samples->extents.size() ||
        (samples.gradients && samples.gradients->vectors.size() != samples.samples->values.count()))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The samples of the scene and their transfer function do not belong together.")};
    return {};
}

} // namespace

Status checkVolumes(const Scene& scene)
{
    std::size_t count = 0;
    for (const SampledVolume* samples : shapesOf<SampledVolume>(scene)) {
        ++count;
        if (Status status = checkSamples(*samples); !status)
            return status;
    }
    for (const Volume* volume : shapesOf<Volume>(scene)) {
        ++count;
        if (Status status = checkVolume(*volume); !status)
            return status;
    }
    for (const FocusVolume* focus : shapesOf<FocusVolume>(scene)) {
        ++count;
        for (const Volume* volume : {&focus->outside, &focus->fine}) {
            if (Status status = checkVolume(*volume); !status)
                return status;
            if (volume->model)
                return Error{ErrorKind::WrongUsage,
                             Message::say("A blend of two volumes supports only emission and absorption. Remove the "
                                          "optical model, or show one of the two.")};
        }
    }
    if (count > 1)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A scene can have one volume, or one blend of two, and this one has %1. Show the "
                                  "others as surfaces, or in separate pictures.",
                                  count)};
    return {};
}

Eigen::AlignedBox3d drawnBounds(const Scene& scene)
{
    const Volume* volume = volumeOf(scene);
    return volume != nullptr ? scene.bounds.merged(volume->mesh->bounds) : scene.bounds;
}

namespace {

constexpr MarkedText preparingVolume = Message::marked("Preparing the volume");

} // namespace

VolumeCache::VolumeCache(std::shared_ptr<OrderedMesh> mesh) : tetrahedra_(std::move(mesh)) {}

VolumeCache::VolumeCache(std::shared_ptr<const TetrahedralMesh> mesh)
    : tetrahedra_(std::make_shared<OrderedMesh>(std::move(mesh)))
{
}

Status VolumeCache::makeMesh(const Progress& progress)
{
    if (mesh_)
        return {};
    auto ordered = tetrahedra_->ordered(progress);
    if (!ordered)
        return ordered.error();
    auto made = makeVolumeMesh(*std::move(ordered));
    if (!made)
        return made.error();
    mesh_ = std::make_shared<const VolumeMesh>(*std::move(made));
    return {};
}

Status VolumeCache::makeTransfer(const TransferFunction& function)
{
    if (transfer_ && function_ == function)
        return {};
    auto made = makeVolumeTransfer(*mesh_->mesh, function);
    if (!made)
        return made.error();
    transfer_ = std::make_shared<const VolumeTransfer>(*std::move(made));
    function_ = function;
    return {};
}

Result<Volume> VolumeCache::update(const TransferFunction& function, bool shaded, const Progress& progress)
{
    progress.report(0, preparingVolume);
    if (progress.cancelled())
        return cancelledError(preparingVolume);
    if (const Status made = makeMesh(progress.part(0, 0.4)); !made)
        return made.error();
    progress.report(0.8, preparingVolume);
    if (progress.cancelled())
        return cancelledError(preparingVolume);
    if (const Status made = makeTransfer(function); !made)
        return made.error();
    progress.report(1, preparingVolume);
    return Volume{mesh_, transfer_, shaded};
}

} // namespace tetra
