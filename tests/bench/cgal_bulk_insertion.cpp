// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/cgal_bulk_insertion.h"

#include "tests/bench/bench_report.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace tetra {

double cgalBulkInsertionSeconds(std::uint32_t n, std::size_t& cells)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Compact_location>;
    std::vector<Kernel::Point_3> points;
    points.reserve(std::size_t(n) * n * n);
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x)
                points.emplace_back(x, y, z);
    Delaunay delaunay;
    const double seconds = secondsOf([&] { delaunay.insert(points.begin(), points.end()); });
    cells = delaunay.number_of_finite_cells();
    return seconds;
}

} // namespace tetra
