// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

namespace tetra {

/// Becomes the desktop program, tan-desktop, which lies beside this one, with the same arguments. Returns only if that
/// fails.
Error startWindow(char** argumentsOfProgram);

} // namespace tetra
