// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_buffers.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/sample_targets.h"
#include "core/render/view_transform.h"

#include <tan/base.h>
#include <tan/render.h>

#include <vector>

namespace tetra {

/// Draws the surfaces and lines of a scene into the framebuffer that is bound. The context must be current for
/// everything, also when it goes; `gl` and `programs` must outlive it.
class SurfacePainter {
public:
    SurfacePainter(const GlFunctions& gl, const PainterPrograms& programs);

    /// Makes ready to draw a scene, which must live until the picture is done. Errors: surfaces or lines that do not
    /// hang together, out of memory.
    Status prepare(const Scene& scene, const SampleView& view, double samplesPerPixelAxis);
    bool anyTranslucent() const noexcept;

    void drawOpaque() const;
    /// Draws all translucent surfaces with a program in use (peel.frag).
    void drawTranslucent(const GlProgram& program) const;

private:
    /// A surface with its triangles' first number in the scene.
    struct DrawnSurface {
        const Surface* surface;
        const MeshBuffers* buffers;
        unsigned firstTriangle;
        bool overlay;
        bool isOpaque() const noexcept { return overlay || (surface->opacity >= 1 && !surface->share); }
    };
    Status collectSurfaces(const Camera& camera);
    void draw(const GlProgram& program, const DrawnSurface& drawn) const;
    void draw(const LineSet& lines, bool overlay) const;
    void drawOverlays() const;

    const GlFunctions& gl_;
    const PainterPrograms& programs_;
    MeshBufferCache meshes_;
    GlObject lineVertexArray_;
    GlObject lineVertices_;
    // Of the picture being drawn.
    const Scene* scene_ = nullptr;
    std::vector<DrawnSurface> surfaces_;
    ViewTransform transform_;
    Eigen::Vector3d eye_{0, 0, 0};
    double samplesPerPixelAxis_ = 1;
};

} // namespace tetra
