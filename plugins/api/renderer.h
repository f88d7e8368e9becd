// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <memory>
#include <optional>
#include <vector>

namespace tetra {

/// What is known of a field: for fitting defaults. Empty if nothing is known.
struct FieldExtent {
    ValueRange range{};
    Eigen::AlignedBox3d bounds{}; ///< of the domain
    /// How the values share the domain's volume, if a mesh is there already (volumeHistogram()).
    ValueHistogram volumes{};
    /// A value whose isosurface shows where the data have a surface, if a mesh is there already (surfaceValue()).
    std::optional<double> surface{};
    /// How far the mesh that is seen may be off in the background (backgroundValues()), in units of the values.
    double error = 0;
    /// The places that are farthest out of what there is to see, by which a picture frames it (fitted()). None: all of
    /// the bounds.
    std::vector<Eigen::Vector3d> object{};
    /// The samples of a lattice may be at hand, so that they can be shown in place of the mesh (shownId).
    bool hasSamples = true;
};

/// The mesh of a part of the domain in a resolution of its own (R24).
struct FocusMesh {
    std::shared_ptr<const TetrahedralMesh> mesh; ///< fills all that is nearer to a region than its border
    std::vector<FocusRegion> regions;            ///< see FocusVolume
};

/// What a renderer needs to make its scenes.
struct RendererNeeds {
    /// A focus as a mesh of its own beside the one outside, to blend the two, rather than one mesh of varying
    /// resolution.
    bool focusMesh = false;
    /// Camera and size of the picture: the scene is made anew whenever they change. Without this it never is for their
    /// sake, so that turning a scene costs nothing.
    bool view = false;
};

/// The meshes that a renderer asked for.
struct RendererMeshes {
    std::shared_ptr<const TetrahedralMesh> mesh; ///< what is to be seen; with a focus that outside of it
    std::optional<FocusMesh> focus{};            ///< if it is needed, and there is one
    Eigen::AlignedBox3d bounds{};                ///< of the domain; a scene has them
};

/// How the meshes are to be seen.
struct RendererView {
    /// One for each of the renderer's parameters, of its type: where nobody has chosen one it is the default for the
    /// mesh.
    ParameterValues values{};
    Camera camera{};
    int width = 1024; ///< of the picture, in pixels
    int height = 768;

    /// The value of a parameter; T is its type.
    template <class T> T value(const std::string& id) const { return parameterValue<T>({}, values, id); }
};

/// Meshes being looked at: holds what is worth keeping between two scenes of them (gradients, surfaces). Used from one
/// thread at a time, which need not be the same.
class RendererSession {
public:
    virtual ~RendererSession() = default;
    /// Makes the scene to draw, on the CPU, cancellable, without GL. Either back end draws it. Drawables have ids that
    /// stay from scene to scene.
    virtual Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) = 0;
};

/// A way of looking at a mesh: isosurfaces, volume, both ... Called from any thread. What it throws, and what it gives
/// back that is no scene, becomes an error in the program that called it.
class Renderer {
public:
    virtual ~Renderer() = default;
    /// With defaults that fit the field. Several may have the same type: two transfer functions, say. Those with the
    /// ids of plugins/api/scene_parameters.h have the values that the user sees in all modes.
    virtual std::vector<Parameter> parameters(const FieldExtent& field) const = 0;
    virtual RendererNeeds needs() const { return {}; }
    virtual std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const = 0;
};

} // namespace tetra
