// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/result.h"
#include "core/data/scalar_field.h"
#include "core/history/extraction.h"
#include "core/history/query/error_field.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace tetra {

/// What becomes of the tetrahedra at the border of a window (S17).
enum class WindowBorder {
    Intersecting, ///< all that have a point in common with the window: it is covered, the border is ragged
    Contained,    ///< only those that lie in it whole
    Clipped,      ///< the mesh cut off at the window: conforming, filling exactly what of the domain lies in it
};

struct Window {
    Box box;
    WindowBorder border = WindowBorder::Intersecting;
    bool operator==(const Window&) const = default;
};

/// How a mesh of varying accuracy is found.
enum class VariableMethod {
    Automatic, ///< the one of the two that is predicted to give the smaller mesh, where both can be used
    ClosedSet, ///< the smallest closed set of the history's sites: always right, tight for graded fields
    Insertion, ///< the sites of the focus inserted into the coarse mesh: tight for a sharp focus, lattices only
};

/// Where less than this is asked, a budget or a model that has nothing finer counts from here: 0 times anything is 0.
inline constexpr double leastScaledPercent = 0.001;

/// What a mesh of this scale (ExtractedMesh::scale) keeps where `asked` was asked for, in the same percent.
constexpr double keptPercent(double asked, double scale)
{
    return scale > 1 ? scale * (asked > leastScaledPercent ? asked : leastScaledPercent) : asked;
}

/// A question to a model, as a value (R14, R17, R25, B1). Everything can be combined: accuracy or field or budget
/// choose a conforming mesh of the whole domain, then values and window choose from its tetrahedra.
struct MeshQuery {
    ErrorField error = 0.0;          ///< at most this at each sample, % of the value range
    ErrorField warping = anyWarping; ///< likewise, % of the diagonal: curvilinear and irregular data only
    /// At most so many tetrahedra in the whole mesh: error and warping are multiplied by the least number, at least 1,
    /// with which that is so (keptPercent()). Insertion looks for it with a few meshes and may leave a tenth unused.
    std::optional<std::uint64_t> budget;
    /// Only tetrahedra that can contain a value of one of these ranges, ends included. Empty: all.
    std::vector<ValueRange> values;
    std::optional<Window> window;
    VariableMethod method = VariableMethod::Automatic;
};

bool operator==(const MeshQuery& first, const MeshQuery& second);

/// What a query gives. Immutable once it is handed out, as std::shared_ptr<const ExtractedMesh>.
struct ExtractedMesh {
    static constexpr std::uint32_t noSite = 0xffffffff;

    TetrahedralMesh mesh;
    /// The model's site that each vertex is; noSite for a vertex that cutting at the window made or that is a point of
    /// the dataset that never became a site.
    Buffer<std::uint32_t> sites;
    /// Empty, or for each vertex that is no site its point of the dataset; noSite for all others.
    Buffer<std::uint32_t> points;
    /// What was chosen before values and window.
    std::uint32_t wholeSites = 0;
    std::uint64_t wholeTetrahedra = 0;
    /// What of that is in the mesh, whole or in part: a tetrahedron that a window has cut into pieces counts once, and
    /// the vertices that cutting made do not.
    std::uint32_t keptSites = 0;
    std::uint64_t keptTetrahedra = 0;
    /// The mesh is known to keep keptPercent(asked, scale) everywhere: 1, or more if the budget did not allow it or the
    /// model has nothing finer.
    double scale = 1;
    VariableMethod method = VariableMethod::ClosedSet; ///< that was used; a uniform mesh is a closed set, too
};

/// An error (WrongUsage) that says what to change if the query makes no sense for any mesh of the model: not a number,
/// a box or range upside down, a budget of nothing.
Status checkQuery(const Model& model, const MeshQuery& query);

/// ExtractedMesh::scale of a uniform mesh.
double scaleReached(const MeshSize& size, const Accuracy& asked);

/// A query with a focus as two queries of one resolution each, to be blended when they are drawn (R24), where the query
/// itself asks for one conforming mesh (R25).
struct TwoResolutions {
    MeshQuery outside; ///< of the whole domain
    MeshQuery inside;  ///< of a window that holds all that is nearer to the region than `border`
    std::variant<Box, Sphere> region;
    double border = 0; ///< the focus' falloff

    bool operator==(const TwoResolutions&) const = default;
};

/// Nothing if the error does not depend on the place by a single ramp around a box or a ball, or if there is a budget:
/// what part of it either mesh should have is not said.
std::optional<TwoResolutions> twoResolutions(const MeshQuery& query);

} // namespace tetra
