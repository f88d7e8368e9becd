// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/spatial_order.h"
#include "core/render/isosurface/isosurface.h"
#include "core/render/isosurface/isovalue.h"
#include "core/render/scene.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// The isosurfaces of one mesh for a list of isovalues that changes. Keeps the gradients of its mesh, and the surface
/// of each isovalue for as long as the value is in the list: to change a colour, an opacity or the visibility extracts
/// nothing. From its second extraction on it takes the mesh in spatial order with an index, which are not worth their
/// time for one alone, or from the first if the mesh is in that order already. Used from one thread at a time.
class IsosurfaceCache {
public:
    explicit IsosurfaceCache(std::shared_ptr<OrderedMesh> mesh);
    explicit IsosurfaceCache(std::shared_ptr<const TetrahedralMesh> mesh);

    /// The surfaces of the isovalues that are seen, in their order. Extracts what is missing, all at once on all
    /// threads. What was finished before a cancellation or an error is kept. Errors: an isovalue that is no number or
    /// has an opacity outside 0 to 1, cancelled, not enough memory.
    Result<std::vector<Surface>> update(std::span<const Isovalue> isovalues, const Progress& progress = {});

private:
    Status extractMissing(std::span<const Isovalue> isovalues, const Progress& progress);

    Status chooseMesh(const Progress& progress);
    Result<TriangleMesh> extract(double isovalue, const Progress& progress) const;

    std::shared_ptr<OrderedMesh> mesh_;
    std::shared_ptr<const TetrahedralMesh> chosen_;                  ///< of the two in mesh_
    Buffer<Eigen::Vector3f> gradients_;                              ///< of the chosen one
    std::optional<IsosurfaceIndex> index_;                           ///< of the ordered one, if that is chosen
    std::map<double, std::shared_ptr<const TriangleMesh>> surfaces_; ///< by isovalue
};

} // namespace tetra
