// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface_distance.h"
#include "core/mesh/surface_shape.h"
#include "core/render/isosurface/closed_surface.h"
#include "plugins/api/written_content.h"

#include <tan/base.h>
#include <tan/mesh.h>
#include <tan/query.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// What isosurfaces are made for: to be printed, say, as solids.
struct SurfaceMaking {
    std::optional<SolidSide> solid{}; ///< closed at the boundary of the mesh, around what lies on this side
    bool largestPart = false;         ///< of each surface that alone; of a solid its skin, so that hollows are filled
};

/// How far a surface is from that of the finest mesh of its model, made in the same way, and that from it.
struct SurfaceDeviation {
    SurfaceDistance toFinest;
    SurfaceDistance fromFinest;
    double largest() const { return std::max(toFinest.largest, fromFinest.largest); }
    double mean() const { return std::max(toFinest.mean, fromFinest.mean); }
};

/// The surface where the field has one value.
struct MadeSurface {
    double value = 0;
    TriangleMesh mesh;
    SurfaceShape shape{};
    std::optional<SurfaceDeviation> deviation{}; ///< if it was measured; none where one of the two surfaces is empty
    bool hasNoCounterpart = false;               ///< it was to be measured, and just one of the two surfaces is empty
};

/// The isosurfaces of a mesh; `cells`, if given, gets the tetrahedra of their triangles, one surface after the other,
/// and goes with plain surfaces alone, whose shapes are not looked for then. Errors: those of extractIsosurface() and
/// closedIsosurface().
Result<std::vector<MadeSurface>> makeSurfaces(const TetrahedralMesh& mesh, std::span<const double> isovalues,
                                              const SurfaceMaking& making, const Progress& progress,
                                              Buffer<std::uint32_t>* cells = nullptr);

/// Holds surfaces of the mesh that the query asked for against those of the finest mesh. The query has no range and no
/// values, and no window that does not cut. Errors: those of extraction, too.
Status measureDeviations(MeshExtractor& extractor, const MeshQuery& query, const SurfaceMaking& making,
                         std::span<MadeSurface> surfaces, const Progress& progress);

/// Adds the largest and the mean deviation of all, if they were measured: "deviation", "mean_deviation". None where a
/// surface has no counterpart, as a number would be taken for true of that, too.
void addDeviation(std::span<const MadeSurface> surfaces, MeshFacts& facts);

/// Whether it is closed, of how many parts, how large, and how far from the finest, in a unit of length if that is not
/// empty: a sentence.
Message shapeText(const MadeSurface& surface, const std::string& lengthUnit);

/// Why the file states no deviation, of a surface without a counterpart.
Message missingDeviationText(const MadeSurface& surface);

} // namespace tetra
