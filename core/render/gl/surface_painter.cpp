// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/surface_painter.h"

#include "core/render/focus_weight.h"
#include "core/render/gl/gl_program.h"
#include "core/render/scene_checks.h"
#include "core/render/view_transform.h"

#include <tan/render.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>

namespace tetra {
namespace {

Eigen::Vector4f colourOf(const Surface& surface)
{
    return {surface.colour.red, surface.colour.green, surface.colour.blue, surface.opacity};
}

/// As if OpenGL's samples were a little beside the middle of their squares (sampleX).
Eigen::Matrix4d shiftedToRays(Eigen::Matrix4d clipFromWorld, const SampleView& view)
{
    clipFromWorld.row(0) -= clipFromWorld.row(3) * (2 * (sampleX - 0.5) / view.part.width());
    clipFromWorld.row(1) += clipFromWorld.row(3) * (2 * (sampleY - 0.5) / view.part.height());
    return clipFromWorld;
}

/// Of peel.frag.
void setShare(const GlProgram& program, const FocusShare* share, const Eigen::Vector3d& origin)
{
    std::vector<Eigen::Vector4f> shapes, places;
    for (const FocusRegion& region : share != nullptr ? share->regions : std::vector<FocusRegion>()) {
        const RegionShape shape = shapeOf(region);
        const Eigen::Vector3f size = shape.size.cast<float>(), place = (shape.centre - origin).cast<float>();
        shapes.emplace_back(size.x(), size.y(), size.z(), shape.isBall ? 1 : 0);
        places.emplace_back(place.x(), place.y(), place.z(), static_cast<float>(shape.border));
    }
    program.set("shareCount", static_cast<int>(shapes.size()));
    program.set("shareOfFine", share != nullptr && share->fine ? 1 : 0);
    program.set("shareShapes", shapes);
    program.set("sharePlaces", places);
}

} // namespace

SurfacePainter::SurfacePainter(const GlFunctions& gl, const PainterPrograms& programs)
    : gl_(gl), programs_(programs), meshes_(gl), lineVertexArray_(gl.genVertexArrays, gl.deleteVertexArrays),
      lineVertices_(gl.genBuffers, gl.deleteBuffers)
{
}

Status SurfacePainter::collectSurfaces(const Camera& camera)
{
    surfaces_.clear();
    meshes_.dropDead();
    std::uint64_t triangles = 0;
    for (const Drawable& drawable : scene_->drawables) {
        const auto* surface = std::get_if<Surface>(&drawable.shape);
        if (surface == nullptr || !surface->mesh || !(surface->opacity > 0))
            continue;
        const Result<const MeshBuffers*> buffers = meshes_.buffersOf(surface->mesh, camera);
        if (!buffers)
            return buffers.error();
        surfaces_.push_back({surface, *buffers, static_cast<unsigned>(triangles), drawable.overlay});
        triangles += surface->mesh->triangles.size();
    }
    if (triangles >= std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource, Message::say("The scene has more than four billion triangles.")};
    return {};
}

Status SurfacePainter::prepare(const Scene& scene, const SampleView& view, double samplesPerPixelAxis)
{
    for (const LineSet* lines : shapesOf<LineSet>(scene))
        if (Status status = checkLines(*lines); !status)
            return status;
    scene_ = &scene;
    transform_ = partOf(makeViewTransform(view.camera, view.width, view.height, view.bounds), view.part);
    if (view.amongRays)
        transform_.clipFromWorld = shiftedToRays(transform_.clipFromWorld, view);
    eye_ = eyePosition(view.camera);
    samplesPerPixelAxis_ = samplesPerPixelAxis;
    return collectSurfaces(view.camera);
}

bool SurfacePainter::anyTranslucent() const noexcept
{
    return std::ranges::any_of(surfaces_, [](const DrawnSurface& drawn) { return !drawn.isOpaque(); });
}

void SurfacePainter::draw(const GlProgram& program, const DrawnSurface& drawn) const
{
    const Eigen::Vector3d& origin = drawn.buffers->origin;
    const Eigen::Matrix4d clipFromMesh =
        transform_.clipFromWorld * Eigen::Affine3d(Eigen::Translation3d(origin)).matrix();
    program.set("clipFromMesh", Eigen::Matrix4f(clipFromMesh.cast<float>()));
    const Eigen::Vector3f fromMesh = (eye_ - origin).cast<float>();
    program.set("eye", transform_.perspective ? Eigen::Vector4f(fromMesh.x(), fromMesh.y(), fromMesh.z(), 1)
                                              : Eigen::Vector4f(transform_.towardsEye.x(), transform_.towardsEye.y(),
                                                                transform_.towardsEye.z(), 0));
    program.set("colour", colourOf(*drawn.surface));
    program.set("coloured", drawn.surface->mesh->colours.empty() ? 0 : 1);
    program.set("backFacesOnly", drawn.surface->backFacesOnly ? 1 : 0);
    program.set("cameraFromWorld", transform_.cameraFromWorld);
    program.set("isLit", isLit(*drawn.surface) ? 1 : 0);
    setLights(program);
    program.set("overlay", drawn.overlay ? 1 : 0);
    setCuts(program, drawn.overlay ? std::span<const ClipPlane>() : scene_->clipPlanes, origin);
    gl_.bindVertexArray(drawn.buffers->vertexArray.name());
    gl_.drawElements(gl::triangles, drawn.buffers->indexCount, gl::unsignedInt, nullptr);
}

void SurfacePainter::draw(const LineSet& lines, bool overlay) const
{
    std::vector<Eigen::Vector4f> corners;
    for (const LineQuad& quad : thickLines(lines, transform_, lines.width * samplesPerPixelAxis_))
        for (const std::size_t corner : {0, 1, 2, 0, 2, 3})
            corners.emplace_back(quad[corner].cast<float>());
    gl_.bindVertexArray(lineVertexArray_.name());
    gl_.bindBuffer(gl::arrayBuffer, lineVertices_.name());
    gl_.bufferData(gl::arrayBuffer, static_cast<std::ptrdiff_t>(corners.size() * sizeof(corners[0])), corners.data(),
                   gl::streamDraw);
    gl_.enableVertexAttribArray(0);
    gl_.vertexAttribPointer(0, 4, gl::floatType, 0, 0, nullptr);
    programs_.line->use();
    programs_.line->set("overlay", overlay ? 1 : 0);
    programs_.line->set("colour", Eigen::Vector4f(lines.colour.red, lines.colour.green, lines.colour.blue, 1));
    gl_.drawArrays(gl::triangles, 0, static_cast<int>(corners.size()));
}

void SurfacePainter::drawOpaque() const
{
    programs_.opaque->use();
    for (const DrawnSurface& drawn : surfaces_)
        if (drawn.isOpaque() && !drawn.overlay)
            draw(*programs_.opaque, drawn);
    for (const Drawable& drawable : scene_->drawables)
        if (const auto* lines = std::get_if<LineSet>(&drawable.shape); lines != nullptr && !drawable.overlay)
            draw(*lines, false);
    drawOverlays();
}

/// All overlays lie at the near plane, where what is drawn first stays: so the last of the list is drawn first.
void SurfacePainter::drawOverlays() const
{
    for (auto drawable = scene_->drawables.rbegin(); drawable != scene_->drawables.rend(); ++drawable) {
        if (!drawable->overlay)
            continue;
        if (const auto* lines = std::get_if<LineSet>(&drawable->shape))
            draw(*lines, true);
        for (const DrawnSurface& drawn : surfaces_)
            if (drawn.surface == std::get_if<Surface>(&drawable->shape)) {
                programs_.opaque->use();
                draw(*programs_.opaque, drawn);
            }
    }
}

void SurfacePainter::drawTranslucent(const GlProgram& program) const
{
    for (const DrawnSurface& drawn : surfaces_) {
        if (drawn.isOpaque())
            continue;
        program.set("firstTriangle", drawn.firstTriangle);
        setShare(program, drawn.surface->share.get(), drawn.buffers->origin);
        draw(program, drawn);
    }
}

} // namespace tetra
