// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/cell_setup.h"

#include "core/render/order/cell_geometry.h"
#include "core/render/volume/slab_integral.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tetra {
namespace {

/// Of a cell whose volume is less than this part of the box of its edges, the gradient is not trusted.
constexpr float thinnestCell = 1e-5f;
/// A cell is flat if its volume could be rounding: if moving its corners by this part of their distances could undo it.
constexpr float setupRounding = 2.5e-7f;
/// A face's bound rises by no more than this a sample, so that faces seen edge-on have one.
constexpr float steepestBound = 1e7f;

/// Eight cells; a row for each.
struct SetupRows {
    Float4 faces[6][8];  ///< a, b, c of the bound; after the cell's four, what does not bind as a front and as a back
    Float4 slopes[8];    ///< a, b, c
    Float4 fields[8];    ///< the constant, smallest, largest
    Float4 lights[3][8]; ///< of CellLight; if cells are lit
    Int8 fronts;         ///< bit f: face f is seen from outside
    Int8 simple, flat;   ///< 0 or 1
    Int8 thickness, direction;
};

/// What the transfer function says of eight cells.
struct TransferOfCells {
    Float8 extinction; ///< the largest
    Float8 origin;     ///< of the first segment
    Int8 oneSegment;   ///< 0 or -1
};

TETRA_SIMD_INLINE Float8 smallerOf(Float8 a, Float8 b)
{
    return a < b ? a : b;
}
TETRA_SIMD_INLINE Float8 largerOf(Float8 a, Float8 b)
{
    return a > b ? a : b;
}
TETRA_SIMD_INLINE Float8 magnitude(Float8 a)
{
    return largerOf(a, -a);
}
TETRA_SIMD_INLINE Float8 extent(const Float8 (&of)[4])
{
    return largerOf(largerOf(of[0], of[1]), largerOf(of[2], of[3])) -
           smallerOf(smallerOf(of[0], of[1]), smallerOf(of[2], of[3]));
}

TETRA_SIMD_INLINE void makeBounds(const CellPlanes& planes, Float8 sign, bool perspective, SetupRows& rows)
{
    rows.fronts = Int8{};
    for (int face = 0; face < 4; ++face) {
        // Inside is a x + b y + c >= outside * q.
        const Float8 a = planes.u[face] * sign, b = planes.v[face] * sign;
        const Float8 c = (perspective ? planes.w[face] : -planes.offset[face]) * sign;
        const Float8 outside = (perspective ? planes.offset[face] : planes.w[face]) * sign;
        const Float8 least = (magnitude(a) + magnitude(b)) * (1 / steepestBound);
        const Float8 steep = outside < 0.0f ? smallerOf(outside, -least) : largerOf(outside, least);
        const Float8 safe = magnitude(steep) > 1e-36f ? steep : Float8{} + 1e-36f;
        const Float8 scale = 1.0f / safe;
        transposeBack(a * scale, b * scale, c * scale, safe, rows.faces[face]);
        rows.fronts |= safe > 0.0f ? Int8{} + (1 << face) : Int8{};
    }
}

/// How the values change along the rays.
TETRA_SIMD_INLINE Int8 directionOf(Float8 a, Float8 b, Float8 c, Float8 constant, const BinnedCell* binned,
                                   bool perspective)
{
    constexpr int rising = static_cast<int>(Direction::Rising), falling = static_cast<int>(Direction::Falling);
    const Int8 known = constant < 0.0f ? Int8{} + rising : Int8{} + falling;
    if (!perspective)
        return known;
    // Each box is the second of a binned cell's two words, a byte a side.
    static_assert(sizeof(BinnedCell) == 8 && std::endian::native == std::endian::little);
    Int8 words[2];
    std::memcpy(words, binned, sizeof words);
    const Int8 boxes = __builtin_shufflevector(words[0], words[1], 1, 3, 5, 7, 9, 11, 13, 15);
    const Float8 left = a * __builtin_convertvector((boxes & 255) * blockWidth, Float8);
    const Float8 top = b * __builtin_convertvector((boxes >> 8 & 255) * blockHeight, Float8) + c;
    const Float8 right = a * __builtin_convertvector((boxes >> 16 & 255) * blockWidth, Float8);
    const Float8 bottom = b * __builtin_convertvector((boxes >> 24 & 255) * blockHeight, Float8) + c;
    // An affine function has its extremes at the corners of the box.
    const Float8 lowest = smallerOf(left, right) + smallerOf(top, bottom);
    const Float8 highest = largerOf(left, right) + largerOf(top, bottom);
    const Int8 mixed = highest < 0.0f ? Int8{} + falling : Int8{} + static_cast<int>(Direction::Mixed);
    return lowest > 0.0f ? Int8{} + rising : mixed;
}

/// An affine function of (u, v, w) in the cells from its values at their corners, as a function of the samples.
struct CellFunction {
    Float8 u, v, slope, constant;

    TETRA_SIMD_INLINE CellFunction(const CellCorners& c, const CellPlanes& planes, Float8 perVolume,
                                   const Float8 (&values)[4], Float8 origin, bool perspective)
    {
        Float8 w = {};
        u = v = Float8{};
        for (int i = 1; i < 4; ++i) {
            const Float8 difference = (values[i] - values[0]) * perVolume;
            u += difference * planes.u[i];
            v += difference * planes.v[i];
            w += difference * planes.w[i];
        }
        const Float8 atOrigin = values[0] - (u * c.u[0] + v * c.v[0] + w * c.w[0]) - origin;
        slope = perspective ? w : atOrigin;
        constant = perspective ? atOrigin : -w;
    }
};

/// -1 where a cell is thick enough to tell how something changes across it.
TETRA_SIMD_INLINE Int8 hasTrustedGradient(const CellCorners& c, const CellPlanes& planes)
{
    return magnitude(planes.volume) > extent(c.u) * extent(c.v) * extent(c.w) * thinnestCell;
}

TETRA_SIMD_INLINE void makeField(const CellCorners& c, const CellPlanes& planes, bool perspective,
                                 Float8 roundingVolume, const TransferOfCells& transfer, const BinnedCell* binned,
                                 SetupRows& rows)
{
    const Float8 safe = magnitude(planes.volume) > 1e-36f ? planes.volume : Float8{} + 1e-36f;
    const Float8 volume = magnitude(planes.volume);
    const Int8 hasVolume = volume > largerOf(roundingVolume, Float8{} + 1e-35f);
    const Int8 isSimple = transfer.oneSegment & hasTrustedGradient(c, planes);
    const CellFunction value(c, planes, 1.0f / safe, c.value, isSimple ? transfer.origin : Float8{}, perspective);
    transposeBack(value.u, value.v, value.slope, Float8{}, rows.slopes);
    transposeBack(value.constant, smallerOf(smallerOf(c.value[0], c.value[1]), smallerOf(c.value[2], c.value[3])),
                  largerOf(largerOf(c.value[0], c.value[1]), largerOf(c.value[2], c.value[3])), Float8{}, rows.fields);
    rows.flat = ~hasVolume & 1;
    rows.simple = isSimple & 1;
    const Int8 direction = directionOf(value.u, value.v, value.slope, value.constant, binned, perspective);
    rows.direction = isSimple ? Int8{} + static_cast<int>(Direction::Mixed) : direction;
}

/// `trusted`: -1 where the gradient's change along a cell is; in others it is the mean of those at the corners.
TETRA_SIMD_INLINE void makeLight(const VertexGradient* gradients, const std::array<std::uint32_t, 4>* const (&cells)[8],
                                 const CellCorners& c, const CellPlanes& planes, Int8 trusted, bool perspective,
                                 SetupRows& rows)
{
    const Float8 safe = magnitude(planes.volume) > 1e-36f ? planes.volume : Float8{} + 1e-36f;
    const Float8 perVolume = trusted ? 1.0f / safe : Float8{};
    Float8 components[3][4], unused;
    for (std::size_t corner = 0; corner < 4; ++corner)
        loadCorner(gradients, cells, corner, components[0][corner], components[1][corner], components[2][corner],
                   unused);
    for (int i = 0; i < 3; ++i) {
        Float8(&values)[4] = components[i];
        const Float8 mean = (values[0] + values[1] + values[2] + values[3]) * 0.25f;
        values[0] = trusted ? values[0] : mean;
        const CellFunction along(c, planes, perVolume, values, Float8{}, perspective);
        transposeBack(along.u, along.v, along.slope, along.constant, rows.lights[i]);
    }
}

/// `binned` are eight cells.
TETRA_SIMD_INLINE void setUpRows(const SetupSource& source, const TileFrame& frame, const TransferOfCells& transfer,
                                 const BinnedCell* binned, SetupRows& rows)
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
        setupRounding * (farU * widthV * widthW + farV * widthU * widthW + farW * widthU * widthV);
    makeField(corners, planes, perspective, roundingVolume, transfer, binned, rows);
    if (!source.gradients.empty())
        makeLight(source.gradients.data(), cells, corners, planes, hasTrustedGradient(corners, planes), perspective,
                  rows);
    const Float8 depth = transfer.extinction * widthW * frame.longestRay;
    rows.thickness = -(depth > faintDepth) - (depth > 1.0f);
}

AffineFunction functionOf(const Float4& row)
{
    AffineFunction function;
    std::memcpy(&function, &row, sizeof function);
    return function;
}

/// Of which faces the functions of a cell are, by the faces that are fronts.
using FacePlaces = std::array<std::uint8_t, 6>;
constexpr std::array<FacePlaces, 16> facePlaces = [] {
    std::array<FacePlaces, 16> places{};
    for (unsigned fronts = 0; fronts < places.size(); ++fronts) {
        places[fronts] = {4, 4, 4, 5, 5, 5};
        // Of four of one kind the last goes to where the other kind has none.
        constexpr std::size_t functions[2][4] = {{3, 4, 5, 0}, {0, 1, 2, 3}};
        std::array<std::size_t, 2> next{};
        for (std::uint8_t face = 0; face < 4; ++face) {
            const std::size_t front = fronts >> face & 1;
            places[fronts][functions[front][next[front]++]] = face;
        }
    }
    return places;
}();

/// What does not bind.
void fillFarBounds(SetupRows& rows)
{
    std::ranges::fill(rows.faces[4], Float4{0, 0, farBound, 0});
    std::ranges::fill(rows.faces[5], Float4{0, 0, -farBound, 0});
}

/// 1 / length of the gradient, in values for one unit of w across the picture; 0 without a gradient.
float perGradientOf(const SetupRows& rows, std::size_t row, const SetupSource& source, const TileFrame& frame)
{
    const float u = rows.slopes[row][0], v = rows.slopes[row][1];
    const float w = source.perspective ? rows.slopes[row][2] - u * frame.x - v * frame.y : -rows.fields[row][0];
    const float acrossU = u * source.lengths[0], acrossV = v * source.lengths[1];
    const float squared = acrossU * acrossU + acrossV * acrossV + w * w;
    return squared > 1e-30f ? 1 / std::sqrt(squared) : 0;
}

void finish(const SetupRows& rows, std::size_t row, const SetupSource& source, const TileFrame& frame,
            const BinnedCell& binned, CellSetup& setup)
{
    constexpr int allFaces = 15;
    const int fronts = rows.fronts[row];
    const FacePlaces& places = facePlaces[static_cast<std::size_t>(fronts)];
    for (std::size_t i = 0; i < places.size(); ++i)
        setup.functions[i] = functionOf(rows.faces[places[i]][row]);
    setup.functions[6] = functionOf(rows.slopes[row]);
    setup.constant = rows.fields[row][0];
    setup.smallest = rows.fields[row][1];
    setup.largest = rows.fields[row][2];
    setup.perGradient = source.measured ? perGradientOf(rows, row, source, frame) : 0;
    const CellClass ofCell = source.classes[binned.cell];
    setup.firstSegment = ofCell.first;
    setup.lastSegment = ofCell.last;
    setup.left = binned.left;
    setup.top = binned.top;
    setup.right = binned.right;
    setup.bottom = binned.bottom;
    setup.thickness = static_cast<Thickness>(rows.thickness[row]);
    setup.direction = static_cast<Direction>(rows.direction[row]);
    setup.simple = rows.simple[row] != 0;
    setup.flat = rows.flat[row] != 0 || fronts == allFaces;
    setup.around = fronts == 0;
}

const CellLight& takeLight(const SetupRows& rows, std::size_t row, CellLight& light)
{
    for (std::size_t i = 0; i < 3; ++i)
        light.components[i] = functionOf(rows.lights[i][row]);
    return light;
}

/// `cells` are eight.
void askTransfer(const SetupSource& source, const BinnedCell* cells, TransferOfCells& transfer)
{
    for (std::size_t lane = 0; lane < 8; ++lane) {
        const CellClass ofCell = source.classes[cells[lane].cell];
        const ScaledSegment* segment = &source.segments[ofCell.first];
        transfer.origin[lane] = segment->origin;
        transfer.oneSegment[lane] = ofCell.first == ofCell.last ? -1 : 0;
        float extinction = segment->largestExtinction;
        for (std::size_t more = ofCell.first; more < ofCell.last; ++more)
            extinction = std::max(extinction, (++segment)->largestExtinction);
        transfer.extinction[lane] = extinction;
    }
}

} // namespace

void fetchCells(const SetupSource& source, std::span<const BinnedCell> cells)
{
    for (const BinnedCell& cell : cells) {
        __builtin_prefetch(&source.tetrahedra[cell.cell]);
        __builtin_prefetch(&source.classes[cell.cell]);
    }
}

void fetchCorners(const SetupSource& source, std::span<const BinnedCell> cells)
{
    for (const BinnedCell& cell : cells)
        for (const std::uint32_t corner : source.tetrahedra[cell.cell]) {
            __builtin_prefetch(&source.vertices[corner]);
            if (!source.gradients.empty())
                __builtin_prefetch(&source.gradients[corner]);
        }
}

void setUpCells(const SetupSource& source, const TileFrame& frame, std::span<const BinnedCell> cells,
                std::span<CellSetup> setups, std::span<CellLight> lights)
{
    SetupRows rows;
    fillFarBounds(rows);
    for (std::size_t first = 0; first < cells.size(); first += 8) {
        const std::size_t count = std::min<std::size_t>(8, cells.size() - first);
        BinnedCell eight[8];
        for (std::size_t lane = 0; lane < 8; ++lane)
            eight[lane] = cells[first + std::min(lane, count - 1)];
        TransferOfCells transfer;
        askTransfer(source, eight, transfer);
        dispatch<setUpRows>(source, frame, transfer, eight, rows);
        for (std::size_t row = 0; row < count; ++row) {
            finish(rows, row, source, frame, eight[row], setups[first + row]);
            setups[first + row].light = nullptr;
            if (!source.gradients.empty())
                setups[first + row].light = &takeLight(rows, row, lights[first + row]);
        }
    }
}

} // namespace tetra
