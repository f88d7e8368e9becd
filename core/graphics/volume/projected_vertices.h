// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/graphics/volume/cell_geometry.h"
#include "core/graphics/volume/scaled_segments.h"
#include "core/graphics/volume/volume_view.h"
#include "core/mesh/tetrahedral_mesh.h"

#include <array>
#include <cstdint>

namespace tetra {

/// The first sample that does not lie before a vertex, by column and row; `behind` if it is nearer than the near plane.
struct VertexSample {
    static constexpr std::int16_t behind = -32768;
    std::int16_t column;
    std::int16_t row;
    bool isBehind() const noexcept { return column == behind; }
};

/// A mesh's vertices in a picture of at most largestPictureSide samples a side.
struct ProjectedVertices {
    Buffer<ProjectedVertex> vertices;
    Buffer<VertexSample> samples;
};

/// O(vertices), on all threads of the current arena. May throw std::bad_alloc.
ProjectedVertices projectVertices(const TetrahedralMesh& mesh, const VolumeView& view, const ScaledSegments& segments);

/// The first sample, by column or row, not before a place that is measured from sample 0; within 16 bits.
std::int16_t firstSampleFrom(double place) noexcept;

} // namespace tetra
