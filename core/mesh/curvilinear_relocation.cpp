// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/curvilinear_relocation.h"

#include "core/base/simd.h"

#include <cstring>

namespace tetra {

namespace {

/// The lifted vertices of one tetrahedron and what a point's place in it needs.
struct LiftedFace {
    const Star::Face& face;
    const LiftedPoint& apex;
    const LiftedPoint& a;
    const LiftedPoint& b;
    const LiftedPoint& c;
};

struct PlacedPoints {
    const PackedPoint* points;
    const std::array<float, 4>* coordinates;
    std::size_t count;
};

TETRA_SIMD_CLONES void measure(const LiftedGrid& grid, const LiftedFace& lifted, const PlacedPoints& placed,
                               double* squaredErrors, double* squaredWarpings)
{
    const auto load = [](Double4& to, const LiftedPoint& from) { std::memcpy(&to, &from, sizeof to); };
    Double4 apex, a, b, c;
    load(apex, lifted.apex);
    load(a, lifted.a);
    load(b, lifted.b);
    load(c, lifted.c);
    a -= apex;
    b -= apex;
    c -= apex;
    const Star::Face& face = lifted.face;
    const Double4 slopeX = a * face.normals[0] + b * face.normals[4] + c * face.normals[8];
    const Double4 slopeY = a * face.normals[1] + b * face.normals[5] + c * face.normals[9];
    const Double4 slopeZ = a * face.normals[2] + b * face.normals[6] + c * face.normals[10];
    const double determinant = face.determinant();
    for (std::size_t i = 0; i < placed.count; ++i) {
        Double4 point;
        load(point, grid.at(placed.points[i]));
        const std::array<float, 4>& at = placed.coordinates[i];
        const Double4 residual =
            determinant * (point - apex) - slopeX * double(at[0]) - slopeY * double(at[1]) - slopeZ * double(at[2]);
        const Double4 squares = residual * residual;
        squaredErrors[i] = squares[3];
        squaredWarpings[i] = squares[0] + squares[1] + squares[2];
    }
}

} // namespace

void CurvilinearRelocation::weigh(const LiftedGrid& grid)
{
    for (std::size_t i = 0; i < placed().size(); ++i) {
        const double weight = grid.weight(placed()[i]);
        squaredErrors_[i] *= weight * weight;
        squaredWarpings_[i] *= weight * weight;
    }
}

void CurvilinearRelocation::run(const LiftedGrid& grid, const Star& star, std::span<const PackedPoint> points)
{
    placement_.run(grid.lattice(), star, points);
    rim_.resize(star.rim().size());
    for (std::size_t i = 0; i < rim_.size(); ++i)
        rim_[i] = grid.at(star.rim()[i]);
    squaredErrors_.resize(placed().size());
    squaredWarpings_.resize(placed().size());
    for (std::size_t f = 0; f < star.faceCount(); ++f) {
        const std::uint32_t first = offsets()[f];
        const std::uint32_t count = offsets()[f + 1] - first;
        if (count == 0)
            continue;
        const std::array<std::uint32_t, 3>& corners = star.corners()[f];
        const LiftedFace lifted{star.faces()[f], grid.at(star.apex()), rim_[corners[0]], rim_[corners[1]],
                                rim_[corners[2]]};
        measure(grid, lifted, {placed().data() + first, placement_.coordinates().data() + first, count},
                squaredErrors_.data() + first, squaredWarpings_.data() + first);
    }
    if (grid.weighted())
        weigh(grid);
}

} // namespace tetra
