// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cone_search.h"

#include "core/base/simd.h"

#include <cstring>

namespace tetra {

namespace {

/// The largest coordinate for which every sum of the plane tests, at most 6 c^3, is exact in a float.
constexpr double exactReachOfFloat = 140;

const std::array<double, 12>& normalsOf(const Star::Face& face)
{
    return face.normals;
}
const std::array<float, 12>& normalsOf(const std::array<float, 12>& normals)
{
    return normals;
}

/// The owners of `groups` times eight points from number `i`, which share the loading of the planes. Branch free: every
/// face is tested.
template <std::size_t groups, class Numbers, class Mask, class Face> [[gnu::always_inline]] inline void
findOwnersAt(std::size_t i, std::span<const Face> faces, const ConePoints& points, std::int32_t* owners)
{
    const auto load = [i](Numbers& to, std::span<const float> from, std::size_t group) {
        Float8 numbers;
        std::memcpy(&numbers, from.data() + i + group * coneSearchLanes, sizeof numbers);
        to = __builtin_convertvector(numbers, Numbers);
    };
    Numbers x[groups], y[groups], z[groups];
    Mask owner[groups] = {};
    for (std::size_t group = 0; group < groups; ++group) {
        load(x[group], points.x, group);
        load(y[group], points.y, group);
        load(z[group], points.z, group);
    }
    Mask number = {};
    for (const Face& face : faces) {
        const auto* const plane = normalsOf(face).data();
        for (std::size_t group = 0; group < groups; ++group) {
            const Numbers side0 = plane[0] * x[group] + plane[1] * y[group] + plane[2] * z[group];
            const Numbers side1 = plane[4] * x[group] + plane[5] * y[group] + plane[6] * z[group];
            const Numbers side2 = plane[8] * x[group] + plane[9] * y[group] + plane[10] * z[group];
            const Mask inside = (side0 >= 0) & (side1 >= 0) & (side2 >= 0);
            owner[group] = inside ? number : owner[group];
        }
        number += 1;
    }
    for (std::size_t group = 0; group < groups; ++group) {
        const auto narrow = __builtin_convertvector(owner[group], Int8);
        std::memcpy(owners + i + group * coneSearchLanes, &narrow, sizeof narrow);
    }
}

TETRA_SIMD_CLONES void findOwnersFloat(std::span<const Star::Face> faces, std::array<float, 12>* planes,
                                       const ConePoints& points, std::span<std::int32_t> owners)
{
    for (std::size_t face = 0; face < faces.size(); ++face)
        for (std::size_t k = 0; k < 12; ++k)
            planes[face][k] = static_cast<float>(faces[face].normals[k]);
    const std::span<const std::array<float, 12>> narrow(planes, faces.size());
    std::size_t i = 0;
    for (; i + coneSearchLanes < owners.size(); i += 2 * coneSearchLanes)
        findOwnersAt<2, Float8, Int8>(i, narrow, points, owners.data());
    if (i < owners.size())
        findOwnersAt<1, Float8, Int8>(i, narrow, points, owners.data());
}

TETRA_SIMD_CLONES void findOwnersDouble(std::span<const Star::Face> faces, const ConePoints& points,
                                        std::span<std::int32_t> owners)
{
    for (std::size_t i = 0; i < owners.size(); i += coneSearchLanes)
        findOwnersAt<1, Double8, Long8>(i, faces, points, owners.data());
}

} // namespace

void findCones(const Star& star, const ConePoints& points, Buffer<std::array<float, 12>>& planes,
               std::span<std::int32_t> owners)
{
    if (star.reach() <= exactReachOfFloat) {
        planes.resize(star.faceCount());
        findOwnersFloat(star.faces(), planes.data(), points, owners);
    } else {
        findOwnersDouble(star.faces(), points, owners);
    }
}

} // namespace tetra
