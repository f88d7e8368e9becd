// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/renumbered_mesh.h"

#include "core/mesh/spatial_keys.h"

#include <algorithm>

namespace tetra {

namespace {

using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

std::vector<std::uint32_t> alongCurve(std::span<const Eigen::Vector3d> positions)
{
    std::vector<Eigen::Vector3f> places;
    places.reserve(positions.size());
    for (const Eigen::Vector3d& position : positions)
        places.push_back(position.cast<float>());
    Buffer<KeyedIndex> keys = spatialKeys(places);
    radixSort(keys, spatialKeyBits);
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const KeyedIndex& key : keys)
        order.push_back(key.index);
    return order;
}

/// With other numbers, by the smallest of them.
Tetrahedra renumbered(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const std::uint32_t> numbers)
{
    const auto firstOf = [numbers](const std::array<std::uint32_t, 4>& t) {
        return std::min({numbers[t[0]], numbers[t[1]], numbers[t[2]], numbers[t[3]]});
    };
    std::vector<std::uint32_t> places(numbers.size() + 1, 0);
    for (const auto& tetrahedron : tetrahedra)
        ++places[firstOf(tetrahedron) + 1];
    for (std::size_t i = 1; i < places.size(); ++i)
        places[i] += places[i - 1];
    Tetrahedra result(tetrahedra.size());
    for (const auto& tetrahedron : tetrahedra) {
        auto& to = result[places[firstOf(tetrahedron)]++];
        for (std::size_t i = 0; i < 4; ++i)
            to[i] = numbers[tetrahedron[i]];
    }
    return result;
}

template <class Number>
std::vector<Number> reordered(std::span<const Number> numbers, std::span<const std::uint32_t> order)
{
    std::vector<Number> result;
    if (numbers.empty())
        return result;
    result.reserve(order.size());
    for (const std::uint32_t index : order)
        result.push_back(numbers[index]);
    return result;
}

} // namespace

RenumberedMesh::RenumberedMesh(const DecimationMesh& mesh)
    : originals_(alongCurve(mesh.positions)), positions_(reordered(mesh.positions, originals_)),
      lifted_(reordered(mesh.lifted, originals_)), values_(reordered(mesh.values, originals_)),
      weights_(reordered(mesh.weights, originals_)), box_(mesh.box), leftHanded_(mesh.leftHanded)
{
    std::vector<std::uint32_t> numbers(originals_.size());
    for (std::uint32_t number = 0; number < originals_.size(); ++number)
        numbers[originals_[number]] = number;
    tetrahedra_ = renumbered(mesh.tetrahedra, numbers);
}

} // namespace tetra
