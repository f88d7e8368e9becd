// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/window.h"

#include "core/base/system_error.h"

#include <cerrno>
#include <filesystem>

#include <unistd.h>

namespace tetra {

Error startWindow(char** argumentsOfProgram)
{
    std::error_code problem;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", problem);
    if (problem || !program.is_absolute()) // then "tan-desktop" would be whatever lies in the current folder
        return {ErrorKind::OutOfResource, "The window program cannot be started: the system does not say where this "
                                          "program lies (/proc is not mounted). Start 'tan-desktop' itself."};
    const auto desktop = program.parent_path() / "tan-desktop";
    execv(desktop.c_str(), argumentsOfProgram);
    return {ErrorKind::OutOfResource, "The window program '" + desktop.string() +
                                          "' cannot be started: " + systemErrorText(errno).text() +
                                          ". Install it (package tan-desktop), or see 'tan --help' "
                                          "for what works without it."};
}

} // namespace tetra
