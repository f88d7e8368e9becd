// SPDX-License-Identifier: GPL-3.0-or-later
// All of CGAL is in this source: its headers are heavy, and it is compiled with -frounding-math.
#include "core/refine/free/scattered_delaunay.h"

#include "core/mesh/topology.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Extreme_points_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace tetra {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>; // point
using CellBase = CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel>>; // slot
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

Error notEnough(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("%1 A tetrahedral mesh needs four points that do not lie in one plane.", what)};
}

/// The points of a property map's keys, as CGAL wants them.
struct PointOfIndex {
    using key_type = std::uint32_t;
    using value_type = Point;
    using reference = const Point&;
    using category = boost::lvalue_property_map_tag;
    const std::vector<Point>* points;
    friend const Point& get(const PointOfIndex& map, std::uint32_t index) { return (*map.points)[index]; }
    const Point& operator[](std::uint32_t index) const { return (*points)[index]; }
};

} // namespace

struct ScatteredDelaunay::Mesh {
    std::vector<Point> points;
    Delaunay delaunay;
    std::vector<Delaunay::Cell_handle> cells; ///< by slot
    std::vector<std::uint32_t> freeSlots;
    std::vector<Delaunay::Cell_handle> conflicts;
    std::vector<Delaunay::Cell_handle> star; ///< of the last insertion
    Delaunay::Vertex_handle apex;            ///< its vertex

    /// Why no tetrahedron has its corners among the points.
    Status checkExtent() const
    {
        if (points.size() < 4)
            return notEnough(Message::say("There are only %1 points.", points.size()));
        const auto different = [&](const Point& p) { return p != points[0]; };
        const auto second = std::ranges::find_if(points, different);
        if (second == points.end())
            return notEnough(Message::say("All points lie at one place."));
        const auto offLine = [&](const Point& p) { return !CGAL::collinear(points[0], *second, p); };
        const auto third = std::find_if(second, points.end(), offLine);
        if (third == points.end())
            return notEnough(Message::say("All points lie on one line."));
        const auto offPlane = [&](const Point& p) { return !CGAL::coplanar(points[0], *second, *third, p); };
        if (std::none_of(second, points.end(), offPlane))
            return notEnough(Message::say("All points lie in one plane."));
        return {};
    }

    std::vector<std::uint32_t> hullCorners() const
    {
        std::vector<std::uint32_t> indices(points.size());
        std::iota(indices.begin(), indices.end(), 0);
        std::vector<std::uint32_t> corners;
        const CGAL::Extreme_points_traits_adapter_3<PointOfIndex, CGAL::Convex_hull_traits_3<Kernel>> traits(
            PointOfIndex{&points});
        CGAL::extreme_points_3(indices, std::back_inserter(corners), traits);
        std::ranges::sort(corners);
        return corners;
    }

    /// Cells and vertices as they are, by numbers: what an insertion makes depends on more than the geometry.
    void archive(StateArchive& archive);

    /// Gives the cell a slot, and its points, that of `first` in front.
    Cell take(Delaunay::Cell_handle handle, Delaunay::Vertex_handle first)
    {
        if (freeSlots.empty()) {
            freeSlots.push_back(static_cast<std::uint32_t>(cells.size()));
            cells.emplace_back();
        }
        const std::uint32_t slot = freeSlots.back();
        freeSlots.pop_back();
        cells[slot] = handle;
        handle->info() = slot;
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = handle->vertex(static_cast<int>(i))->info();
        return {slot, withCornerFirst(corners, static_cast<std::size_t>(handle->index(first)))};
    }
};

void ScatteredDelaunay::Mesh::archive(StateArchive& archive)
{
    struct VertexRecord {
        std::uint32_t point = none; ///< none: the one at infinity
        std::uint32_t cell = none;
    };
    struct CellRecord {
        std::array<std::uint32_t, 4> vertices{none, none, none, none}; ///< of a free slot none
        std::array<std::uint32_t, 4> neighbours{};
    };
    auto& structure = delaunay.tds();
    std::uint64_t slotCount = cells.size(), cellCount = slotCount;
    // The cells at infinity have no slots; for now they are numbered on from these.
    std::vector<Delaunay::Cell_handle> all = cells;
    std::vector<Delaunay::Vertex_handle> vertices;
    std::vector<std::uint32_t> numbers; ///< of vertices, by points
    if (!archive.isLoading()) {
        for (const std::uint32_t slot : freeSlots)
            all[slot] = {};
        for (const Delaunay::Cell_handle cell : delaunay.all_cell_handles())
            if (delaunay.is_infinite(cell)) {
                cell->info() = static_cast<std::uint32_t>(all.size());
                all.push_back(cell);
            }
        cellCount = all.size();
        vertices.push_back(delaunay.infinite_vertex());
        numbers.resize(points.size());
        for (const Delaunay::Vertex_handle vertex : delaunay.finite_vertex_handles()) {
            numbers[vertex->info()] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(vertex);
        }
    }
    archive(slotCount, cellCount, freeSlots);
    std::vector<VertexRecord> vertexRecords;
    for (const Delaunay::Vertex_handle vertex : vertices)
        vertexRecords.push_back({delaunay.is_infinite(vertex) ? none : vertex->info(), vertex->cell()->info()});
    archive(vertexRecords);
    const auto numberOf = [&](Delaunay::Vertex_handle vertex) {
        return delaunay.is_infinite(vertex) ? 0 : numbers[vertex->info()];
    };
    if (!archive.isLoading()) {
        for (const Delaunay::Cell_handle cell : all) {
            CellRecord record;
            for (int i = 0; i < 4 && cell != Delaunay::Cell_handle(); ++i) {
                record.vertices[static_cast<std::size_t>(i)] = numberOf(cell->vertex(i));
                record.neighbours[static_cast<std::size_t>(i)] = cell->neighbor(i)->info();
            }
            archive(record);
        }
        return;
    }
    std::vector<CellRecord> records(cellCount);
    archive.elements(std::span(records));
    structure.clear();
    structure.set_dimension(3);
    for (const VertexRecord& record : vertexRecords) {
        vertices.push_back(structure.create_vertex());
        vertices.back()->info() = record.point;
        if (record.point != none)
            vertices.back()->set_point(points[record.point]);
    }
    delaunay.set_infinite_vertex(vertices.front());
    all.assign(cellCount, {});
    for (std::uint32_t number = 0; number < cellCount; ++number)
        if (const auto& [a, b, c, d] = records[number].vertices; a != none) {
            all[number] = structure.create_cell(vertices[a], vertices[b], vertices[c], vertices[d]);
            all[number]->info() = number;
        }
    for (std::uint32_t number = 0; number < cellCount; ++number)
        for (int i = 0; i < 4 && all[number] != Delaunay::Cell_handle(); ++i)
            all[number]->set_neighbor(i, all[records[number].neighbours[static_cast<std::size_t>(i)]]);
    for (std::size_t number = 0; number < vertices.size(); ++number)
        vertices[number]->set_cell(all[vertexRecords[number].cell]);
    all.resize(slotCount);
    cells = std::move(all);
}

void ScatteredDelaunay::archive(StateArchive& archive)
{
    archive(*mesh_);
}

ScatteredDelaunay::ScatteredDelaunay(std::span<const Eigen::Vector3d> positions) : mesh_(std::make_unique<Mesh>())
{
    mesh_->points.reserve(positions.size());
    for (const Eigen::Vector3d& position : positions)
        mesh_->points.emplace_back(position[0], position[1], position[2]);
}

ScatteredDelaunay::~ScatteredDelaunay() = default;

Status ScatteredDelaunay::start()
{
    if (Status status = mesh_->checkExtent(); !status)
        return status;
    for (const std::uint32_t corner : mesh_->hullCorners())
        mesh_->delaunay.insert(mesh_->points[corner])->info() = corner;
    created_.clear();
    destroyed_.clear();
    for (const Delaunay::Cell_handle cell : mesh_->delaunay.finite_cell_handles())
        created_.push_back(mesh_->take(cell, cell->vertex(0)));
    return {};
}

std::uint32_t ScatteredDelaunay::locate(std::uint32_t point, std::uint32_t hint) const
{
    const Delaunay::Cell_handle cell = mesh_->delaunay.locate(mesh_->points[point], mesh_->cells[hint]);
    return mesh_->delaunay.is_infinite(cell) ? none : cell->info();
}

std::uint32_t ScatteredDelaunay::locateInStar(std::uint32_t point, std::uint32_t hint) const
{
    const Point& place = mesh_->points[point];
    const Delaunay::Cell_handle found = mesh_->delaunay.locate(place, mesh_->cells[hint]);
    if (found->has_vertex(mesh_->apex))
        return found->info();
    for (const Delaunay::Cell_handle cell : mesh_->star) {
        Delaunay::Locate_type type{};
        int i = 0, j = 0;
        if (mesh_->delaunay.side_of_cell(place, cell, type, i, j) != CGAL::ON_UNBOUNDED_SIDE)
            return cell->info();
    }
    return none;
}

void ScatteredDelaunay::insert(std::uint32_t point, std::uint32_t slot)
{
    Delaunay& delaunay = mesh_->delaunay;
    auto& conflicts = mesh_->conflicts;
    conflicts.clear();
    Delaunay::Facet boundary;
    delaunay.find_conflicts(mesh_->points[point], mesh_->cells[slot], CGAL::Oneset_iterator<Delaunay::Facet>(boundary),
                            std::back_inserter(conflicts));
    destroyed_.clear();
    for (const Delaunay::Cell_handle cell : conflicts)
        if (!delaunay.is_infinite(cell))
            destroyed_.push_back(cell->info());
    mesh_->freeSlots.insert(mesh_->freeSlots.end(), destroyed_.begin(), destroyed_.end());
    const Delaunay::Vertex_handle vertex = delaunay.insert_in_hole(mesh_->points[point], conflicts.begin(),
                                                                   conflicts.end(), boundary.first, boundary.second);
    vertex->info() = point;
    mesh_->apex = vertex;
    mesh_->star.clear();
    delaunay.finite_incident_cells(vertex, std::back_inserter(mesh_->star));
    created_.clear();
    for (const Delaunay::Cell_handle cell : mesh_->star)
        created_.push_back(mesh_->take(cell, vertex));
}

} // namespace tetra
