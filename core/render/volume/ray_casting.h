// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/samples/sampled_field.h"
#include "core/render/view_transform.h"
#include "core/render/volume/projected_vertices.h"
#include "core/render/volume/volume_tile.h"
#include "core/render/volume/volume_view.h"

#include <tan/render.h>

#include <Eigen/Core>

#include <vector>

namespace tetra {

/// Samples ready to be cast rays through in a view. What it was made of must outlive it.
struct SampledView {
    const SampledField* field = nullptr;
    const SampledTransfer* transfer = nullptr;
    const SampleGradients* gradients = nullptr; ///< null if it is not lit
    ScaledSegments scaled;
    /// For equal parts of the scaled values from 0 to 1 the segment of their least value.
    std::vector<std::uint16_t> segmentOfPart;
    /// A place (u, v, w) of the view in steps of the lattice.
    Eigen::Matrix<float, 3, 4> indexFromImage = Eigen::Matrix<float, 3, 4>::Zero();
    Eigen::Matrix3f seenFromWorld = Eigen::Matrix3f::Identity(); ///< right, down, away from the eye
    float perFullGradient = 0;                                   ///< of volume_mesh.h, of the gradients
    float step = 1;          ///< of w, between two places at which the field is taken
    float stepsPerLight = 1; ///< from one place at which light is taken to the next: half a cell
};

/// O(segments).
SampledView makeSampledView(const SampledVolume& volume, const VolumeView& view);

/// Casts the rays of a tile, `columns` blocks a row, front to back through the field that is trilinear between the
/// samples. It is taken several times a cell, the more often the denser the volume is, and goes in straight lines from
/// one place to the next; these slabs are integrated as those of cells are, cut where the transfer function bends
/// (R22). Light is taken twice a cell. Blocks of the lattice in which nothing is seen are passed by. `shading.segments`
/// are those of the view.
void castRays(const SampledView& view, const TileShading& shading, SampleBlock* blocks, int columns, int rows);

} // namespace tetra
