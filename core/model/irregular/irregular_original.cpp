// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/irregular_original.h"

#include "core/base/disjoint_sets.h"
#include "core/model/scattered_cells.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

std::vector<PointTriangle> boundaryOf(const Dataset& dataset, std::vector<std::string>& failures)
{
    std::vector<std::uint32_t> points(dataset.pointCount());
    std::iota(points.begin(), points.end(), 0);
    const std::vector<LatticePoint> none;
    const LevelCells cells(points, none, {dataset.tetrahedra->begin(), dataset.tetrahedra->end()});
    const FaceRule rule{[](const auto&) { return true; },
                        [&](std::uint32_t point) { return textOf((*dataset.positions)[point]); }};
    std::vector<BoundaryFace> faces;
    LevelVerdict found;
    if (!verifyFaces(cells, rule, found, {}, &faces) || !found.conforming)
        failures.push_back("The dataset's own tetrahedra do not conform." +
                           (found.failures.empty() ? std::string() : " " + found.failures.front()));
    std::vector<PointTriangle> triangles;
    triangles.reserve(faces.size());
    for (const BoundaryFace& face : faces)
        triangles.push_back(face.vertices);
    return triangles;
}

std::vector<std::uint32_t> surfacesOfPoints(std::size_t points, std::span<const PointTriangle> boundary,
                                            const BoundarySurfaces& surfaces)
{
    std::vector<std::uint32_t> surfaceOf(points, IrregularOriginal::none);
    for (std::size_t triangle = 0; triangle < boundary.size(); ++triangle)
        for (const std::uint32_t point : boundary[triangle])
            surfaceOf[point] = surfaces.surfaceOf[triangle];
    return surfaceOf;
}

std::vector<std::uint32_t> componentsOfPoints(const Dataset& dataset)
{
    DisjointSets joined(dataset.pointCount());
    for (const auto& tetrahedron : *dataset.tetrahedra)
        for (int corner = 1; corner < 4; ++corner)
            joined.join(tetrahedron[0], tetrahedron[corner]);
    std::vector<std::uint32_t> componentOf(dataset.pointCount());
    for (std::uint32_t point = 0; point < componentOf.size(); ++point)
        componentOf[point] = joined.root(point);
    return componentOf;
}

} // namespace

IrregularOriginal::IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures)
    : points(dataset), boundary(boundaryOf(dataset, failures)), surfaces(boundarySurfaces(boundary)),
      surfaceOf(surfacesOfPoints(dataset.pointCount(), boundary, surfaces)), componentOf(componentsOfPoints(dataset)),
      tree(points.positions, boundary)
{
    const Eigen::AlignedBox3d bounds = dataset.bounds();
    diagonal = bounds.diagonal().norm();
    const double farthest = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    allowance = 1e-12 * diagonal + 0x1p-44 * farthest;
    if (!surfaces.isManifold())
        failures.emplace_back("The boundary of the dataset is no manifold.");
}

} // namespace tetra
