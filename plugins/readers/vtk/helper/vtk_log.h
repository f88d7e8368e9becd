// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <string>
#include <vector>

namespace tetra {

/// What VTK says while it reads, instead of printing it.
struct VtkLog {
    std::vector<std::string> errors;
    std::vector<std::string> warnings;
};

/// From now on all errors and warnings of VTK go to `log`, which must live to the end of the process; what its
/// libraries write to std::cerr goes nowhere.
void sendVtkMessagesTo(VtkLog& log);

/// Success if there were no errors; else an Error with the first of them that says something, or that memory ran out.
Status statusOf(const VtkLog& log);

/// What is said of a file that VTK did not read; `said` is VTK's sentence.
Error vtkError(const Message& said);

} // namespace tetra
