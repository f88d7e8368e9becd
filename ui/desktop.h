// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

/// The desktop program: shows the window, with the file that the command line names, until the user closes it. Returns
/// the exit code; 2 for a wrong command line.
int runDesktop(int argc, char** argv);

} // namespace tetra
