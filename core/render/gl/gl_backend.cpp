// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/render/gl/egl_context.h"
#include "core/render/gl/gl_buffers.h"
#include "core/render/gl/gl_functions.h"
#include "core/render/gl/scene_painter.h"
#include "core/render/resolve.h"
#include "core/render/scene_checks.h"
#include "core/render/tiles.h"

#include <tan/render.h>

#include <algorithm>

namespace tetra {
namespace {

Error notCurrentError()
{
    return {
        ErrorKind::OutOfResource,
        Message::say(
            "The OpenGL context cannot be used, perhaps because the graphics card was reset. Use the CPU back end.")};
}

/// A framebuffer of 8-bit pixels to draw into and read back.
struct PictureTarget {
    GlObject texture;
    GlObject framebuffer;
};

PictureTarget makePictureTarget(const GlFunctions& gl, int width, int height)
{
    PictureTarget target{{gl.genTextures, gl.deleteTextures}, {gl.genFramebuffers, gl.deleteFramebuffers}};
    gl.bindTexture(gl::texture2D, target.texture.name());
    gl.texImage2D(gl::texture2D, 0, static_cast<int>(gl::rgba8), width, height, 0, gl::rgba, gl::unsignedByte, nullptr);
    gl.bindTexture(gl::texture2D, 0);
    gl.bindFramebuffer(gl::framebuffer, target.framebuffer.name());
    gl.framebufferTexture2D(gl::framebuffer, gl::colourAttachment0, gl::texture2D, target.texture.name(), 0);
    return target;
}

/// OpenGL's rows run upwards, a picture's downwards.
Picture readPicture(const GlFunctions& gl, int width, int height)
{
    Picture picture{width, height, {}};
    const auto rowLength = static_cast<std::ptrdiff_t>(width);
    picture.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl.pixelStorei(gl::packAlignment, 1);
    gl.readPixels(0, 0, width, height, gl::rgba, gl::unsignedByte, picture.pixels.data());
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(picture.pixels.begin() + y * rowLength, picture.pixels.begin() + (y + 1) * rowLength,
                         picture.pixels.begin() + (height - 1 - y) * rowLength);
    return picture;
}

class GlBackend final : public RenderBackend {
public:
    explicit GlBackend(std::unique_ptr<EglContext> context)
        : context_(std::move(context)), gl_(context_->getProcAddress())
    {
    }
    ~GlBackend() override
    {
        const EglContext::Current current(*context_);
        painter_.reset();
    }

    Status initialise()
    {
        const EglContext::Current current(*context_);
        if (!current.ok())
            return notCurrentError();
        Result<std::unique_ptr<ScenePainter>> painter = ScenePainter::make(context_->getProcAddress());
        if (!painter)
            return painter.error();
        painter_ = std::move(*painter);
        return {};
    }

    std::string_view id() const noexcept override { return "gl"; }

    Result<Picture> render(const Scene& scene, const Camera& camera, const PictureOptions& options,
                           const Progress& progress) override
    {
        if (Status status = checkOptions(options); !status)
            return status.error();
        const EglContext::Current current(*context_);
        if (!current.ok())
            return notCurrentError();
        return guarded(noMemoryForPicture, [&]() -> Result<Picture> {
            const PixelRectangle wanted = drawnPart(options);
            const int samples = options.samplesPerAxis;
            const std::vector<SampleRectangle> parts =
                partsOf({0, 0, wanted.width * samples, wanted.height * samples}, samples,
                        std::min(largestPartSide, painter_->largestSide()));
            RenderStatistics statistics;
            if (parts.size() == 1)
                return drawPart(scene, camera, options, wanted, progress, statistics_);
            Picture picture{wanted.width, wanted.height, {}};
            const auto pixels = static_cast<std::size_t>(wanted.width) * static_cast<std::size_t>(wanted.height);
            picture.pixels.resize(pixels);
            picture.depth.resize(options.depth ? pixels : 0);
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const int left = parts[i].left / samples, top = parts[i].top / samples;
                const PixelRectangle part{wanted.left + left, wanted.top + top, parts[i].width() / samples,
                                          parts[i].height() / samples};
                const auto share = [&](std::size_t done) { return double(done) / double(parts.size()); };
                RenderStatistics ofPart;
                const Result<Picture> drawn =
                    drawPart(scene, camera, options, part, progress.part(share(i), share(i + 1)), ofPart);
                if (!drawn)
                    return drawn.error();
                putInto(*drawn, left, top, picture);
                add(ofPart, i == 0, statistics);
            }
            statistics_ = statistics;
            return picture;
        });
    }

    RenderStatistics statistics() const override { return statistics_; }

private:
    Result<Picture> drawPart(const Scene& scene, const Camera& camera, const PictureOptions& options,
                             const PixelRectangle& part, const Progress& progress, RenderStatistics& statistics)
    {
        PictureOptions ofPart = options;
        ofPart.part = part;
        const PictureTarget target = makePictureTarget(gl_, part.width, part.height);
        if (Status status = painter_->draw(scene, camera, ofPart, target.framebuffer.name(), progress); !status)
            return status.error();
        Picture picture = readPicture(gl_, part.width, part.height);
        picture.depth = painter_->takeDepth();
        statistics = painter_->statistics();
        return picture;
    }

    static void add(const RenderStatistics& part, bool isFirst, RenderStatistics& sum)
    {
        sum.cells += part.cells;
        sum.fragments += part.fragments;
        sum.cutCells = std::max(sum.cutCells, part.cutCells);
        sum.brokenCycles = std::max(sum.brokenCycles, part.brokenCycles);
        sum.orderReused = part.orderReused && (isFirst || sum.orderReused);
        sum.orderSeconds += part.orderSeconds;
        sum.setUpSeconds += part.setUpSeconds;
        sum.fillSeconds += part.fillSeconds;
        sum.sentBytes += part.sentBytes;
    }

    std::unique_ptr<EglContext> context_;
    GlFunctions gl_;
    std::unique_ptr<ScenePainter> painter_;
    RenderStatistics statistics_;
};

} // namespace

Result<std::unique_ptr<RenderBackend>> makeGlBackend()
{
    Result<std::unique_ptr<EglContext>> context = EglContext::make();
    if (!context)
        return context.error();
    auto backend = std::make_unique<GlBackend>(std::move(*context));
    if (Status status = backend->initialise(); !status)
        return status.error();
    return std::unique_ptr<RenderBackend>(std::move(backend));
}

} // namespace tetra
