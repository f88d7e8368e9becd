// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

using Triangle = std::array<std::uint32_t, 3>;    ///< by numbers of vertices, or of the points or sites they are
using Tetrahedron = std::array<std::uint32_t, 4>; ///< likewise

/// An edge as a number: its smaller vertex, times 2^32, plus the larger one.
using EdgeKey = std::uint64_t;

constexpr EdgeKey edgeKey(std::uint32_t one, std::uint32_t other) noexcept
{
    const EdgeKey a = one, b = other;
    return std::min(a << 32 | b, b << 32 | a); // compilers make no branch of this
}

/// The ends of an edge, smaller one first.
constexpr std::array<std::uint32_t, 2> endsOf(EdgeKey edge) noexcept
{
    return {static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)};
}

/// The corners of a tetrahedron's faces. Face f is the one opposite to corner f; seen from outside a positive
/// tetrahedron its corners run counterclockwise.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> cornersOfFace = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The same tetrahedron with this corner first, as positive as before: corner f and then face f is an even permutation.
template <class Corner>
constexpr std::array<Corner, 4> withCornerFirst(const std::array<Corner, 4>& corners, std::size_t first)
{
    const auto& [a, b, c] = cornersOfFace[first];
    return {corners[first], corners[a], corners[b], corners[c]};
}

/// The vertices below `count` that triangles or tetrahedra have, ascending; their corners become numbers among these.
/// O(vertices + simplices).
template <class Simplices> std::vector<std::uint32_t> renumberUsed(Simplices& simplices, std::size_t count)
{
    constexpr std::uint32_t unused = 0xffffffff;
    std::vector<std::uint32_t> numbers(count, unused);
    for (const auto& simplex : simplices)
        for (const std::uint32_t vertex : simplex)
            numbers[vertex] = 0;
    std::vector<std::uint32_t> used;
    for (std::uint32_t vertex = 0; vertex < count; ++vertex)
        if (numbers[vertex] != unused) {
            numbers[vertex] = static_cast<std::uint32_t>(used.size());
            used.push_back(vertex);
        }
    for (auto& simplex : simplices)
        for (std::uint32_t& vertex : simplex)
            vertex = numbers[vertex];
    return used;
}

} // namespace tetra
