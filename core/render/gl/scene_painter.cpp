// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/scene_painter.h"

#include "core/render/gl/gl_program.h"
#include "core/render/gl/sample_targets.h"
#include "core/render/gl/surface_painter.h"
#include "core/render/gl/volume_painter.h"
#include "core/render/scene_checks.h"
#include "core/render/tiles.h"
#include "core/render/volume/volume_mesh.h"

#include <tan/render.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr MarkedText drawingScene = Message::marked("Drawing the picture");

/// Behind this opacity nothing changes an 8-bit channel; half floats cannot tell much more from 1.
constexpr float saturatedOpacity = 1 - 1.0f / 1024;

constexpr std::array<float, 4> transparentBlack{};
constexpr float farthestDepth = 1;

} // namespace

class ScenePainter::Implementation {
public:
    explicit Implementation(const GetProcAddress& getProcAddress) : gl_(getProcAddress), volume_(gl_) {}

    Status initialise();
    Status draw(const Scene& scene, const Camera& camera, const PictureOptions& options, unsigned framebuffer,
                const Progress& progress);
    const std::string& rendererName() const noexcept { return rendererName_; }
    int largestSide() const noexcept { return largestTargetSide(gl_); }
    const RenderStatistics& statistics() const noexcept { return statistics_; }
    std::vector<float> takeDepth() noexcept { return std::move(depth_); }

private:
    Status prepareTargets(const SampleView& view, bool layers, bool fine);
    void drawOpaque(const PictureOptions& options) const;
    bool drawLayer(std::size_t layer, unsigned nearest) const;
    void startBlending() const;
    Status peel(bool withVolume, unsigned nearest, const Progress& progress);
    Status drawVolume(const VolumeLayers& layers, const Progress& progress);
    Status drawVolumeBefore(unsigned nearest, const Progress& progress);
    Status drawTranslucent(bool withVolume, unsigned nearest, const Progress& progress);
    Status findDepth(bool withVolume, const SampleView& view, const PictureOptions& options, const Progress& progress);
    void drawOverScreen() const;
    void resolve(const PictureOptions& options, bool accumulated, unsigned framebuffer) const;

    const GlFunctions gl_;
    PainterPrograms programs_;
    std::optional<SurfacePainter> surfaces_;
    VolumePainter volume_;
    SampleTargets targets_;
    MedianDepth medianDepth_{gl_};
    GlObject emptyVertexArray_;
    GlObject layerQuery_;
    GlObject fragmentQuery_;
    std::string rendererName_;
    RenderStatistics statistics_;
    std::vector<float> depth_;
};

Status ScenePainter::Implementation::initialise()
{
    if (!gl_.find.missing().empty())
        return Error{ErrorKind::OutOfResource, Message::say("The OpenGL driver has no function %1, so it is older than "
                                                            "OpenGL 3.3. Use the CPU back end, or another driver.",
                                                            gl_.find.missing())};
    int major = 0;
    int minor = 0;
    gl_.getIntegerv(gl::majorVersion, &major);
    gl_.getIntegerv(gl::minorVersion, &minor);
    if (major * 10 + minor < 33)
        return Error{
            ErrorKind::OutOfResource,
            Message::say("The OpenGL driver has version %1.%2; TAn needs 3.3. Use the CPU back end, or another driver.",
                         major, minor)};
    if (const unsigned char* name = gl_.getString(gl::renderer))
        rendererName_ = reinterpret_cast<const char*>(name);
    Result<PainterPrograms> programs = makePainterPrograms(gl_);
    if (!programs)
        return programs.error();
    programs_ = std::move(*programs);
    emptyVertexArray_ = {gl_.genVertexArrays, gl_.deleteVertexArrays};
    layerQuery_ = {gl_.genQueries, gl_.deleteQueries};
    fragmentQuery_ = {gl_.genQueries, gl_.deleteQueries};
    surfaces_.emplace(gl_, programs_);
    return {};
}

Status ScenePainter::Implementation::prepareTargets(const SampleView& view, bool layers, bool fine)
{
    Status status;
    const int width = view.part.width(), height = view.part.height();
    if (targets_.width != width || targets_.height != height) {
        targets_ = {};
        status = makeSampleTargets(gl_, width, height, targets_);
    }
    if (status && (layers || fine))
        status = makeAccumulated(gl_, fine, targets_);
    if (status && layers)
        status = makeLayers(gl_, targets_);
    if (!status)
        targets_ = {};
    return status;
}

void ScenePainter::Implementation::drawOpaque(const PictureOptions& options) const
{
    const Colour& background = options.background;
    const std::array<float, 4> colour =
        options.transparentBackground ? std::array<float, 4>{0, 0, 0, 0}
                                      : std::array<float, 4>{background.red, background.green, background.blue, 1};
    gl_.bindFramebuffer(gl::framebuffer, targets_.opaqueFramebuffer.name());
    gl_.clearBufferfv(gl::colour, 0, colour.data());
    gl_.clearBufferfv(gl::depth, 0, &farthestDepth);
    surfaces_->drawOpaque();
}

/// Draws the layer behind the one before, and before the depths in the texture `nearest`; false if it is empty.
bool ScenePainter::Implementation::drawLayer(std::size_t layer, unsigned nearest) const
{
    constexpr unsigned last = 0xffffffff;
    const std::array<unsigned, 4> nothingBehind{last, last, 0, 0};
    gl_.bindFramebuffer(gl::framebuffer, targets_.layerFramebuffers[layer % 2].name());
    gl_.clearBufferfv(gl::colour, 0, transparentBlack.data());
    gl_.clearBufferuiv(gl::colour, 1, nothingBehind.data());
    gl_.clearBufferfv(gl::depth, 0, &farthestDepth);

    const GlProgram& program = *programs_.peel;
    program.use();
    program.setTexture("opaqueDepth", 0, nearest);
    program.setTexture("previousLayer", 1, targets_.layerKeys[(layer + 1) % 2].name());
    program.setTexture("accumulated", 2, targets_.accumulated.name());
    program.set("saturated", saturatedOpacity);
    gl_.beginQuery(gl::anySamplesPassed, layerQuery_.name());
    surfaces_->drawTranslucent(program);
    gl_.endQuery(gl::anySamplesPassed);
    unsigned drawn = 0;
    gl_.getQueryObjectuiv(layerQuery_.name(), gl::queryResult, &drawn);
    return drawn != 0;
}

void ScenePainter::Implementation::startBlending() const
{
    gl_.bindFramebuffer(gl::framebuffer, targets_.accumulatedFramebuffer.name());
    startBlendingUnder(gl_);
}

/// Draws the volume before each layer of the translucent surfaces, the layer, and the volume behind all.
Status ScenePainter::Implementation::peel(bool withVolume, unsigned nearest, const Progress& progress)
{
    const std::array<unsigned, 4> nothingBefore{};
    gl_.bindFramebuffer(gl::framebuffer, targets_.layerFramebuffers[1].name());
    gl_.clearBufferuiv(gl::colour, 1, nothingBefore.data());
    bool anyLeft = true;
    for (std::size_t layer = 0; anyLeft; ++layer) {
        if (progress.cancelled())
            return cancelledError(drawingScene);
        anyLeft = drawLayer(layer, nearest);
        startBlending();
        Status status;
        if (withVolume)
            status = drawVolume(
                {nearest, targets_.layerKeys[(layer + 1) % 2].name(), targets_.layerKeys[layer % 2].name()}, progress);
        if (anyLeft && status) {
            programs_.under->use();
            programs_.under->setTexture("layer", 0, targets_.layerColour.name());
            drawOverScreen();
        }
        endBlending(gl_);
        if (!status)
            return status;
        progress.report(1 - 1 / static_cast<double>(layer + 2), drawingScene); // how many come is not known
    }
    return {};
}

Status ScenePainter::Implementation::drawVolume(const VolumeLayers& layers, const Progress& progress)
{
    gl_.bindVertexArray(emptyVertexArray_.name());
    gl_.beginQuery(gl::samplesPassed, fragmentQuery_.name());
    Status status = volume_.draw(programs_, targets_, layers, progress);
    gl_.endQuery(gl::samplesPassed);
    unsigned fragments = 0;
    gl_.getQueryObjectuiv(fragmentQuery_.name(), gl::queryResult, &fragments);
    statistics_.fragments += fragments;
    return status;
}

void ScenePainter::Implementation::drawOverScreen() const
{
    gl_.bindVertexArray(emptyVertexArray_.name());
    gl_.drawArrays(gl::triangles, 0, 3);
}

void ScenePainter::Implementation::resolve(const PictureOptions& options, bool accumulated, unsigned framebuffer) const
{
    gl_.bindFramebuffer(gl::framebuffer, framebuffer);
    gl_.viewport(0, 0, targets_.width / options.samplesPerAxis, targets_.height / options.samplesPerAxis);
    gl_.disable(gl::depthTest);
    const GlProgram& program = *programs_.resolve;
    program.use();
    program.setTexture("opaqueColour", 0, targets_.opaqueColour.name());
    program.setTexture("accumulated", 1, accumulated ? targets_.accumulated.name() : targets_.opaqueColour.name());
    program.set("layered", accumulated ? 1 : 0);
    program.set("samplesPerAxis", options.samplesPerAxis);
    drawOverScreen();
}

/// Draws a volume whose pieces are not put over each other, as a whole.
Status ScenePainter::Implementation::drawVolumeBefore(unsigned nearest, const Progress& progress)
{
    const GlProgram* rays = volume_.rayProgram();
    if (rays != nullptr) {
        if (Status status = makeGathered(gl_, targets_); !status)
            return status;
        gl_.bindFramebuffer(gl::framebuffer, targets_.gatheredFramebuffer.name());
        gl_.clearBufferfv(gl::colour, 0, transparentBlack.data());
    }
    gl_.disable(gl::depthTest);
    gl_.enable(gl::blend);
    gl_.blendFunc(gl::one, gl::one);
    gl_.blendEquation(volume_.combiner() == Combiner::Maximum ? gl::largest : gl::sum);
    Status status = drawVolume({nearest}, progress);
    gl_.blendEquation(gl::smallest);
    programs_.limit->use();
    drawOverScreen();
    gl_.blendEquation(gl::sum);
    endBlending(gl_);
    if (rays != nullptr) {
        gl_.bindFramebuffer(gl::framebuffer, targets_.accumulatedFramebuffer.name());
        gl_.disable(gl::depthTest);
        rays->use();
        rays->setTexture("gathered", 0, targets_.gathered.name());
        volume_.setRayData();
        drawOverScreen();
    }
    return status;
}

/// Draws surfaces and volume that lie before the depths in the texture `nearest`.
Status ScenePainter::Implementation::drawTranslucent(bool withVolume, unsigned nearest, const Progress& progress)
{
    gl_.bindFramebuffer(gl::framebuffer, targets_.accumulatedFramebuffer.name());
    gl_.clearBufferfv(gl::colour, 0, transparentBlack.data());
    if (withVolume)
        gl_.clearBufferfv(gl::depth, 0, &farthestDepth);
    if (withVolume && volume_.combiner() != Combiner::Over) {
        if (Status status = drawVolumeBefore(nearest, progress); !status)
            return status;
        withVolume = false;
    }
    if (surfaces_->anyTranslucent())
        return peel(withVolume, nearest, progress);
    if (!withVolume)
        return {};
    startBlending();
    Status status = drawVolume({nearest}, progress);
    endBlending(gl_);
    return status;
}

Status ScenePainter::Implementation::findDepth(bool withVolume, const SampleView& view, const PictureOptions& options,
                                               const Progress& progress)
{
    if (Status status = medianDepth_.prepare(view.part.width(), view.part.height()); !status)
        return status;
    gl_.viewport(0, 0, view.part.width(), view.part.height());
    const Progress silent = progress.withCallback({});
    const std::size_t fragments = statistics_.fragments;
    for (int step = 0; step <= MedianDepth::steps; ++step) {
        setDrawingState(gl_);
        if (step > 0)
            if (Status status = drawTranslucent(withVolume, medianDepth_.nearest(), silent); !status)
                return status;
        gl_.disable(gl::depthTest);
        medianDepth_.bindStep(*programs_.bisect, targets_, step == 0);
        drawOverScreen();
        medianDepth_.stepDone();
        progress.report(static_cast<double>(step) / MedianDepth::steps, drawingScene);
    }
    statistics_.fragments = fragments;
    std::vector<float> depths = medianDepth_.read();
    depth_ = pixelDepths(depths, view, options.samplesPerAxis);
    return {};
}

Status ScenePainter::Implementation::draw(const Scene& scene, const Camera& camera, const PictureOptions& options,
                                          unsigned framebuffer, const Progress& progress)
{
    if (Status status = checkOptions(options); !status)
        return status;
    if (Status status = checkClipPlanes(scene.clipPlanes); !status)
        return status;
    if (Status status = checkVolumes(scene); !status)
        return status;
    if (samplesOf(scene) != nullptr || scene.reference)
        return Error{ErrorKind::WrongUsage,
                     Message::say("OpenGL does not draw the samples of a lattice, nor differences to them. Let the CPU "
                                  "draw this picture.")};
    if (Status status = checkRegions(scene); !status)
        return status;
    if (progress.cancelled())
        return cancelledError(drawingScene);
    progress.report(0, drawingScene);
    forgetErrors(gl_);
    const int samples = options.samplesPerAxis;
    const PixelRectangle part = drawnPart(options);
    const SampleRectangle drawn{part.left * samples, part.top * samples, (part.left + part.width) * samples,
                                (part.top + part.height) * samples};
    volume_.dropDead();
    const bool withVolume = volumeOf(scene) != nullptr;
    const SampleView view{camera, options.width * samples, options.height * samples,
                          drawn,  drawnBounds(scene),      withVolume};
    if (Status status = surfaces_->prepare(scene, view, options.samplesPerAxis); !status)
        return status;
    const bool layered = surfaces_->anyTranslucent() || withVolume || options.depth;
    if (Status status = prepareTargets(view, surfaces_->anyTranslucent(), withVolume || options.depth); !status)
        return status;
    statistics_ = {};
    depth_.clear();
    if (withVolume) {
        if (Status status = volume_.prepare(scene, view, options, progress.part(0, 0.3)); !status)
            return status;
        statistics_ = volume_.statistics();
    }
    const auto start = std::chrono::steady_clock::now();
    setDrawingState(gl_);
    gl_.viewport(0, 0, drawn.width(), drawn.height());
    drawOpaque(options);
    progress.report(0.4, drawingScene);
    Status status;
    if (layered)
        status = drawTranslucent(withVolume, targets_.opaqueDepth.name(), progress.part(0.4, options.depth ? 0.5 : 1));
    resolve(options, layered, framebuffer);
    if (status && options.depth)
        status = findDepth(withVolume && volume_.combiner() == Combiner::Over, view, options, progress.part(0.5, 1));
    leaveDrawingState(gl_); // also if something went wrong
    gl_.bindFramebuffer(gl::framebuffer, framebuffer);
    if (status && gl_.getError() == gl::outOfMemory)
        status = Error{ErrorKind::OutOfResource, Message::say("The graphics card does not have enough memory for this "
                                                              "picture. Make it smaller, or use the CPU back end.")};
    statistics_.fillSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    progress.report(1, drawingScene);
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
    return guardedDrawing(scene.maker, [&] {
        const auto drawn = withDrawn(scene, camera, options.width, options.height);
        return implementation_->draw(drawn ? *drawn : scene, camera, options, framebuffer, progress);
    });
}

int ScenePainter::largestSide() const noexcept
{
    return implementation_->largestSide();
}

const std::string& ScenePainter::rendererName() const noexcept
{
    return implementation_->rendererName();
}

RenderStatistics ScenePainter::statistics() const noexcept
{
    return implementation_->statistics();
}

std::vector<float> ScenePainter::takeDepth() noexcept
{
    return implementation_->takeDepth();
}

} // namespace tetra
