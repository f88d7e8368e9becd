// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/viewport/canvas.h"

namespace tetra {

/// Which back end the viewport draws with. Automatic takes OpenGL where a graphics card does the work; OpenGL that is
/// computed by the processor would only be slower than our own CPU back end, and hold up the window meanwhile. Gl takes
/// it there, too. Where there is none at all, all take the CPU.
enum class BackendChoice { Automatic, Cpu, Gl };

/// A canvas, a widget that the caller gives a parent.
Canvas* makeCanvas(BackendChoice choice);

} // namespace tetra
