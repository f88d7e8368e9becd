// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/make_canvas.h"

#include "ui/viewport/cpu_canvas.h"
#include "ui/viewport/gl_canvas.h"

namespace tetra {

Canvas* makeCanvas(BackendChoice choice)
{
    const GlSupport support = choice == BackendChoice::Cpu ? GlSupport::None : glSupport();
    if (support == GlSupport::Hardware || (support == GlSupport::Software && choice == BackendChoice::Gl))
        return new GlCanvas;
    return new CpuCanvas;
}

} // namespace tetra
