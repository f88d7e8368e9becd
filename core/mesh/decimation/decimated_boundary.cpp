// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/decimated_mesh.h"
#include "core/mesh/rounding.h"

#include <algorithm>
#include <limits>

namespace tetra {

/// The key that the faces of the star opposite to its vertex have by the points outside: collapses leave it as it is.
double DecimatedMesh::keyOfFacesAround() const
{
    double largest = 0;
    if (input_.box)
        return largest;
    for (const std::uint32_t slot : star_.slots()) {
        const std::uint32_t opposite = mesh_.neighbours(slot)[indexOf(mesh_.vertices(slot), star_.vertex())];
        if (!CollapsibleMesh::isTriangle(opposite))
            continue;
        const BoundaryPoints::Relation& relation = boundaryPoints_[opposite];
        largest = std::max(largest, static_cast<double>(keyOf(relation.error, relation.warping)));
    }
    return largest;
}

/// The boundary triangles that go and come with a collapse.
void DecimatedMesh::setBoundaryChange(std::uint32_t linkPlace)
{
    const auto link = star_.link();
    addedTriangles_.clear();
    removedTriangles_.clear();
    for (const VertexStar::RimTriangle& rim : star_.rim()) {
        const std::uint32_t a = link[rim.corners[0]], b = link[rim.corners[1]];
        removedTriangles_.push_back({star_.vertex(), a, b});
        if (rim.corners[0] != linkPlace && rim.corners[1] != linkPlace)
            addedTriangles_.push_back({link[linkPlace], a, b});
    }
}

/// Some boundary triangle must be left that the points outside can be related to.
bool DecimatedMesh::boundaryAllows(std::uint32_t linkPlace)
{
    const auto comesWithTetrahedron = [&](const VertexStar::RimTriangle& rim) {
        return BoundaryJudge::comesWithTetrahedron(star_, rim, linkPlace);
    };
    if (std::ranges::none_of(star_.rim(), comesWithTetrahedron))
        return false;
    setBoundaryChange(linkPlace);
    return linkCondition_.allows(mesh_, star_, linkPlace) &&
           !boundary_->meetsItself(addedTriangles_, removedTriangles_);
}

bool DecimatedMesh::collapseOnBoundary(std::uint32_t vertex, std::uint32_t target)
{
    const auto link = star_.link();
    const auto place = static_cast<std::uint32_t>(std::ranges::find(link, target) - link.begin());
    if (!boundaryAllows(place))
        return false;
    boundary_->replace(removedTriangles_, addedTriangles_);
    boundaryJudge_.set(mesh_, star_, points_.points, boundaryPoints_);
    boundaryJudge_.evaluate(star_, place, fan_, std::numeric_limits<double>::infinity());
    mesh_.collapse(vertex, target);
    clearStates();
    for (const VertexStar::RimTriangle& rim : star_.rim())
        boundaryPoints_.clear(rim.triangle);
    relateToBoundary();
    return true;
}

/// Gives the points to the tetrahedra and boundary triangles that have them, as they were evaluated.
void DecimatedMesh::relateToBoundary()
{
    for (const BoundaryJudge::Error& error : boundaryJudge_.errors()) {
        if (error.keptBy != none)
            boundaryPoints_.takeOutside(error.keptBy, error.point);
        if (error.inFan != none) {
            TetrahedronState& state = mesh_.state(star_.slots()[error.inFan]);
            state.inside = pool_.appended(state.inside, {&error.point, 1});
            state.error = std::max(state.error, roundedUp(error.error));
        } else {
            boundaryPoints_.addOutside(error.triangle, error.point, roundedUp(error.error), roundedUp(error.warping));
        }
    }
    for (const BoundaryJudge::Warping& warping : boundaryJudge_.warpings())
        boundaryPoints_.addOfBoundary(warping.triangle, warping.point, roundedUp(warping.warping));
}

} // namespace tetra
