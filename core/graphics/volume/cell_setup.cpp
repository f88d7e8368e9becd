// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/cell_setup.h"

#include "core/graphics/volume/cell_geometry.h"

#include <algorithm>

namespace tetra {
namespace {

/// Of a cell whose volume is less than this part of the box of its edges, the gradient is not trusted.
constexpr float thinnestCell = 1e-5f;
/// A face's bound rises by no more than this a sample, so that faces seen edge-on have one.
constexpr float steepestBound = 1e7f;

struct SetupLanes {
    Float8 bound[3][4]; ///< a, b, c of each face
    Float8 outside[4];  ///< positive if the face is seen from outside
    Float8 slope[3];
    Float8 constant;
    Float8 smallest, largest;
    Float8 chord; ///< not less than the longest way through the cell, in w
    Float8 volume, edgeBox;
};

[[gnu::always_inline]] inline Float8 smaller(Float8 a, Float8 b)
{
    return a < b ? a : b;
}
[[gnu::always_inline]] inline Float8 larger(Float8 a, Float8 b)
{
    return a > b ? a : b;
}
[[gnu::always_inline]] inline Float8 magnitude(Float8 a)
{
    return larger(a, -a);
}
[[gnu::always_inline]] inline Float8 extent(const Float8 (&of)[4])
{
    return larger(larger(of[0], of[1]), larger(of[2], of[3])) - smaller(smaller(of[0], of[1]), smaller(of[2], of[3]));
}

[[gnu::always_inline]] inline void makeBounds(const CellPlanes& planes, Float8 sign, bool perspective,
                                              SetupLanes& lanes)
{
    for (int face = 0; face < 4; ++face) {
        // Inside is a x + b y + c >= outside * q.
        const Float8 a = planes.u[face] * sign, b = planes.v[face] * sign;
        const Float8 c = (perspective ? planes.w[face] : -planes.offset[face]) * sign;
        const Float8 outside = (perspective ? planes.offset[face] : planes.w[face]) * sign;
        const Float8 least = (magnitude(a) + magnitude(b)) * (1 / steepestBound);
        const Float8 steep = outside < 0.0f ? smaller(outside, -least) : larger(outside, least);
        const Float8 safe = magnitude(steep) > 1e-36f ? steep : Float8{} + 1e-36f;
        const Float8 scale = 1.0f / safe;
        lanes.bound[0][face] = a * scale;
        lanes.bound[1][face] = b * scale;
        lanes.bound[2][face] = c * scale;
        lanes.outside[face] = safe;
    }
}

[[gnu::always_inline]] inline void makeField(const CellCorners& c, const CellPlanes& planes, bool perspective,
                                             SetupLanes& lanes)
{
    const Float8 safe = magnitude(planes.volume) > 1e-36f ? planes.volume : Float8{} + 1e-36f;
    const Float8 scale = 1.0f / safe;
    Float8 u = {}, v = {}, w = {};
    for (int i = 1; i < 4; ++i) {
        const Float8 difference = (c.value[i] - c.value[0]) * scale;
        u += difference * planes.u[i];
        v += difference * planes.v[i];
        w += difference * planes.w[i];
    }
    const Float8 atOrigin = c.value[0] - (u * c.u[0] + v * c.v[0] + w * c.w[0]);
    lanes.slope[0] = u;
    lanes.slope[1] = v;
    lanes.slope[2] = perspective ? w : atOrigin;
    lanes.constant = perspective ? atOrigin : -w;
    lanes.smallest = smaller(smaller(c.value[0], c.value[1]), smaller(c.value[2], c.value[3]));
    lanes.largest = larger(larger(c.value[0], c.value[1]), larger(c.value[2], c.value[3]));
}

/// Eight cells; `binned` has that many.
TETRA_SIMD_CLONES void setUpLanes(const SetupSource& source, const TileFrame& frame, const BinnedCell* binned,
                                  SetupLanes& lanes)
{
    const bool perspective = source.perspective;
    const std::array<std::uint32_t, 4>* cells[8];
    for (std::size_t lane = 0; lane < 8; ++lane)
        cells[lane] = source.tetrahedra.data() + binned[lane].cell;
    CellCorners corners;
    loadCorners(source.vertices.data(), cells, corners);
    for (int i = 0; i < 4; ++i) {
        corners.u[i] -= perspective ? corners.w[i] * frame.x : Float8{} + frame.x;
        corners.v[i] -= perspective ? corners.w[i] * frame.y : Float8{} + frame.y;
    }
    CellPlanes planes;
    makePlanes(corners, planes);
    const Float8 sign = planes.volume < 0.0f ? Float8{} - 1.0f : Float8{} + 1.0f;
    makeBounds(planes, sign, perspective, lanes);
    makeField(corners, planes, perspective, lanes);
    lanes.chord = extent(corners.w);
    lanes.volume = magnitude(planes.volume);
    lanes.edgeBox = extent(corners.u) * extent(corners.v) * extent(corners.w);
}

CellSetup cellOfLane(const SetupLanes& lanes, std::size_t lane, const SetupSource& source, const TileFrame& frame,
                     const BinnedCell& binned)
{
    CellSetup setup;
    std::fill(std::begin(setup.fronts), std::end(setup.fronts), AffineFunction{0, 0, farBound});
    std::fill(std::begin(setup.backs), std::end(setup.backs), AffineFunction{0, 0, -farBound});
    std::size_t fronts = 0, backs = 0;
    for (std::size_t face = 0; face < 4; ++face) {
        const AffineFunction bound = {lanes.bound[0][face][lane], lanes.bound[1][face][lane],
                                      lanes.bound[2][face][lane]};
        const bool isFront = lanes.outside[face][lane] > 0;
        AffineFunction& slot = isFront     ? setup.fronts[std::min<std::size_t>(fronts, 2)]
                               : backs < 3 ? setup.backs[backs]
                                           : setup.fronts[0];
        slot = bound;
        (isFront ? fronts : backs) += 1;
    }
    setup.around = backs > 3;
    const CellClass ofCell = source.classes[binned.cell];
    setup.slope = {lanes.slope[0][lane], lanes.slope[1][lane], lanes.slope[2][lane]};
    setup.constant = lanes.constant[lane];
    setup.smallest = lanes.smallest[lane];
    setup.largest = lanes.largest[lane];
    setup.firstSegment = ofCell.first;
    setup.lastSegment = ofCell.last;
    setup.left = binned.left;
    setup.top = binned.top;
    setup.right = binned.right;
    setup.bottom = binned.bottom;
    const float volume = lanes.volume[lane];
    setup.flat = !(volume > 1e-35f) || fronts > 3;
    setup.simple = ofCell.first == ofCell.last && volume > thinnestCell * lanes.edgeBox[lane];
    if (setup.simple)
        (source.perspective ? setup.constant : setup.slope.c) -= source.segments[ofCell.first].origin;
    float extinction = 0;
    for (std::size_t segment = ofCell.first; segment <= ofCell.last; ++segment)
        extinction = std::max(extinction, source.segments[segment].largestExtinction);
    setup.thick = extinction * lanes.chord[lane] * frame.longestRay > 1;
    return setup;
}

} // namespace

void setUpCells(const SetupSource& source, const TileFrame& frame, std::span<const BinnedCell> cells,
                std::span<CellSetup> setups)
{
    for (std::size_t first = 0; first < cells.size(); first += 8) {
        const std::size_t count = std::min<std::size_t>(8, cells.size() - first);
        BinnedCell eight[8];
        for (std::size_t lane = 0; lane < 8; ++lane)
            eight[lane] = cells[first + std::min(lane, count - 1)];
        SetupLanes lanes;
        setUpLanes(source, frame, eight, lanes);
        for (std::size_t lane = 0; lane < count; ++lane)
            setups[first + lane] = cellOfLane(lanes, lane, source, frame, eight[lane]);
    }
}

} // namespace tetra
