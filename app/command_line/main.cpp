// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.h"
#include "app/command_line/interruption.h"
#include "app/command_line/window.h"
#include "core/base/file_writer.h"
#include "plugins/host/plugin_folders.h"

#include <exception>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace {

/// A program may be started without its standard streams (2>&-). The first files that it opens would take their
/// places, and what it tells would be written into them.
void occupyStandardDescriptors()
{
    for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0) // open() takes the smallest that is free; it is of no use to anyone
            (void)open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int run(int argc, char** argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    tetra::ignoreRelativeFolders();
    if (tetra::isForWindow(words)) {
        std::cerr << "tan: " << tetra::startWindow(argv).text() << std::endl;
        return 4;
    }
    const tetra::Interruption interruption;
    const auto host = tetra::PluginHost::standard();
    return tetra::runCommandLine(words, *host, {std::cout, std::cerr, isatty(STDERR_FILENO) != 0},
                                 interruption.token());
}

} // namespace

int main(int argc, char** argv)
{
    occupyStandardDescriptors();
    tetra::reportFailedWrites();
    try {
        return run(argc, argv);
    } catch (const std::exception& problem) {
        // What is left when not even a thread can be started or a few bytes be had, as under a low ulimit.
        std::cerr << "tan: The system refuses what every program needs (" << problem.what()
                  << "). Close other programs, or raise the limits (ulimit).\n";
        return 4;
    }
}
