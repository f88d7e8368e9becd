// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// Small files of a format that VTK reads, written here, so that every byte of them is known.
struct WrittenFiles {
    std::string what{};                        ///< "EnSight Gold, text"
    std::filesystem::path opened{};            ///< the one that a user opens
    std::vector<std::filesystem::path> data{}; ///< those that hold what is read; `opened` is among them unless it is
                                               ///< text that names the others
    std::size_t points = 0;                    ///< with the values 0, 1, 2 ... in some order; of cells: see `perCell`
    bool perCell = false;                      ///< the values are of cells, so that those of points are means
};

/// One or several of each format that no other library looks through for us, in a folder of its own in `folder`.
std::vector<WrittenFiles> writeFormats(const std::filesystem::path& folder);

/// The bytes of a file.
QByteArray contentOf(const std::filesystem::path& path);
void writeContent(const std::filesystem::path& path, const QByteArray& content);

} // namespace tetra
