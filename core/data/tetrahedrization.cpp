// SPDX-License-Identifier: GPL-3.0-or-later
// Of CGAL, so it is compiled with -frounding-math, apart from the rest.
#include <tan/data.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>; // point
using PointDelaunay = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;

/// The points of a property map's keys, as CGAL wants them.
struct PlaceOfPoint {
    using key_type = std::uint32_t;
    using value_type = Kernel::Point_3;
    using reference = Kernel::Point_3;
    using category = boost::readable_property_map_tag;
    const std::vector<Eigen::Vector3d>* positions;
    friend Kernel::Point_3 get(const PlaceOfPoint& map, std::uint32_t point)
    {
        const Eigen::Vector3d& place = (*map.positions)[point];
        return {place.x(), place.y(), place.z()};
    }
};

/// The smallest corner first, then the smallest of the others, the hand kept.
std::array<std::uint32_t, 4> inOrder(std::array<std::uint32_t, 4> corners)
{
    if (const auto least = std::ranges::min_element(corners); least != corners.begin()) {
        std::swap(corners[0], *least);
        std::swap(corners[2], corners[3]);
    }
    std::rotate(corners.begin() + 1, std::min_element(corners.begin() + 1, corners.end()), corners.end());
    return corners;
}

} // namespace

Result<Dataset> tetrahedrized(const Dataset& points, const Progress& progress)
{
    const std::vector<Eigen::Vector3d>& positions = *points.positions;
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    const PlaceOfPoint places{&positions};
    // What lies near in space comes after each other: then each point is found from the last one.
    CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_3<Kernel, PlaceOfPoint>(places));
    PointDelaunay delaunay;
    PointDelaunay::Cell_handle hint{};
    constexpr std::size_t pointsBetweenReports = 4096;
    for (std::size_t number = 0; number < order.size(); ++number) {
        if (number % pointsBetweenReports == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("The tetrahedralization"));
            progress.report(static_cast<double>(number) / static_cast<double>(order.size()),
                            Message::marked("Tetrahedralizing the points"));
        }
        const auto vertex = delaunay.insert(get(places, order[number]), hint);
        vertex->info() = order[number];
        hint = vertex->cell();
    }
    if (delaunay.dimension() < 3 || delaunay.number_of_vertices() != positions.size())
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "All points of '%1' lie in a plane, or there are fewer than four. TAn needs points that have a "
                "volume between them.",
                points.source.name)};
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    tetrahedra.reserve(delaunay.number_of_finite_cells());
    for (const PointDelaunay::Cell_handle cell : delaunay.finite_cell_handles())
        tetrahedra.push_back(inOrder(
            {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()}));
    std::ranges::sort(tetrahedra);
    Dataset mesh = points;
    mesh.domain = DomainClass::Irregular;
    mesh.tetrahedra = std::make_shared<const std::vector<std::array<std::uint32_t, 4>>>(std::move(tetrahedra));
    mesh.convex = true;
    return mesh;
}

} // namespace tetra
