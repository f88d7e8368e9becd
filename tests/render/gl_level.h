// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/compute_functions.h"
#include "core/graphics/gl/egl_context.h"
#include "core/graphics/render_backend.h"

#include <QObject>
#include <QTest>
#include <QtGlobal>

#include <memory>
#include <string>

namespace tetra::testing {

/// The level that a test is to draw with at most, which runs once for each: TAN_GL_LEVEL of the environment, 33 or 43.
inline GlLevel levelOfTest()
{
    return qEnvironmentVariable("TAN_GL_LEVEL") == "33" ? GlLevel::Gl33 : GlLevel::Gl43;
}

/// Why this machine has no OpenGL of this level, asked of the driver alone; empty if it has.
inline std::string whyNoGl(GlLevel level)
{
    const auto context = EglContext::make();
    if (!context)
        return "skipped: " + context.error().text;
    if (level == GlLevel::Gl33)
        return {};
    const EglContext::Current current(**context);
    const GlFunctions gl((*context)->getProcAddress());
    const Status status = checkCompute(gl, ComputeFunctions((*context)->getProcAddress()));
    return status ? std::string() : "skipped: " + status.error().text;
}

/// OpenGL by this level at most, where whyNoGl() is empty: there a back end that cannot be made has failed, and its
/// test is not to be skipped.
inline std::unique_ptr<RenderBackend> glBackendOf(GlLevel level)
{
    auto backend = makeGlBackend(level);
    if (!backend)
        qFatal("%s", backend.error().text.c_str());
    return std::move(*backend);
}

/// A test of OpenGL's back end, by some level at most, against the CPU's.
class GlTest : public QObject {
protected:
    /// For initTestCase(), which it must end: skips the whole test where this machine has no such OpenGL.
    void makeGl(GlLevel level)
    {
        if (const std::string reason = whyNoGl(level); !reason.empty())
            QSKIP(reason.c_str());
        gl_ = glBackendOf(level);
    }

    std::unique_ptr<RenderBackend> cpu_ = makeCpuBackend();
    std::unique_ptr<RenderBackend> gl_;
};

} // namespace tetra::testing
