// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/cell_setup.h"

#include "core/graphics/volume/cell_geometry.h"
#include "core/graphics/volume/slab_integral.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Of a cell whose volume is less than this part of the box of its edges, the gradient is not trusted.
constexpr float thinnestCell = 1e-5f;
/// A cell is flat if its volume could be rounding: if moving its corners by this part of their distances could undo it.
constexpr float roundingShare = 2.5e-7f;
/// A face's bound rises by no more than this a sample, so that faces seen edge-on have one.
constexpr float steepestBound = 1e7f;

/// Eight cells; a row for each.
struct SetupRows {
    Float4 faces[4][8]; ///< a, b, c of the bound, and positive if the face is seen from outside
    Float4 slopes[8];   ///< a, b, c, and the constant
    Float4 values[8];   ///< smallest, largest, the longest way through the cell in w, and above 0 if it is not thin
};

TETRA_SIMD_INLINE Float8 smaller(Float8 a, Float8 b)
{
    return a < b ? a : b;
}
TETRA_SIMD_INLINE Float8 larger(Float8 a, Float8 b)
{
    return a > b ? a : b;
}
TETRA_SIMD_INLINE Float8 magnitude(Float8 a)
{
    return larger(a, -a);
}
TETRA_SIMD_INLINE Float8 extent(const Float8 (&of)[4])
{
    return larger(larger(of[0], of[1]), larger(of[2], of[3])) - smaller(smaller(of[0], of[1]), smaller(of[2], of[3]));
}

TETRA_SIMD_INLINE void makeBounds(const CellPlanes& planes, Float8 sign, bool perspective, SetupRows& rows)
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
        transposeBack(a * scale, b * scale, c * scale, safe, rows.faces[face]);
    }
}

TETRA_SIMD_INLINE void makeField(const CellCorners& c, const CellPlanes& planes, bool perspective,
                                 Float8 roundingVolume, SetupRows& rows)
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
    transposeBack(u, v, perspective ? w : atOrigin, perspective ? atOrigin : -w, rows.slopes);
    const Float8 volume = magnitude(planes.volume);
    const Float8 thin = extent(c.u) * extent(c.v) * extent(c.w) * thinnestCell;
    transposeBack(smaller(smaller(c.value[0], c.value[1]), smaller(c.value[2], c.value[3])),
                  larger(larger(c.value[0], c.value[1]), larger(c.value[2], c.value[3])), extent(c.w),
                  volume > larger(roundingVolume, Float8{} + 1e-35f) ? volume - thin : Float8{} - farBound,
                  rows.values);
}

/// `binned` are eight cells.
TETRA_SIMD_CLONES void setUpRows(const SetupSource& source, const TileFrame& frame, const BinnedCell* binned,
                                 SetupRows& rows)
{
    const bool perspective = source.perspective;
    const std::array<std::uint32_t, 4>* cells[8];
    for (std::size_t lane = 0; lane < 8; ++lane)
        cells[lane] = source.tetrahedra.data() + binned[lane].cell;
    CellCorners corners;
    loadCorners(source.vertices.data(), cells, corners);
    const Float8 farW = magnitude(corners.w[0]) + extent(corners.w);
    const Float8 farU = magnitude(corners.u[0]) + extent(corners.u);
    const Float8 farV = magnitude(corners.v[0]) + extent(corners.v);
    for (int i = 0; i < 4; ++i) {
        corners.u[i] -= perspective ? corners.w[i] * frame.x : Float8{} + frame.x;
        corners.v[i] -= perspective ? corners.w[i] * frame.y : Float8{} + frame.y;
    }
    CellPlanes planes;
    makePlanes(corners, planes);
    makeBounds(planes, planes.volume < 0.0f ? Float8{} - 1.0f : Float8{} + 1.0f, perspective, rows);
    const Float8 widthU = extent(corners.u), widthV = extent(corners.v), widthW = extent(corners.w);
    const Float8 roundingVolume =
        roundingShare * (farU * widthV * widthW + farV * widthU * widthW + farW * widthU * widthV);
    makeField(corners, planes, perspective, roundingVolume, rows);
}

AffineFunction functionOf(const Float4& row)
{
    AffineFunction function;
    std::memcpy(&function, &row, sizeof function);
    return function;
}

/// Puts the faces' bounds where they belong and tells how many of them are fronts.
std::size_t arrangeFaces(const SetupRows& rows, std::size_t row, CellSetup& setup)
{
    for (std::size_t i = 0; i < 3; ++i) {
        setup.functions[i] = {0, 0, farBound, 0};
        setup.functions[3 + i] = {0, 0, -farBound, 0};
    }
    std::size_t fronts = 0, backs = 0;
    for (const auto& face : rows.faces) {
        // Of four of one kind the last goes to where the other kind has none.
        constexpr std::size_t places[2][4] = {{3, 4, 5, 0}, {0, 1, 2, 3}};
        const bool front = face[row][3] > 0;
        setup.functions[places[front][front ? fronts : backs]] = functionOf(face[row]);
        fronts += front;
        backs += !front;
    }
    return fronts;
}

Direction directionOf(const CellSetup& setup, bool perspective)
{
    if (!perspective)
        return setup.constant < 0 ? Direction::Rising : Direction::Falling;
    // An affine function has its extremes at the corners of the box.
    const auto& [a, b, c, unused] = setup.functions[6];
    const float left = a * static_cast<float>(setup.left * blockWidth);
    const float right = a * static_cast<float>(setup.right * blockWidth);
    const float top = b * static_cast<float>(setup.top * blockHeight) + c;
    const float bottom = b * static_cast<float>(setup.bottom * blockHeight) + c;
    if (std::min(left, right) + std::min(top, bottom) > 0)
        return Direction::Rising;
    return std::max(left, right) + std::max(top, bottom) < 0 ? Direction::Falling : Direction::Mixed;
}

/// 1 / length of the gradient, in values for one unit of w across the picture; 0 without a gradient.
float perGradientOf(const SetupRows& rows, std::size_t row, const SetupSource& source, const TileFrame& frame)
{
    const float u = rows.slopes[row][0], v = rows.slopes[row][1];
    const float w = source.perspective ? rows.slopes[row][2] - u * frame.x - v * frame.y : -rows.slopes[row][3];
    const float acrossU = u * source.lengths[0], acrossV = v * source.lengths[1];
    const float squared = acrossU * acrossU + acrossV * acrossV + w * w;
    return squared > 1e-30f ? 1 / std::sqrt(squared) : 0;
}

void finish(const SetupRows& rows, std::size_t row, const SetupSource& source, const TileFrame& frame,
            const BinnedCell& binned, CellSetup& setup)
{
    const std::size_t fronts = arrangeFaces(rows, row, setup);
    const CellClass ofCell = source.classes[binned.cell];
    setup.functions[6] = functionOf(rows.slopes[row]);
    setup.constant = rows.slopes[row][3];
    setup.smallest = rows.values[row][0];
    setup.largest = rows.values[row][1];
    setup.perGradient = source.shaded ? perGradientOf(rows, row, source, frame) : 0;
    setup.firstSegment = ofCell.first;
    setup.lastSegment = ofCell.last;
    setup.left = binned.left;
    setup.top = binned.top;
    setup.right = binned.right;
    setup.bottom = binned.bottom;
    setup.flat = rows.values[row][3] == -farBound || fronts > 3;
    setup.around = fronts == 0;
    setup.simple = ofCell.first == ofCell.last && rows.values[row][3] > 0;
    if (setup.simple)
        (source.perspective ? setup.constant : setup.functions[6].c) -= source.segments[ofCell.first].origin;
    float extinction = 0;
    for (std::size_t segment = ofCell.first; segment <= ofCell.last; ++segment)
        extinction = std::max(extinction, source.segments[segment].largestExtinction);
    const float depth = extinction * rows.values[row][2] * frame.longestRay;
    setup.thickness = depth <= faintDepth ? Thickness::Faint : depth <= 1 ? Thickness::Thin : Thickness::Thick;
    setup.direction = setup.simple ? Direction::Mixed : directionOf(setup, source.perspective);
}

} // namespace

void setUpCells(const SetupSource& source, const TileFrame& frame, std::span<const BinnedCell> cells,
                std::span<CellSetup> setups)
{
    for (const BinnedCell& cell : cells) {
        __builtin_prefetch(&source.tetrahedra[cell.cell]);
        __builtin_prefetch(&source.classes[cell.cell]);
    }
    for (std::size_t first = 0; first < cells.size(); first += 8) {
        const std::size_t count = std::min<std::size_t>(8, cells.size() - first);
        BinnedCell eight[8];
        for (std::size_t lane = 0; lane < 8; ++lane)
            eight[lane] = cells[first + std::min(lane, count - 1)];
        SetupRows rows;
        setUpRows(source, frame, eight, rows);
        for (std::size_t row = 0; row < count; ++row)
            finish(rows, row, source, frame, eight[row], setups[first + row]);
    }
}

} // namespace tetra
