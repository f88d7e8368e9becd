// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.h"
#include "app/command_line/interruption.h"
#include "app/command_line/window.h"

#include <QCoreApplication>

#include <iostream>

#include <unistd.h>

int main(int argc, char** argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (tetra::isForWindow(words)) {
        std::cerr << "tan: " << tetra::startWindow(argv).text << std::endl;
        return 4;
    }
    const tetra::Interruption interruption;
    const QCoreApplication application(argc, argv);
    const auto host = tetra::PluginHost::standard();
    return tetra::runCommandLine(words, *host, {std::cout, std::cerr, isatty(STDERR_FILENO) != 0},
                                 interruption.token());
}
