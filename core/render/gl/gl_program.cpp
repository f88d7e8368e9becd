// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/gl/gl_program.h"

#include "core/render/focus_weight.h"
#include "core/render/shading.h"

#include <tan_shaders.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace tetra {

namespace {

/// The length of the arrays in cut.frag and volume.frag.
constexpr std::size_t largestClipPlaneCount = 16;

std::string logOf(unsigned name, GlFunctions::Function<GlFunctions::GetInteger> getInteger,
                  GlFunctions::Function<GlFunctions::GetLog> getLog)
{
    int length = 0;
    getInteger(name, gl::infoLogLength, &length);
    std::string text(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
    getLog(name, length, &length, text.data());
    text.resize(static_cast<std::size_t>(length > 0 ? length : 0));
    return text;
}

Error driverError(const std::string& log)
{
    return {ErrorKind::OutOfResource, Message::say("The OpenGL driver of this machine rejects a shader of TAn. Use the "
                                                   "CPU back end, or another driver. It reports: %1",
                                                   log)};
}

Status attach(const GlFunctions& gl, unsigned program, unsigned kind, const char* source,
              const GlProgram::Refusal& refusal)
{
    const unsigned shader = gl.createShader(kind);
    gl.shaderSource(shader, 1, &source, nullptr);
    gl.compileShader(shader);
    int compiled = 0;
    gl.getShaderiv(shader, gl::compileStatus, &compiled);
    Status status;
    if (compiled == 0)
        status = refusal(logOf(shader, gl.getShaderiv, gl.getShaderInfoLog));
    gl.attachShader(program, shader);
    gl.deleteShader(shader); // lives on as long as the program
    return status;
}

} // namespace

Result<std::unique_ptr<GlProgram>> GlProgram::make(const GlFunctions& gl, const char* vertexShader,
                                                   std::span<const char* const> fragmentShaders, const Refusal& refusal)
{
    const Refusal refused = refusal ? refusal : Refusal(driverError);
    std::unique_ptr<GlProgram> program(new GlProgram(gl, gl.createProgram()));
    Status status = attach(gl, program->name_, gl::vertexShader, vertexShader, refused);
    for (const char* shader : fragmentShaders)
        if (status)
            status = attach(gl, program->name_, gl::fragmentShader, shader, refused);
    if (!status)
        return status.error();
    return linked(std::move(program), refused);
}

Result<std::unique_ptr<GlProgram>> GlProgram::linked(std::unique_ptr<GlProgram> program, const Refusal& refusal)
{
    const GlFunctions& gl = program->gl_;
    gl.linkProgram(program->name_);
    int linked = 0;
    gl.getProgramiv(program->name_, gl::linkStatus, &linked);
    if (linked == 0)
        return refusal(logOf(program->name_, gl.getProgramiv, gl.getProgramInfoLog));
    return program;
}

GlProgram::~GlProgram()
{
    gl_.deleteProgram(name_);
}

void GlProgram::setTexture(const char* uniform, int unit, unsigned texture, unsigned target) const
{
    gl_.activeTexture(gl::texture0 + static_cast<unsigned>(unit));
    gl_.bindTexture(target, texture);
    set(uniform, unit);
}

void forgetErrors(const GlFunctions& gl)
{
    // A lost context gives them without end.
    for (int i = 0; i < 16 && gl.getError() != 0; ++i) {
    }
}

void setDrawingState(const GlFunctions& gl)
{
    for (const unsigned state :
         {gl::blend, gl::cullFace, gl::scissorTest, gl::stencilTest, gl::dither, gl::framebufferSrgb})
        gl.disable(state);
    gl.enable(gl::depthTest);
    gl.depthFunc(gl::less);
    gl.depthMask(1);
    gl.colorMask(1, 1, 1, 1);
}

void startBlendingUnder(const GlFunctions& gl)
{
    gl.disable(gl::depthTest);
    gl.enable(gl::blend);
    gl.blendFunc(gl::oneMinusDestinationAlpha, gl::one);
}

void endBlending(const GlFunctions& gl)
{
    gl.disable(gl::blend);
    gl.enable(gl::depthTest);
}

void leaveDrawingState(const GlFunctions& gl)
{
    gl.disable(gl::depthTest);
    gl.useProgram(0);
    gl.bindVertexArray(0);
    for (unsigned unit = textureUnits; unit-- > 0;) {
        gl.activeTexture(gl::texture0 + unit);
        gl.bindTexture(gl::texture2D, 0);
        gl.bindTexture(gl::textureBuffer, 0);
    }
}

Status checkClipPlanes(std::span<const ClipPlane> planes)
{
    if (planes.size() > largestClipPlaneCount)
        return Error{ErrorKind::OutOfResource,
                     Message::say("OpenGL supports at most %1 clip planes. Use fewer, or use the CPU back end.",
                                  largestClipPlaneCount)};
    return {};
}

Status checkRegions(const Scene& scene)
{
    std::size_t most = 0;
    for (const FocusVolume* focus : shapesOf<FocusVolume>(scene))
        most = std::max(most, focus->regions.size());
    for (const Surface* surface : shapesOf<Surface>(scene))
        most = std::max(most, surface->share ? surface->share->regions.size() : 0);
    if (most > largestRegionCount)
        return Error{ErrorKind::OutOfResource,
                     Message::say("OpenGL draws at most %1 focus regions. Take fewer, or use the CPU back end.",
                                  largestRegionCount)};
    return {};
}

void setCuts(const GlProgram& program, std::span<const ClipPlane> planes, const Eigen::Vector3d& origin)
{
    std::vector<Eigen::Vector4f> cuts;
    for (const ClipPlane& plane : planes) {
        const Eigen::Vector3f normal = plane.normal.cast<float>();
        cuts.emplace_back(normal.x(), normal.y(), normal.z(),
                          static_cast<float>(plane.normal.dot(origin) - plane.offset));
    }
    program.set("cutCount", static_cast<int>(cuts.size()));
    program.set("cuts", cuts);
}

void setLights(const GlProgram& program)
{
    const auto vectorOf = [](const CameraLight& light) {
        return Eigen::Vector4f(light.right, light.up, light.back, light.strength);
    };
    std::vector<Eigen::Vector4f> lights;
    std::ranges::transform(Shading::lights, std::back_inserter(lights), vectorOf);
    program.set("ownLight", Eigen::Vector2f(Shading::ambient, Shading::headlight));
    program.set("twoSided", Shading::twoSided);
    program.set("lights", lights);
    program.set("highlight", vectorOf(Shading::highlight));
}

namespace {

std::string volumeVertexShader()
{
    return std::string("#version 330 core\n") + shaders::imageGlsl + shaders::cellGlsl + shaders::facesGlsl +
           shaders::volumeVert;
}

/// Whose mistake it is that the text of an optical model cannot be used.
GlProgram::Refusal refusalOf(const std::string& maker)
{
    return [maker](const std::string& log) {
        return Error{ErrorKind::BadInput,
                     maker.empty()
                         ? Message::say("The shader of an optical model cannot be used. The compiler says: %1", log)
                         : Message::say("The plugin '%1' has an optical model whose shader cannot be used. This is a "
                                        "fault of the plugin; tell its author. The compiler says: %2",
                                        maker, log)};
    };
}

} // namespace

Result<std::unique_ptr<GlProgram>> makeModelProgram(const GlFunctions& gl, const std::string& shader,
                                                    const std::string& maker)
{
    const std::string text = "#version 330 core\n" + shader;
    return GlProgram::make(
        gl, volumeVertexShader().c_str(),
        std::array{shaders::volumeFrag, shaders::modelFrag, shaders::lightsFrag, shaders::focusFrag, text.c_str()},
        refusalOf(maker));
}

Result<std::unique_ptr<GlProgram>> makeRayProgram(const GlFunctions& gl, const std::string& shader,
                                                  const std::string& maker)
{
    const std::string text = "#version 330 core\n"
                             "uniform samplerBuffer rayData;\n"
                             "vec4 rayDatum(int number) { return texelFetch(rayData, number); }\n"
                             "int rayDataCount() { return textureSize(rayData); }\n"
                             "#line 1\n" +
                             shader;
    return GlProgram::make(gl, shaders::screenVert, std::array{shaders::rayFrag, text.c_str()}, refusalOf(maker));
}

Result<PainterPrograms> makePainterPrograms(const GlFunctions& gl)
{
    PainterPrograms programs;
    Status status;
    const auto make = [&](std::unique_ptr<GlProgram>& program, const char* vertexShader,
                          std::span<const char* const> fragmentShaders) {
        if (!status)
            return;
        Result<std::unique_ptr<GlProgram>> made = GlProgram::make(gl, vertexShader, fragmentShaders);
        if (made)
            program = std::move(*made);
        else
            status = made.error();
    };
    make(programs.opaque, shaders::surfaceVert,
         std::array{shaders::opaqueFrag, shaders::lightingFrag, shaders::lightsFrag, shaders::cutFrag});
    make(programs.peel, shaders::surfaceVert,
         std::array{shaders::peelFrag, shaders::lightingFrag, shaders::lightsFrag, shaders::cutFrag});
    make(programs.line, shaders::lineVert, std::array{shaders::lineFrag});
    make(programs.under, shaders::screenVert, std::array{shaders::underFrag});
    make(programs.resolve, shaders::screenVert, std::array{shaders::resolveFrag});
    make(programs.saturated, shaders::screenVert, std::array{shaders::saturatedFrag});
    make(programs.bisect, shaders::screenVert, std::array{shaders::bisectFrag});
    make(programs.limit, shaders::screenVert, std::array{shaders::limitFrag});
    make(programs.volume, volumeVertexShader().c_str(),
         std::array{shaders::volumeFrag, shaders::slabFrag, shaders::lightsFrag, shaders::focusFrag});
    if (!status)
        return status.error();
    return programs;
}

} // namespace tetra
