// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>
#include <tan/transfer.h>

#include <cstdint>
#include <memory>

namespace tetra {

/// What is known of the mesh that a picture shows.
struct ShownMesh {
    MeshQuery query;            ///< that it answers
    std::uint64_t vertices = 0; ///< that are drawn, and pieces of what a window cuts
    std::uint64_t tetrahedra = 0;
    std::uint32_t wholeSites = 0; ///< before window and values, as in ExtractedMesh
    std::uint64_t wholeTetrahedra = 0;
    std::uint64_t keptSites = 0; ///< of what is drawn, as in ExtractedMesh
    std::uint64_t keptTetrahedra = 0;
    bool isBlended = false; ///< of two meshes, both are counted; the whole one is that outside the focus
    double scale = 1;       ///< as in ExtractedMesh
    std::shared_ptr<const ValueHistogram> histogram{}; ///< of its vertices' values, over the model's range
    /// The same of the values' natural logarithms; none if the range is not positive.
    std::shared_ptr<const ValueHistogram> logarithmicHistogram{};
};

} // namespace tetra
