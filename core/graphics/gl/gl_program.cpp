// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/gl_program.h"

#include <string>

namespace tetra {
namespace {

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
    return {ErrorKind::OutOfResource,
            "This machine's OpenGL driver refuses a shader of TAn. Use the CPU back end, or another driver. It says: " +
                log};
}

Status attach(const GlFunctions& gl, unsigned program, unsigned kind, const char* source)
{
    const unsigned shader = gl.createShader(kind);
    gl.shaderSource(shader, 1, &source, nullptr);
    gl.compileShader(shader);
    int compiled = 0;
    gl.getShaderiv(shader, gl::compileStatus, &compiled);
    Status status;
    if (compiled == 0)
        status = driverError(logOf(shader, gl.getShaderiv, gl.getShaderInfoLog));
    gl.attachShader(program, shader);
    gl.deleteShader(shader); // lives on as long as the program
    return status;
}

} // namespace

Result<std::unique_ptr<GlProgram>> GlProgram::make(const GlFunctions& gl, const char* vertexShader,
                                                   std::span<const char* const> fragmentShaders)
{
    std::unique_ptr<GlProgram> program(new GlProgram(gl, gl.createProgram()));
    Status status = attach(gl, program->name_, gl::vertexShader, vertexShader);
    for (const char* shader : fragmentShaders)
        if (status)
            status = attach(gl, program->name_, gl::fragmentShader, shader);
    if (!status)
        return status.error();
    return linked(std::move(program));
}

Result<std::unique_ptr<GlProgram>> GlProgram::linked(std::unique_ptr<GlProgram> program)
{
    const GlFunctions& gl = program->gl_;
    gl.linkProgram(program->name_);
    int linked = 0;
    gl.getProgramiv(program->name_, gl::linkStatus, &linked);
    if (linked == 0)
        return driverError(logOf(program->name_, gl.getProgramiv, gl.getProgramInfoLog));
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

} // namespace tetra
