// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QtPlugin>

#include <memory>
#include <optional>
#include <variant>

namespace tetra {

/// What is known of a field: for fitting defaults. Empty if nothing is known.
struct FieldExtent {
    ValueRange range{};
    Eigen::AlignedBox3d bounds{}; ///< of the domain
    /// How the values share the domain's volume, if a mesh is there already (volumeHistogram()).
    ValueHistogram volumes{};
    /// A value whose isosurface shows where the data have a surface, if a mesh is there already (surfaceValue()).
    std::optional<double> surface{};
};

/// The mesh of a part of the domain in a resolution of its own (R24).
struct FocusMesh {
    std::shared_ptr<const TetrahedralMesh> mesh; ///< fills all that is nearer to the region than `border`
    std::variant<Box, Sphere> region;
    double border = 0; ///< see FocusVolume
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
    /// Whether it wants a focus as a mesh of its own, to blend the two, rather than one mesh of varying resolution.
    virtual bool blendsFocus() const { return false; }
    /// Called in place of open() if there is a focus and it blendsFocus(): `mesh` is of the resolution outside.
    virtual std::unique_ptr<RendererSession> openWithFocus(std::shared_ptr<const TetrahedralMesh> mesh,
                                                           [[maybe_unused]] FocusMesh focus,
                                                           const Eigen::AlignedBox3d& bounds) const
    {
        return open(std::move(mesh), bounds);
    }
};

} // namespace tetra

#define TAN_RENDERER_INTERFACE "org.tan.Renderer/1"
Q_DECLARE_INTERFACE(tetra::Renderer, TAN_RENDERER_INTERFACE)
