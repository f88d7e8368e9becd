// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/compute_functions.h"
#include "core/graphics/gl/egl_context.h"
#include "core/graphics/render_backend.h"

#include <memory>
#include <string>

namespace tetra::testing {

/// Why this machine has no OpenGL 4.3, asked of the driver alone; empty if it has. A back end that does not use what is
/// there has failed, and its test is not to be skipped.
inline std::string whyNoGl43()
{
    const auto context = EglContext::make();
    if (!context)
        return context.error().text;
    const EglContext::Current current(**context);
    const GlFunctions gl((*context)->getProcAddress());
    const Status status = checkCompute(gl, ComputeFunctions((*context)->getProcAddress()));
    return status ? std::string() : status.error().text;
}

/// OpenGL by this level at most; the error says why a test of it is skipped here.
inline Result<std::unique_ptr<RenderBackend>> glBackendOf(GlLevel level)
{
    const std::string missing = level == GlLevel::Gl43 ? whyNoGl43() : std::string();
    auto backend = makeGlBackend(level);
    if (!missing.empty() || !backend)
        return Error{ErrorKind::OutOfResource, "skipped: " + (missing.empty() ? backend.error().text : missing)};
    return backend;
}

} // namespace tetra::testing
