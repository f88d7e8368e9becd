// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/make_canvas.h"

#include "ui/viewport/cpu_canvas.h"
#include "ui/viewport/gl_canvas.h"

namespace tetra {

Canvas* makeCanvas(BackendChoice choice)
{
    const GlSupport support = choice == BackendChoice::Cpu ? GlSupport::None : glSupport();
    const bool wanted = choice == BackendChoice::Gl || choice == BackendChoice::Gl33;
    if (support == GlSupport::Hardware || (support == GlSupport::Software && wanted))
        return new GlCanvas(choice == BackendChoice::Gl33 ? GlLevel::Gl33 : GlLevel::Gl43);
    return new CpuCanvas;
}

} // namespace tetra
