// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.h"
#include "app/command_line/interruption.h"
#include "app/command_line/window.h"

#include <QGuiApplication>
#include <QLocale>

#include <clocale>
#include <exception>
#include <iostream>
#include <memory>

#include <unistd.h>

namespace {

/// Starts the part of Qt that these words need: fonts take a tenth of a second.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv, const std::vector<std::string>& words)
{
    if (!tetra::needsFonts(words))
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QLocale::setDefault(QLocale::c()); // what is drawn is as what is printed
    return std::make_unique<QGuiApplication>(argc, argv);
}

int run(int argc, char** argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (tetra::isForWindow(words)) {
        std::cerr << "tan: " << tetra::startWindow(argv).text << std::endl;
        return 4;
    }
    const tetra::Interruption interruption;
    const auto application = makeApplication(argc, argv, words);
    // Qt takes over the user's locale; numbers keep their decimal point and what the system says of errors stays
    // English.
    std::setlocale(LC_NUMERIC, "C");
    std::setlocale(LC_MESSAGES, "C");
    const auto host = tetra::PluginHost::standard();
    return tetra::runCommandLine(words, *host, {std::cout, std::cerr, isatty(STDERR_FILENO) != 0},
                                 interruption.token());
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const std::exception& problem) {
        // What is left when not even a thread can be started or a few bytes be had, as under a low ulimit.
        std::cerr << "tan: The system refuses what every program needs (" << problem.what()
                  << "). Close other programs, or raise the limits (ulimit).\n";
        return 4;
    }
}
