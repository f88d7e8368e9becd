// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/scalar_field.h"
#include "core/graphics/camera.h"
#include "core/graphics/scene.h"
#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/value_histogram.h"
#include "plugins/api/parameter.h"

#include <QtPlugin>

namespace tetra {

/// What is known of a field: for fitting defaults. Empty if nothing is known.
struct FieldExtent {
    ValueRange range{};
    Eigen::AlignedBox3d bounds{}; ///< of the domain
    /// How the values share the domain's volume, if a mesh is there already (volumeHistogram()).
    ValueHistogram volumes{};
};

/// A mesh being looked at: holds what is worth keeping between two changes of the parameters (gradients, surfaces).
/// Used from one thread at a time, which need not be the same.
class RendererSession {
public:
    virtual ~RendererSession() = default;
    /// Makes the scene to draw, on the CPU, cancellable, without GL. Either back end draws it.
    virtual Result<std::shared_ptr<const Scene>> prepare(const ParameterValues& values, const Camera& camera,
                                                         const Progress& progress) = 0;
};

/// A way of looking at a mesh: isosurfaces, volume, both ...
class Renderer {
public:
    virtual ~Renderer() = default;
    /// With defaults that fit the field.
    virtual std::vector<Parameter> parameters(const FieldExtent& field) const = 0;
    /// `bounds` is the domain's box, whose outline belongs to the scene.
    virtual std::unique_ptr<RendererSession> open(std::shared_ptr<const TetrahedralMesh> mesh,
                                                  const Eigen::AlignedBox3d& bounds) const = 0;
};

} // namespace tetra

#define TAN_RENDERER_INTERFACE "org.tan.Renderer/1"
Q_DECLARE_INTERFACE(tetra::Renderer, TAN_RENDERER_INTERFACE)
