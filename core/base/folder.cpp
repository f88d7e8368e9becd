// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder.h"

#include <cerrno>
#include <memory>
#include <string_view>

#include <dirent.h>

namespace tetra {

std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem)
{
    problem.clear();
    std::vector<std::filesystem::path> found;
    const auto close = [](DIR* opened) { ::closedir(opened); };
    const std::unique_ptr<DIR, decltype(close)> opened(::opendir(folder.empty() ? "." : folder.c_str()), close);
    errno = opened ? 0 : errno;
    while (opened) {
        const dirent* const entry = ::readdir(opened.get());
        if (entry == nullptr)
            break;
        const std::string_view name = entry->d_name;
        if (name != "." && name != "..")
            found.push_back(folder / name);
        errno = 0; // where there are no more, it stays so
    }
    problem.assign(errno, std::generic_category());
    return found;
}

} // namespace tetra
