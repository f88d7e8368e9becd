// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_matching.h"

#include <bit>

namespace tetra {

FaceMatching::FaceMatching(std::uint64_t sides)
{
    constexpr std::uint64_t fewFaces = 1000;
    most_ = sides / 2 + fewFaces;
    const std::uint64_t room = std::bit_ceil(most_ + most_ / 3);
    mask_ = room - 1;
    shift_ = static_cast<std::uint32_t>(64 - std::countr_zero(room));
    entries_.assign(room, Entry());
}

} // namespace tetra
