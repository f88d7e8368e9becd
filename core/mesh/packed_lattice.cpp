// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/packed_lattice.h"

#include "core/base/simd.h"

#include <cstring>

namespace tetra {

TETRA_SIMD_CLONES void latticeIndices(const PackedLattice& lattice, std::span<const PackedPoint> points,
                                      std::uint32_t* indices)
{
    const PackedLattice local = lattice;
    const int sizeX = static_cast<int>(local.size()[0]), sizeY = static_cast<int>(local.size()[1]);
    std::size_t i = 0;
    for (; i + 8 <= points.size(); i += 8) {
        Int8 packed, x, y, z;
        std::memcpy(&packed, points.data() + i, sizeof packed);
        local.unpack(packed, x, y, z);
        const Int8 index = (z * sizeY + y) * sizeX + x;
        std::memcpy(indices + i, &index, sizeof index);
    }
    for (; i < points.size(); ++i)
        indices[i] = local.index(points[i]);
}

} // namespace tetra
