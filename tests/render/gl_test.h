// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/egl_context.h"
#include "tests/lacks.h"

#include <tan/render.h>

#include <QObject>
#include <QTest>

#include <memory>
#include <string>
#include <vector>

namespace tetra::testing {

/// A test of OpenGL's back end against the CPU's.
class GlTest : public QObject {
protected:
    /// For initTestCase(), which it must end: skips the whole test where the driver has no OpenGL. Where it has, a back
    /// end that cannot be made has failed.
    void makeGl()
    {
        if (const auto context = EglContext::make(); !context) {
            noteLack("OpenGL");
            QSKIP(("skipped: " + context.error().text()).c_str());
        }
        auto backend = makeGlBackend();
        if (!backend)
            qFatal("%s", backend.error().text().c_str());
        gl_ = std::move(*backend);
    }

    /// For tests that have something to say of the CPU's back end alone: without OpenGL there is none of it.
    void makeGlIfThere()
    {
        if (EglContext::make())
            makeGl();
    }
    /// Those that are there.
    std::vector<RenderBackend*> backends() const
    {
        return gl_ ? std::vector<RenderBackend*>{cpu_.get(), gl_.get()} : std::vector<RenderBackend*>{cpu_.get()};
    }

    std::unique_ptr<RenderBackend> cpu_ = makeCpuBackend();
    std::unique_ptr<RenderBackend> gl_;
};

} // namespace tetra::testing
