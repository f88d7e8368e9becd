// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/compute_functions.h"
#include "core/graphics/gl/egl_context.h"

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

} // namespace tetra::testing
