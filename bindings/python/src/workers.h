// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace tetra::python {

/// Runs `work` on another thread, which waits for more afterwards and is used again: TBB keeps some 10 kB for every
/// thread that ever worked in parallel, for as long as the program runs. `work` must not throw. Returns at once; called
/// with the GIL held. Threads that wait do not keep the program from ending, and a child of fork() has threads of its
/// own. May throw std::system_error where no thread can be started.
void runOnWorker(std::function<void()> work);

} // namespace tetra::python
