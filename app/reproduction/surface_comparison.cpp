// SPDX-License-Identifier: GPL-3.0-or-later
// The one source of the program that reads CGAL: its simplification of surfaces is what the paper compares with.
#include "app/reproduction/surface_comparison.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tetra {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

/// Where four triangles meet in an edge, its vertices are doubled: a surface that can be simplified has two there.
Mesh meshOf(const TriangleMesh& surface)
{
    std::vector<Kernel::Point_3> points;
    for (const Eigen::Vector3d& position : surface.positions)
        points.emplace_back(position.x(), position.y(), position.z());
    std::vector<std::vector<std::size_t>> triangles;
    for (const auto& triangle : surface.triangles)
        triangles.push_back({triangle[0], triangle[1], triangle[2]});
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);
    Mesh mesh;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
}

void simplify(Mesh& mesh, std::size_t triangles)
{
    if (mesh.number_of_faces() <= triangles)
        return;
    // A surface has about three edges for two triangles, and those of its boundary besides.
    const std::size_t surplus = 2 * mesh.number_of_edges() - 3 * mesh.number_of_faces();
    const auto share = static_cast<double>(triangles) / static_cast<double>(mesh.number_of_faces());
    const auto boundary = static_cast<std::size_t>(static_cast<double>(surplus) * std::sqrt(share));
    CGAL::Surface_mesh_simplification::edge_collapse(
        mesh, CGAL::Surface_mesh_simplification::Count_stop_predicate<Mesh>((3 * triangles + boundary) / 2));
    mesh.collect_garbage();
}

Tree treeOf(const Mesh& mesh)
{
    return Tree(faces(mesh).first, faces(mesh).second, mesh);
}

SurfaceQuality qualityOf(const Mesh& surface, const Mesh& other, const TriangleMesh& finest)
{
    SurfaceQuality quality{.triangles = surface.number_of_faces()};
    if (surface.is_empty() || finest.positions.empty())
        return quality;
    const Tree tree = treeOf(surface);
    Eigen::AlignedBox3d box;
    double squares = 0;
    double largest = 0;
    for (const Eigen::Vector3d& position : finest.positions) {
        box.extend(position);
        const double square = tree.squared_distance(Kernel::Point_3(position.x(), position.y(), position.z()));
        squares += square;
        largest = std::max(largest, square);
    }
    const double percent = 100 / box.diagonal().norm();
    quality.rootMeanSquare = percent * std::sqrt(squares / static_cast<double>(finest.positions.size()));
    quality.largest = percent * std::sqrt(largest);
    if (other.is_empty())
        return quality;
    const Tree otherTree = treeOf(other);
    for (const auto face : faces(surface)) {
        const auto edge = surface.halfedge(face);
        const Kernel::Triangle_3 triangle(surface.point(surface.source(edge)), surface.point(surface.target(edge)),
                                          surface.point(surface.target(surface.next(edge))));
        quality.crossings += otherTree.do_intersect(triangle) ? 1 : 0;
    }
    return quality;
}

} // namespace

const bool canCompareSurfaces = true;

SurfaceComparison compareSurfaces(const std::array<TriangleMesh, 2>& fromData,
                                  const std::array<TriangleMesh, 2>& finest)
{
    const std::array coarse{meshOf(fromData[0]), meshOf(fromData[1])};
    std::array simplified{meshOf(finest[0]), meshOf(finest[1])};
    SurfaceComparison comparison;
    const auto start = std::chrono::steady_clock::now();
    simplify(simplified[0], fromData[0].triangles.size());
    comparison.simplifyingSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    simplify(simplified[1], fromData[1].triangles.size());
    comparison.fromData = qualityOf(coarse[0], coarse[1], finest[0]);
    comparison.simplified = qualityOf(simplified[0], simplified[1], finest[0]);
    return comparison;
}

} // namespace tetra
