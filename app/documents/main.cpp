// SPDX-License-Identifier: GPL-3.0-or-later
/// tan-write-documents FOLDER: writes the manual page of `tan` and its completions for the shells.
#include "app/documents/completions.h"
#include "app/documents/manual_page.h"
#include "core/base/file_writer.h"

#include <filesystem>
#include <iostream>
#include <span>

int main(int argc, char** argv)
{
    tetra::reportFailedWrites();
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
    for (const auto& [name, text] : files)
        if (const auto written = tetra::writeWholeFile(folder / name, std::as_bytes(std::span(text))); !written) {
            std::cerr << "tan-write-documents: " << written.error().text() << '\n';
            return 4;
        }
    return 0;
}
