// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <map>
#include <span>

namespace tetra {

inline constexpr const char* isovaluesId = "isovalues";
inline constexpr const char* outlineId = "outline";

/// Keeps the gradients of its mesh, and the surface of each isovalue for as long as the value is in the list: to change
/// a colour, an opacity or the visibility extracts nothing.
class IsosurfaceSession : public RendererSession {
public:
    IsosurfaceSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds);

    /// Extracts what is visible and not kept yet, all at once on all threads. What was finished before a cancellation
    /// or an error is kept. The camera does not matter.
    Result<std::shared_ptr<const Scene>> prepare(const ParameterValues& values, const Camera& camera,
                                                 const Progress& progress) override;

private:
    using SurfacePointer = std::shared_ptr<const TriangleMesh>;

    Status extractMissing(std::span<const Isovalue> isovalues, const Progress& progress);
    std::shared_ptr<const Scene> makeScene(std::span<const Isovalue> isovalues, bool outline) const;

    std::shared_ptr<const TetrahedralMesh> mesh_;
    Eigen::AlignedBox3d bounds_;
    Buffer<Eigen::Vector3f> gradients_;
    std::map<double, SurfacePointer> surfaces_; ///< by isovalue
};

} // namespace tetra
