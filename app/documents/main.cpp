// SPDX-License-Identifier: GPL-3.0-or-later
/// tan-write-documents FOLDER: writes the manual page of `tan` and its completions for the shells.
#include "app/documents/completions.h"
#include "app/documents/manual_page.h"

#include <QCoreApplication>

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    if (argc != 2) {
        std::cerr << "tan-write-documents FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::error_code problem;
    std::filesystem::create_directories(folder, problem);

    // Beside the programs: that is where the plugins are looked for.
    const auto host = tetra::PluginHost::standard();
    const auto subcommands = tetra::documentedSubcommands(*host);
    const std::pair<const char*, std::string> files[] = {{"tan.1", tetra::manualPage(subcommands)},
                                                         {"tan.bash", tetra::bashCompletion(subcommands)},
                                                         {"_tan", tetra::zshCompletion(subcommands)},
                                                         {"tan.fish", tetra::fishCompletion(subcommands)}};
    for (const auto& [name, text] : files) {
        std::ofstream file(folder / name, std::ios::binary);
        file << text << std::flush;
        if (!file) {
            std::cerr << "tan-write-documents: " << folder / name << " cannot be written\n";
            return 4;
        }
    }
    return 0;
}
