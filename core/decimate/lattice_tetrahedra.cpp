// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/lattice_tetrahedra.h"

#include <span>

namespace tetra {

namespace {

/// Corner numbers of a cell: bit k says whether the corner lies at the far end of axis k.
using CellCut = std::array<std::uint8_t, 4>;

constexpr std::array<CellCut, 5> fiveOfEvenCells = {
    {{0, 3, 5, 6}, {1, 3, 0, 5}, {2, 0, 3, 6}, {4, 5, 0, 6}, {7, 6, 3, 5}}};
constexpr std::array<CellCut, 6> six = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// Six times the volume in a cell of unit size.
constexpr int volume(const CellCut& cut)
{
    int edges[3][3] = {};
    for (std::size_t i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            edges[i][axis] = (cut[i + 1] >> axis & 1) - (cut[0] >> axis & 1);
    const auto& [a, b, c] = edges;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The same tetrahedra, made positive.
template <std::size_t Count> constexpr std::array<CellCut, Count> positive(std::array<CellCut, Count> cuts)
{
    for (CellCut& cut : cuts)
        if (volume(cut) < 0)
            cut = {cut[0], cut[1], cut[3], cut[2]};
    return cuts;
}

constexpr std::array<CellCut, 5> mirroredCuts(std::array<CellCut, 5> cuts)
{
    for (CellCut& cut : cuts)
        for (std::uint8_t& corner : cut)
            corner ^= 1;
    return cuts;
}

} // namespace

std::vector<std::array<std::uint32_t, 4>> latticeTetrahedra(const std::array<std::uint32_t, 3>& size, LatticeCut cut)
{
    static constexpr auto even = positive(fiveOfEvenCells);
    static constexpr auto odd = positive(mirroredCuts(fiveOfEvenCells));
    static constexpr auto always = positive(six);
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    if (size[0] < 2 || size[1] < 2 || size[2] < 2)
        return tetrahedra;
    const std::uint32_t strides[3] = {1, size[0], size[0] * size[1]};
    tetrahedra.reserve(std::size_t(size[0] - 1) * (size[1] - 1) * (size[2] - 1) * (cut == LatticeCut::Five ? 5 : 6));
    for (std::uint32_t z = 0; z + 1 < size[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < size[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < size[0]; ++x) {
                const std::uint32_t lowest = x * strides[0] + y * strides[1] + z * strides[2];
                std::span<const CellCut> cuts = always;
                if (cut == LatticeCut::Five)
                    cuts = (x + y + z) % 2 == 0 ? even : odd;
                for (const CellCut& corners : cuts) {
                    std::array<std::uint32_t, 4>& tetrahedron = tetrahedra.emplace_back();
                    for (std::size_t i = 0; i < 4; ++i)
                        tetrahedron[i] = lowest + (corners[i] & 1u) * strides[0] + (corners[i] >> 1 & 1u) * strides[1] +
                                         (corners[i] >> 2 & 1u) * strides[2];
                }
            }
    return tetrahedra;
}

} // namespace tetra
