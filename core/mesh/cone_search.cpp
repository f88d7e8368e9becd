// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cone_search.h"

#include "core/base/simd.h"

#include <cstring>

namespace tetra {

namespace {

/// The largest coordinate for which every sum of the plane tests, at most 6 c^3, is exact in a float.
constexpr double exactReachOfFloat = 140;

/// owners[i] = the last face whose cone, seen from the apex, contains point i. `pconeSearchLanes` holds three normals
/// of four numbers for each face. Branch free: every face is tested.
template <class Real, class Numbers, class Mask>
[[gnu::always_inline]] inline void findOwnersIn(const Real* pconeSearchLanes, std::size_t stride, std::size_t faceCount,
                                                std::size_t pointCount, const float* x, const float* y, const float* z,
                                                std::int32_t* owners)
{
    const auto load = [](Numbers& to, const float* from) {
        Float8 numbers;
        std::memcpy(&numbers, from, sizeof numbers);
        to = __builtin_convertvector(numbers, Numbers);
    };
    for (std::size_t i = 0; i < pointCount; i += coneSearchLanes) {
        Numbers px, py, pz;
        load(px, x + i);
        load(py, y + i);
        load(pz, z + i);
        Mask owner = {};
        Mask face = {};
        for (const Real* plane = pconeSearchLanes; plane != pconeSearchLanes + stride * faceCount; plane += stride) {
            const Numbers side0 = plane[0] * px + plane[1] * py + plane[2] * pz;
            const Numbers side1 = plane[4] * px + plane[5] * py + plane[6] * pz;
            const Numbers side2 = plane[8] * px + plane[9] * py + plane[10] * pz;
            const Mask inside = (side0 >= 0) & (side1 >= 0) & (side2 >= 0);
            owner = inside ? face : owner;
            face += 1;
        }
        const auto narrow = __builtin_convertvector(owner, Int8);
        std::memcpy(owners + i, &narrow, sizeof narrow);
    }
}

TETRA_SIMD_CLONES void findOwnersFloat(std::span<const Star::Face> faces, float* pconeSearchLanes,
                                       std::size_t pointCount, const float* x, const float* y, const float* z,
                                       std::int32_t* owners)
{
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const double* const normals = faces[face].normalBC.data();
        for (std::size_t k = 0; k < 12; ++k)
            pconeSearchLanes[12 * face + k] = static_cast<float>(normals[k]);
    }
    findOwnersIn<float, Float8, Int8>(pconeSearchLanes, 12, faces.size(), pointCount, x, y, z, owners);
}

TETRA_SIMD_CLONES void findOwnersDouble(std::span<const Star::Face> faces, std::size_t pointCount, const float* x,
                                        const float* y, const float* z, std::int32_t* owners)
{
    findOwnersIn<double, Double8, Long8>(faces[0].normalBC.data(), sizeof(Star::Face) / sizeof(double), faces.size(),
                                         pointCount, x, y, z, owners);
}

} // namespace

void findCones(const Star& star, const ConePoints& points, Buffer<float>& planes, std::span<std::int32_t> owners)
{
    if (star.reach() <= exactReachOfFloat) {
        planes.resize(12 * star.faceCount());
        findOwnersFloat(star.faces(), planes.data(), owners.size(), points.x.data(), points.y.data(), points.z.data(),
                        owners.data());
    } else {
        findOwnersDouble(star.faces(), owners.size(), points.x.data(), points.y.data(), points.z.data(), owners.data());
    }
}

} // namespace tetra
