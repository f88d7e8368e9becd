// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/scene_painter.h"

#include "core/graphics/gl/mesh_buffers.h"
#include "core/graphics/gl/painter_programs.h"
#include "core/graphics/gl/sample_targets.h"
#include "core/graphics/picture_options.h"
#include "core/graphics/scene_check.h"
#include "core/graphics/shading.h"
#include "core/graphics/thick_lines.h"
#include "core/graphics/view_transform.h"

#include <limits>
#include <new>
#include <string>
#include <vector>

namespace tetra {
namespace {

constexpr std::string_view activity = "Drawing the picture";

/// Behind this opacity nothing changes an 8-bit channel; half floats cannot tell much more from 1.
constexpr float saturatedOpacity = 1 - 1.0f / 1024;

/// A surface with its triangles' first number in the scene.
struct DrawnSurface {
    const Surface* surface;
    const MeshBuffers* buffers;
    unsigned firstTriangle;
};

bool isOpaque(const Surface& surface)
{
    return surface.opacity >= 1;
}

Eigen::Vector4f colourOf(const Surface& surface)
{
    return {surface.colour.red, surface.colour.green, surface.colour.blue, surface.opacity};
}

/// Errors that somebody else left would be taken for ours. A lost context gives them without end.
void forgetErrors(const GlFunctions& gl)
{
    for (int i = 0; i < 16 && gl.getError() != 0; ++i) {
    }
}

} // namespace

class ScenePainter::Implementation {
public:
    explicit Implementation(const GetProcAddress& getProcAddress) : gl_(getProcAddress) {}

    Status initialise();
    Status draw(const Scene& scene, const Camera& camera, const PictureOptions& options, unsigned framebuffer,
                const Progress& progress);
    const std::string& rendererName() const noexcept { return rendererName_; }

private:
    Status prepareTargets(int width, int height);
    Result<std::vector<DrawnSurface>> collectSurfaces(const Scene& scene);
    void drawSurface(const GlProgram& program, const DrawnSurface& surface) const;
    void drawLines(const LineSet& lines, double samplesPerPixelAxis);
    void drawOpaque(const Scene& scene, const std::vector<DrawnSurface>& surfaces, const PictureOptions& options);
    bool drawLayer(const std::vector<DrawnSurface>& surfaces, std::size_t layer);
    Status peel(const std::vector<DrawnSurface>& surfaces, const Progress& progress);
    void drawOverScreen() const;
    void resolve(const PictureOptions& options, bool layered, unsigned framebuffer) const;

    const GlFunctions gl_;
    PainterPrograms programs_;
    MeshBufferCache meshes_{gl_};
    SampleTargets targets_;
    GlObject emptyVertexArray_;
    GlObject lineVertexArray_;
    GlObject lineVertices_;
    GlObject query_;
    std::string rendererName_;
    ViewTransform transform_; ///< of the picture being drawn, with its eye
    Eigen::Vector3d eye_{0, 0, 0};
};

Status ScenePainter::Implementation::initialise()
{
    if (!gl_.find.missing().empty())
        return Error{ErrorKind::OutOfResource, "The OpenGL driver has no function " + gl_.find.missing() +
                                                   ", so it is older than OpenGL 3.3. Use the CPU back end, or another "
                                                   "driver."};
    int major = 0;
    int minor = 0;
    gl_.getIntegerv(gl::majorVersion, &major);
    gl_.getIntegerv(gl::minorVersion, &minor);
    if (major * 10 + minor < 33)
        return Error{ErrorKind::OutOfResource, "The OpenGL driver has version " + std::to_string(major) + "." +
                                                   std::to_string(minor) +
                                                   "; TAn needs 3.3. Use the CPU back end, or another driver."};
    if (const unsigned char* name = gl_.getString(gl::renderer))
        rendererName_ = reinterpret_cast<const char*>(name);
    Result<PainterPrograms> programs = makePainterPrograms(gl_);
    if (!programs)
        return programs.error();
    programs_ = std::move(*programs);
    emptyVertexArray_ = {gl_.genVertexArrays, gl_.deleteVertexArrays};
    lineVertexArray_ = {gl_.genVertexArrays, gl_.deleteVertexArrays};
    lineVertices_ = {gl_.genBuffers, gl_.deleteBuffers};
    query_ = {gl_.genQueries, gl_.deleteQueries};
    return {};
}

Status ScenePainter::Implementation::prepareTargets(int width, int height)
{
    if (targets_.width == width && targets_.height == height)
        return {};
    targets_ = {};
    Result<SampleTargets> targets = makeSampleTargets(gl_, width, height);
    if (!targets)
        return targets.error();
    targets_ = std::move(*targets);
    return {};
}

Result<std::vector<DrawnSurface>> ScenePainter::Implementation::collectSurfaces(const Scene& scene)
{
    meshes_.dropDead();
    std::vector<DrawnSurface> surfaces;
    std::uint64_t triangles = 0;
    for (const Surface& surface : scene.surfaces) {
        if (!surface.mesh || !(surface.opacity > 0))
            continue;
        const Result<const MeshBuffers*> buffers = meshes_.buffersOf(surface.mesh);
        if (!buffers)
            return buffers.error();
        surfaces.push_back({&surface, *buffers, static_cast<unsigned>(triangles)});
        triangles += surface.mesh->triangles.size();
    }
    if (triangles >= std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource, "The scene has more than four thousand million triangles."};
    return surfaces;
}

void ScenePainter::Implementation::drawSurface(const GlProgram& program, const DrawnSurface& drawn) const
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
    program.set("light", Eigen::Vector3f(Shading::ambient, Shading::diffuse, Shading::specular));
    gl_.bindVertexArray(drawn.buffers->vertexArray.name());
    gl_.drawElements(gl::triangles, drawn.buffers->indexCount, gl::unsignedInt, nullptr);
}

void ScenePainter::Implementation::drawLines(const LineSet& lines, double samplesPerPixelAxis)
{
    std::vector<Eigen::Vector4f> corners;
    for (const LineQuad& quad : thickLines(lines, transform_, lines.width * samplesPerPixelAxis))
        for (const std::size_t corner : {0, 1, 2, 0, 2, 3})
            corners.emplace_back(quad[corner].cast<float>());
    gl_.bindVertexArray(lineVertexArray_.name());
    gl_.bindBuffer(gl::arrayBuffer, lineVertices_.name());
    gl_.bufferData(gl::arrayBuffer, static_cast<std::ptrdiff_t>(corners.size() * sizeof(corners[0])), corners.data(),
                   gl::streamDraw);
    gl_.enableVertexAttribArray(0);
    gl_.vertexAttribPointer(0, 4, gl::floatType, 0, 0, nullptr);
    programs_.line->use();
    programs_.line->set("colour", Eigen::Vector4f(lines.colour.red, lines.colour.green, lines.colour.blue, 1));
    gl_.drawArrays(gl::triangles, 0, static_cast<int>(corners.size()));
}

void ScenePainter::Implementation::drawOpaque(const Scene& scene, const std::vector<DrawnSurface>& surfaces,
                                              const PictureOptions& options)
{
    const Colour& background = options.background;
    const std::array<float, 4> colour =
        options.transparentBackground ? std::array<float, 4>{0, 0, 0, 0}
                                      : std::array<float, 4>{background.red, background.green, background.blue, 1};
    const float farthest = 1;
    gl_.bindFramebuffer(gl::framebuffer, targets_.opaqueFramebuffer.name());
    gl_.clearBufferfv(gl::colour, 0, colour.data());
    gl_.clearBufferfv(gl::depth, 0, &farthest);
    programs_.opaque->use();
    for (const DrawnSurface& surface : surfaces)
        if (isOpaque(*surface.surface))
            drawSurface(*programs_.opaque, surface);
    for (const LineSet& lines : scene.lines)
        drawLines(lines, options.samplesPerAxis);
}

/// Draws the layer behind the one before; false if it is empty.
bool ScenePainter::Implementation::drawLayer(const std::vector<DrawnSurface>& surfaces, std::size_t layer)
{
    const std::array<float, 4> nothing{};
    const float farthest = 1;
    constexpr unsigned last = 0xffffffff;
    const std::array<unsigned, 4> nothingBehind{last, last, 0, 0};
    gl_.bindFramebuffer(gl::framebuffer, targets_.layerFramebuffers[layer % 2].name());
    gl_.clearBufferfv(gl::colour, 0, nothing.data());
    gl_.clearBufferuiv(gl::colour, 1, nothingBehind.data());
    gl_.clearBufferfv(gl::depth, 0, &farthest);

    const GlProgram& program = *programs_.peel;
    program.use();
    program.setTexture("opaqueDepth", 0, targets_.opaqueDepth.name());
    program.setTexture("previousLayer", 1, targets_.layerKeys[(layer + 1) % 2].name());
    program.setTexture("accumulated", 2, targets_.accumulated.name());
    program.set("saturated", saturatedOpacity);
    gl_.beginQuery(gl::anySamplesPassed, query_.name());
    for (const DrawnSurface& surface : surfaces) {
        if (isOpaque(*surface.surface))
            continue;
        program.set("firstTriangle", surface.firstTriangle);
        drawSurface(program, surface);
    }
    gl_.endQuery(gl::anySamplesPassed);
    unsigned drawn = 0;
    gl_.getQueryObjectuiv(query_.name(), gl::queryResult, &drawn);
    return drawn != 0;
}

Status ScenePainter::Implementation::peel(const std::vector<DrawnSurface>& surfaces, const Progress& progress)
{
    if (!targets_.hasLayers()) {
        Status status = makeLayers(gl_, targets_);
        if (!status) {
            targets_ = {};
            return status;
        }
    }
    const std::array<float, 4> nothing{};
    const std::array<unsigned, 4> nothingBefore{};
    gl_.bindFramebuffer(gl::framebuffer, targets_.accumulatedFramebuffer.name());
    gl_.clearBufferfv(gl::colour, 0, nothing.data());
    gl_.bindFramebuffer(gl::framebuffer, targets_.layerFramebuffers[1].name());
    gl_.clearBufferuiv(gl::colour, 1, nothingBefore.data());

    for (std::size_t layer = 0; drawLayer(surfaces, layer); ++layer) {
        if (progress.cancelled())
            return cancelledError(activity);
        gl_.bindFramebuffer(gl::framebuffer, targets_.accumulatedFramebuffer.name());
        gl_.disable(gl::depthTest);
        gl_.enable(gl::blend);
        gl_.blendFunc(gl::oneMinusDestinationAlpha, gl::one);
        programs_.under->use();
        programs_.under->setTexture("layer", 0, targets_.layerColour.name());
        drawOverScreen();
        gl_.disable(gl::blend);
        gl_.enable(gl::depthTest);
        progress.report(0.9 - 0.8 / static_cast<double>(layer + 2), activity); // how many come is not known
    }
    return {};
}

void ScenePainter::Implementation::drawOverScreen() const
{
    gl_.bindVertexArray(emptyVertexArray_.name());
    gl_.drawArrays(gl::triangles, 0, 3);
}

void ScenePainter::Implementation::resolve(const PictureOptions& options, bool layered, unsigned framebuffer) const
{
    gl_.bindFramebuffer(gl::framebuffer, framebuffer);
    gl_.viewport(0, 0, options.width, options.height);
    gl_.disable(gl::depthTest);
    const GlProgram& program = *programs_.resolve;
    program.use();
    program.setTexture("opaqueColour", 0, targets_.opaqueColour.name());
    program.setTexture("accumulated", 1, layered ? targets_.accumulated.name() : targets_.opaqueColour.name());
    program.set("layered", layered ? 1 : 0);
    program.set("samplesPerAxis", options.samplesPerAxis);
    drawOverScreen();
    gl_.useProgram(0);
    gl_.bindVertexArray(0);
    for (const unsigned unit : {2u, 1u, 0u}) {
        gl_.activeTexture(gl::texture0 + unit);
        gl_.bindTexture(gl::texture2D, 0);
    }
}

Status ScenePainter::Implementation::draw(const Scene& scene, const Camera& camera, const PictureOptions& options,
                                          unsigned framebuffer, const Progress& progress)
{
    if (Status status = checkOptions(options); !status)
        return status;
    for (const LineSet& lines : scene.lines)
        if (Status status = checkLines(lines); !status)
            return status;
    if (progress.cancelled())
        return cancelledError(activity);
    progress.report(0, activity);
    forgetErrors(gl_);
    const int width = options.width * options.samplesPerAxis;
    const int height = options.height * options.samplesPerAxis;
    if (Status status = prepareTargets(width, height); !status)
        return status;
    transform_ = makeViewTransform(camera, width, height, scene.bounds);
    eye_ = eyePosition(camera);
    const Result<std::vector<DrawnSurface>> surfaces = collectSurfaces(scene);
    if (!surfaces)
        return surfaces.error();

    for (const unsigned state :
         {gl::blend, gl::cullFace, gl::scissorTest, gl::stencilTest, gl::dither, gl::framebufferSrgb})
        gl_.disable(state);
    gl_.enable(gl::depthTest);
    gl_.depthFunc(gl::less);
    gl_.depthMask(1);
    gl_.colorMask(1, 1, 1, 1);
    gl_.viewport(0, 0, width, height);
    drawOpaque(scene, *surfaces, options);
    progress.report(0.1, activity);
    const bool layered =
        std::ranges::any_of(*surfaces, [](const DrawnSurface& surface) { return !isOpaque(*surface.surface); });
    Status status;
    if (layered)
        status = peel(*surfaces, progress);
    resolve(options, layered && targets_.hasLayers(), framebuffer); // also then: it leaves the state as promised
    progress.report(1, activity);
    return status;
}

ScenePainter::ScenePainter(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation))
{
}

ScenePainter::~ScenePainter() = default;

Result<std::unique_ptr<ScenePainter>> ScenePainter::make(const GetProcAddress& getProcAddress)
{
    auto implementation = std::make_unique<Implementation>(getProcAddress);
    if (Status status = implementation->initialise(); !status)
        return status.error();
    return std::unique_ptr<ScenePainter>(new ScenePainter(std::move(implementation)));
}

Status ScenePainter::draw(const Scene& scene, const Camera& camera, const PictureOptions& options, unsigned framebuffer,
                          const Progress& progress)
{
    try {
        return implementation_->draw(scene, camera, options, framebuffer, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory for a picture of this size and scene. Make the "
                                               "picture smaller or lower the accuracy of the mesh."};
    }
}

const std::string& ScenePainter::rendererName() const noexcept
{
    return implementation_->rendererName();
}

} // namespace tetra
