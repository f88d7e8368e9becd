// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/graphics/volume/projected_vertices.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// For each cell, bit f: its face f is seen from outside by the eye; bit 4 + f: from inside. Neither if the eye lies in
/// the face's plane. O(cells), on all threads of the current arena.
Buffer<std::uint8_t> faceFacing(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                std::span<const ProjectedVertex> vertices, bool perspective);

} // namespace tetra
