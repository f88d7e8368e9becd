// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_functions.h"

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace tetra {

/// Texture units that are used here; every OpenGL 3.3 has as many.
inline constexpr int textureUnits = 9;

/// A shader program. The context must be current for everything, also when it goes; `gl` must outlive it.
class GlProgram {
public:
    /// The error for what the driver's compiler says.
    using Refusal = std::function<Error(const std::string& log)>;

    /// From the text of a vertex shader and of one or more fragment shaders that complete each other. The error is that
    /// of `refusal`, or without one the driver's.
    static Result<std::unique_ptr<GlProgram>> make(const GlFunctions& gl, const char* vertexShader,
                                                   std::span<const char* const> fragmentShaders,
                                                   const Refusal& refusal = {});
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    void use() const { gl_.useProgram(name_); }
    /// Uniforms of the program in use.
    void set(const char* uniform, int value) const { gl_.uniform1i(location(uniform), value); }
    void set(const char* uniform, unsigned value) const { gl_.uniform1ui(location(uniform), value); }
    void set(const char* uniform, float value) const { gl_.uniform1f(location(uniform), value); }
    void set(const char* uniform, const Eigen::Vector2f& v) const { gl_.uniform2f(location(uniform), v.x(), v.y()); }
    void set(const char* uniform, const Eigen::Vector3f& v) const
    {
        gl_.uniform3f(location(uniform), v.x(), v.y(), v.z());
    }
    void set(const char* uniform, const Eigen::Vector4f& v) const
    {
        gl_.uniform4f(location(uniform), v.x(), v.y(), v.z(), v.w());
    }
    void set(const char* uniform, std::span<const Eigen::Vector4f> array) const
    {
        if (!array.empty())
            gl_.uniform4fv(location(uniform), static_cast<int>(array.size()), array.front().data());
    }
    void set(const char* uniform, const Eigen::Matrix3f& matrix) const
    {
        gl_.uniformMatrix3fv(location(uniform), 1, 0, matrix.data());
    }
    void set(const char* uniform, const Eigen::Matrix4f& matrix) const
    {
        gl_.uniformMatrix4fv(location(uniform), 1, 0, matrix.data());
    }
    /// Lets the sampler `uniform` read `texture` through the texture unit `unit`, below textureUnits.
    void setTexture(const char* uniform, int unit, unsigned texture, unsigned target = gl::texture2D) const;

private:
    static Result<std::unique_ptr<GlProgram>> linked(std::unique_ptr<GlProgram> program, const Refusal& refusal);
    GlProgram(const GlFunctions& gl, unsigned name) : gl_(gl), name_(name) {}
    int location(const char* uniform) const { return gl_.getUniformLocation(name_, uniform); }

    const GlFunctions& gl_;
    unsigned name_;
};

/// Errors that somebody else left would be taken for ours.
void forgetErrors(const GlFunctions& gl);

/// What drawing starts from, whatever somebody else left: depth test on, blending and everything else off.
void setDrawingState(const GlFunctions& gl);
/// Blending with what is in front, without depth test; and back.
void startBlendingUnder(const GlFunctions& gl);
void endBlending(const GlFunctions& gl);
/// Binds no program, no vertex array and no texture; no depth test.
void leaveDrawingState(const GlFunctions& gl);

Status checkClipPlanes(std::span<const ClipPlane> planes);
/// Of focus volumes, and of surfaces with a share.
Status checkRegions(const Scene& scene);

/// Sets the uniforms of cut.frag in the program in use, for places relative to `origin`.
void setCuts(const GlProgram& program, std::span<const ClipPlane> planes, const Eigen::Vector3d& origin);

/// Sets the uniforms of lights.frag in the program in use.
void setLights(const GlProgram& program);

/// The programs of ScenePainter; their texts are in resources/shaders.
struct PainterPrograms {
    std::unique_ptr<GlProgram> opaque;
    std::unique_ptr<GlProgram> peel;
    std::unique_ptr<GlProgram> line;
    std::unique_ptr<GlProgram> under;
    std::unique_ptr<GlProgram> resolve;
    std::unique_ptr<GlProgram> volume;
    std::unique_ptr<GlProgram> saturated;
    std::unique_ptr<GlProgram> bisect;
    std::unique_ptr<GlProgram> limit;
};

/// The program that draws a volume by an optical model with this text (OpticalModel::shader). The error names the
/// `maker` (Scene::maker), whose mistake it is, and has the compiler's message about the text.
Result<std::unique_ptr<GlProgram>> makeModelProgram(const GlFunctions& gl, const std::string& shader,
                                                    const std::string& maker);

/// The program that gives rays their light by an optical model with this text (OpticalModel::rayShader). Errors as
/// those of makeModelProgram().
Result<std::unique_ptr<GlProgram>> makeRayProgram(const GlFunctions& gl, const std::string& shader,
                                                  const std::string& maker);

Result<PainterPrograms> makePainterPrograms(const GlFunctions& gl);

} // namespace tetra
