// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/boundary_relations.h"

#include "core/base/sort_unique.h"
#include "core/mesh/topology.h"
#include "core/render/volume/projected_vertices.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

using Eigen::Vector3d;

/// A face of the boundary in the picture.
struct HullFace {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t cell;
    SampleRectangle box;
};

/// A ray passing a face of the boundary.
struct RayCrossing {
    std::uint32_t sample; ///< of the tile
    float nearness;       ///< q, larger is nearer; in single precision, so that faces on one place tie
    bool enters;
    std::uint32_t cell;

    /// By sample, front to back; where two parts of the domain touch, out of the one before into the other.
    bool operator<(const RayCrossing& other) const
    {
        if (sample != other.sample)
            return sample < other.sample;
        if (nearness != other.nearness)
            return nearness > other.nearness;
        return enters != other.enters ? other.enters : cell < other.cell;
    }
};

std::vector<HullFace> facesInPicture(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                     const FaceAdjacency& adjacency, const ProjectedVertices& projected,
                                     const VolumeView& view)
{
    std::vector<HullFace> faces;
    constexpr std::uint8_t allFaces = 15;
    for (std::uint32_t cell = 0; cell < tetrahedra.size(); ++cell) {
        if (adjacency.innerFaces[cell] == allFaces)
            continue;
        for (std::size_t face = 0; face < 4; ++face) {
            if (adjacency.neighbours[cell][face] != FaceAdjacency::none)
                continue;
            HullFace found{{}, cell, {}};
            for (std::size_t i = 0; i < 3; ++i)
                found.corners[i] = tetrahedra[cell][cornersOfFace[face][i]];
            found.box = intersection(boxOf(std::span<const std::uint32_t, 3>(found.corners), projected, view),
                                     {0, 0, view.width, view.height});
            if (!isEmpty(found.box))
                faces.push_back(found);
        }
    }
    return faces;
}

/// The faces of each tile.
std::vector<std::vector<std::uint32_t>> binFaces(const std::vector<HullFace>& faces, const TileGrid& grid)
{
    std::vector<std::vector<std::uint32_t>> tiles(grid.count());
    const TileFinder finder(grid);
    for (std::uint32_t face = 0; face < faces.size(); ++face)
        forEachTileOf(faces[face].box, finder,
                      [&](int row, int column) { tiles[finder.numberOf(row, column)].push_back(face); });
    return tiles;
}

/// A face made ready to be drawn in a picture.
class ScreenFace {
public:
    ScreenFace(const HullFace& face, const ProjectedVertices& projected, const VolumeView& view) : box_(face.box)
    {
        Vector3d corners[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const ProjectedVertex& vertex = projected.vertices[face.corners[i]];
            corners[i] = {vertex.u, vertex.v, vertex.w};
        }
        const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const double offset = normal.dot(corners[0]);
        // As in CellSetup: q is plane_ . (x, y, 1).
        outside_ = view.perspective ? offset : normal.z();
        plane_ = (view.perspective ? normal : Vector3d(normal.x(), normal.y(), -offset)) / outside_;
        for (std::size_t i = 0; i < 3; ++i) {
            Vector3d a = corners[i], b = corners[(i + 1) % 3];
            if (!view.perspective)
                a.z() = b.z() = 1;
            sides_[i] = a.cross(b) * (outside_ < 0 ? -1 : 1);
        }
    }

    bool edgeOn() const { return !(outside_ != 0); }
    /// Rays come into the domain through it: its normal, which looks out of the domain, looks to the eye.
    bool isEntry() const { return outside_ < 0; }
    double nearness(const Vector3d& ray) const { return plane_.dot(ray); }

    /// Calls visit(y, first, end) for the samples of `tile` whose rays pass it, a row at a time.
    template <class Visit> void forEachRow(const VolumeView& view, const SampleRectangle& tile, Visit&& visit) const
    {
        const SampleRectangle box = intersection(box_, tile);
        for (int y = box.top; y < box.bottom; ++y) {
            double first = box.left, last = box.right - 1;
            for (const Vector3d& side : sides_) {
                // Inside is perX x + atStart >= 0.
                const double perX = side.x();
                const double atStart = side.dot(Vector3d(view.firstX(), y + view.firstY(), 1));
                if (perX > 0)
                    first = std::max(first, -atStart / perX);
                else if (perX < 0)
                    last = std::min(last, -atStart / perX);
                else if (atStart < 0)
                    last = -1;
            }
            if (first <= last)
                visit(y, static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(last)) + 1);
        }
    }

private:
    SampleRectangle box_;
    double outside_;
    Vector3d plane_;
    Vector3d sides_[3];
};

/// The relations of one tile; keeps its memory from tile to tile.
class TileRelations {
public:
    TileRelations(const std::vector<HullFace>& faces, const ProjectedVertices& projected, const VolumeView& view)
        : faces_(faces), projected_(projected), view_(view),
          cut_(std::ranges::any_of(projected.samples, &VertexSample::isBehind))
    {
    }

    void find(const SampleRectangle& tile, std::span<const std::uint32_t> faces, std::vector<CellRelation>& relations)
    {
        if (!countEntries(tile, faces))
            return;
        collectCrossings(tile, faces);
        std::ranges::sort(crossings_, std::less<>());
        const std::size_t before = relations.size();
        for (std::size_t i = 1; i < crossings_.size(); ++i)
            if (crossings_[i].sample == crossings_[i - 1].sample && !crossings_[i - 1].enters && crossings_[i].enters &&
                crossings_[i - 1].cell != crossings_[i].cell)
                relations.push_back({crossings_[i - 1].cell, crossings_[i].cell});
        const auto found = std::span(relations).subspan(before);
        std::ranges::sort(found);
        relations.resize(before + static_cast<std::size_t>(std::ranges::unique(found).begin() - found.begin()));
    }

private:
    /// Of a cut domain the first entry may lie before the near plane.
    std::uint8_t enough() const { return cut_ ? 1 : 2; }

    /// Returns whether a sample has enough of them for a gap.
    bool countEntries(const SampleRectangle& tile, std::span<const std::uint32_t> faces)
    {
        const int samples = tile.width() * tile.height();
        entries_.assign(static_cast<std::size_t>(samples), 0);
        for (const std::uint32_t index : faces) {
            const ScreenFace face(faces_[index], projected_, view_);
            if (face.edgeOn() || !face.isEntry())
                continue;
            face.forEachRow(view_, tile, [&](int y, int first, int end) {
                const int before = (y - tile.top) * tile.width();
                std::uint8_t* row = &entries_[static_cast<std::size_t>(before)];
                for (int x = first - tile.left; x < end - tile.left; ++x)
                    row[x] = std::min<std::uint8_t>(row[x] + 1, 2);
            });
        }
        return std::ranges::any_of(entries_, [&](std::uint8_t count) { return count >= enough(); });
    }

    void collectCrossings(const SampleRectangle& tile, std::span<const std::uint32_t> faces)
    {
        crossings_.clear();
        for (const std::uint32_t index : faces) {
            const ScreenFace face(faces_[index], projected_, view_);
            if (face.edgeOn())
                continue;
            face.forEachRow(view_, tile, [&](int y, int first, int end) {
                for (int x = first; x < end; ++x) {
                    const auto sample = static_cast<std::uint32_t>((y - tile.top) * tile.width() + x - tile.left);
                    if (entries_[sample] < enough())
                        continue;
                    const double q = face.nearness({x + view_.firstX(), y + view_.firstY(), 1});
                    if (!view_.perspective || (q > 0 && q * view_.nearest < 1))
                        crossings_.push_back({sample, static_cast<float>(q), face.isEntry(), faces_[index].cell});
                }
            });
        }
    }

    const std::vector<HullFace>& faces_;
    const ProjectedVertices& projected_;
    const VolumeView& view_;
    bool cut_;                          ///< the near plane cuts the domain
    std::vector<std::uint8_t> entries_; ///< of each sample, counted to two
    std::vector<RayCrossing> crossings_;
};

} // namespace

std::vector<CellRelation> boundaryRelations(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                            const FaceAdjacency& adjacency, const ProjectedVertices& projected,
                                            const VolumeView& view, const TileGrid& grid, const Progress& progress)
{
    const std::vector<HullFace> faces = facesInPicture(tetrahedra, adjacency, projected, view);
    const auto facesOfTiles = binFaces(faces, grid);
    tbb::enumerable_thread_specific<std::vector<CellRelation>> found;
    tbb::enumerable_thread_specific<TileRelations> workers([&] { return TileRelations(faces, projected, view); });
    tbb::parallel_for(std::size_t(0), grid.count(), [&](std::size_t tile) {
        if (!progress.cancelled())
            workers.local().find(grid.tile(tile), facesOfTiles[tile], found.local());
    });
    std::vector<CellRelation> relations;
    for (const auto& ofThread : found)
        relations.insert(relations.end(), ofThread.begin(), ofThread.end());
    sortUnique(relations);
    return relations;
}

} // namespace tetra
