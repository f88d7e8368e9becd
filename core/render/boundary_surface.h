// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/render/scene.h"
#include "core/transfer/transfer_function.h"

#include <memory>

namespace tetra {

/// Where the boundary turns by more than this many degrees there is an edge to see; less is a curve in few faces.
inline constexpr double usualFeatureAngle = 30;

/// The boundary of a mesh as a surface: its boundaryFaces(), cavities and all components included, counterclockwise
/// seen from outside, with the values of the field. Normals look outwards and are smooth where neighbouring triangles
/// turn by at most `featureAngle` degrees, 0 for flat ones: means of the triangles' normals, weighted by their angles
/// (G. Thürmer and C. Wüthrich, "Computing vertex normals from polygonal facets", 1998). At a sharper edge, and where
/// other than two triangles meet, a vertex comes once for each side. O(vertices + tetrahedra + boundary log boundary),
/// the same result with any number of threads. Errors: cancelled, too many tetrahedra, not enough memory.
Result<TriangleMesh> extractBoundary(const TetrahedralMesh& mesh, double featureAngle = usualFeatureAngle,
                                     const Progress& progress = {});

/// The surface with the colours that a transfer function gives its values, whatever their opacity; the surface must
/// have values. Between two points of the function, colours are linear in the value, and so they are on a triangle:
/// each triangle is cut where its value is that of a point (R22), so that the colours are exact at any place, steps
/// included, however large the triangles are. Triangles that share an edge are cut at the same places, bit for bit. A
/// function without points, and a surface without values, leave the surface as it is. O(triangles + pieces). May throw
/// std::bad_alloc.
TriangleMesh colouredByValue(const TriangleMesh& surface, const TransferFunction& function);

/// What the boundary of a mesh looks like.
struct BoundaryLook {
    Colour colour{0.60f, 0.64f, 0.70f}; ///< nearly grey, so that it is no value's colour, and seen on light and dark
    float opacity = 1;                  ///< in (0, 1]
    bool backFacesOnly = false;         ///< what faces the eye is left out, so that one sees into the domain
};

/// Makes the boundary of one mesh, in a look that changes: extracted once, coloured anew for another transfer function.
/// Used from one thread at a time.
class BoundaryCache {
public:
    explicit BoundaryCache(std::shared_ptr<const TetrahedralMesh> mesh) : mesh_(std::move(mesh)) {}

    /// Errors: those of extractBoundary(), an opacity outside (0, 1].
    Result<Surface> plain(const BoundaryLook& look, const Progress& progress = {});
    /// In the colours of the field's values (colouredByValue()). Errors: the same, and those of
    /// checkTransferFunction().
    Result<Surface> coloured(const TransferFunction& function, const BoundaryLook& look, const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> mesh_;
    std::shared_ptr<const TriangleMesh> boundary_;
    TransferFunction function_; ///< that `coloured_` has its colours from
    std::shared_ptr<const TriangleMesh> coloured_;
};

} // namespace tetra
