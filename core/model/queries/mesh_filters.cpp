// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/mesh_filters.h"

#include "core/model/queries/tetrahedron_filters.h"
#include "core/model/queries/window_cut.h"

#include <algorithm>
#include <new>

namespace tetra {

namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// Tetrahedra between two looks at whether the work was cancelled.
constexpr std::size_t filteredAtOnce = 1 << 16;
constexpr std::string_view choosingCells = "Choosing from the mesh";

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
    try {
        return keepWindowUnguarded(mesh, window, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to cut a mesh of " + std::to_string(mesh.tetrahedra.size()) +
                         " tetrahedra at a window. Choose a larger error or a smaller window."};
    }
}

void dropUnusedVertices(ExtractedMesh& extracted)
{
    constexpr std::uint32_t unused = 0xffffffff;
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
    std::vector<std::uint32_t> numbers(count, unused);
    for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
        for (const std::uint32_t vertex : tetrahedron)
            numbers[vertex] = 0;
    std::uint32_t kept = 0;
    extracted.keptSites = 0;
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
        if (numbers[vertex] == unused)
            continue;
        extracted.keptSites += vertex < beforeCutting ? 1 : 0;
        mesh.positions[kept] = mesh.positions[vertex];
        mesh.values[kept] = mesh.values[vertex];
        extracted.sites[kept] = extracted.sites[vertex];
        if (!extracted.points.empty())
            extracted.points[kept] = extracted.points[vertex];
        numbers[vertex] = kept++;
    }
    mesh.positions.resize(kept);
    mesh.values.resize(kept);
    extracted.sites.resize(kept);
    if (!extracted.points.empty())
        extracted.points.resize(kept);
    for (Tetrahedron& tetrahedron : mesh.tetrahedra)
        for (std::uint32_t& vertex : tetrahedron)
            vertex = numbers[vertex];
}

} // namespace tetra
