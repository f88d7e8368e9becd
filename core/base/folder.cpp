// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder.h"

#include <cerrno>
#include <memory>

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

namespace tetra {

namespace {

bool isItselfOrAbove(std::string_view name)
{
    return name == "." || name == "..";
}

/// Of an open folder, which it closes; below zero: of none.
void removeContentOf(int folder, std::string_view kept) noexcept
{
    DIR* const opened = folder < 0 ? nullptr : ::fdopendir(folder);
    if (opened == nullptr) {
        if (folder >= 0)
            ::close(folder);
        return;
    }
    while (const dirent* const entry = ::readdir(opened)) {
        const char* const name = entry->d_name;
        if (isItselfOrAbove(name) || name == kept || ::unlinkat(folder, name, 0) == 0)
            continue;
        removeContentOf(::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), {});
        ::unlinkat(folder, name, AT_REMOVEDIR);
    }
    ::closedir(opened);
}

} // namespace

std::vector<std::filesystem::path> pathsIn(const std::filesystem::path& folder, std::error_code& problem)
{
    std::vector<std::filesystem::path> found;
    const auto close = [](DIR* opened) { ::closedir(opened); };
    const std::unique_ptr<DIR, decltype(close)> opened(::opendir(folder.empty() ? "." : folder.c_str()), close);
    while (opened) {
        errno = 0; // after the last one it stays so
        const dirent* const entry = ::readdir(opened.get());
        if (entry == nullptr)
            break;
        if (!isItselfOrAbove(entry->d_name))
            found.push_back(folder / entry->d_name);
    }
    problem.assign(errno, std::generic_category());
    return found;
}

void removeContent(const std::filesystem::path& folder, std::string_view kept) noexcept
{
    removeContentOf(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), kept);
}

} // namespace tetra
