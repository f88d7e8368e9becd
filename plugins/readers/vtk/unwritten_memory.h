// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/vtk/vtk_findings.h"

#include <tan/base.h>

#include <functional>

namespace tetra {

/// Some readers of VTK take memory for as many values as a header names, and leave it as it is where the file has none.
/// Nobody sees that in the values: they look like numbers. So such files are read twice, the memory that is taken
/// filled with another pattern each time: what was never written is not the same then. That takes twice the time, and
/// no more memory.

/// Whether the reader of the format may do that, so that its files are worth a second reading: those that VTK wrote
/// itself for formats of others. Readers of VTK's own formats report what is missing, and their files are the large
/// ones; Tecplot's are read by TAn.
bool mayBeUnwritten(VtkFormat format);

/// What the environment of a process has to say so that small pieces of memory are filled, too: "NAME=value".
inline constexpr const char* unwrittenMemoryEnvironment = "GLIBC_TUNABLES=glibc.malloc.tcache_count=0";

/// Reads twice by `read` and gives the second findings. An error of either reading is the answer; so is a difference.
/// Changes the process's memory for good (mallopt()); where there is no glibc, it finds nothing.
Result<VtkFindings> readTwice(const std::function<Result<VtkFindings>()>& read);

} // namespace tetra
