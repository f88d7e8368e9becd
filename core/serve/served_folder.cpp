// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/served_folder.h"

#include "core/base/system_error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <system_error>

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace tetra {
namespace {

std::shared_ptr<const int> owned(int descriptor)
{
    return {new int(descriptor), [](const int* held) {
                ::close(*held);
                delete held;
            }};
}

/// Opens what lies beneath a folder; links that lead out of it are refused by the system. Systems that are too old or
/// too locked up for that refuse all links.
int openBeneath(int folder, const std::string& name)
{
    open_how how{};
    how.flags = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
    const long opened = ::syscall(SYS_openat2, folder, name.c_str(), &how, sizeof how);
    if (opened >= 0 || (errno != ENOSYS && errno != EPERM))
        return static_cast<int>(opened);
    int place = ::dup(folder);
    std::string_view rest = name;
    while (place >= 0) {
        const std::size_t slash = rest.find('/');
        const bool last = slash == std::string_view::npos;
        const std::string part(rest.substr(0, slash));
        const int next = ::openat(place, part.c_str(),
                                  O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | O_NOFOLLOW | (last ? 0 : O_DIRECTORY));
        ::close(place);
        place = next;
        if (last)
            break;
        rest.remove_prefix(slash + 1);
    }
    return place;
}

/// Whether every part of the name is one that may be named.
bool mayBeNamed(std::string_view name)
{
    constexpr std::size_t longest = 1024;
    if (name.empty() || name.size() > longest || !name.ends_with(".tan"))
        return false;
    for (const char c : name)
        if ((c >= 0 && c < ' ') || c == 0x7f || c == '\\')
            return false;
    while (true) {
        const std::size_t slash = name.find('/');
        const std::string_view part = name.substr(0, slash);
        if (part.empty() || part.starts_with('.'))
            return false;
        if (slash == std::string_view::npos)
            return true;
        name.remove_prefix(slash + 1);
    }
}

std::string hexadecimal(std::uint64_t number)
{
    std::array<char, 16> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16);
    return {digits.data(), end};
}

/// Of both times: that of the last modification can be set to any, the other one is the system's.
std::string tagOf(const struct stat& state)
{
    const auto nanoseconds = [](const timespec& time) {
        constexpr std::int64_t aSecond = 1'000'000'000;
        return static_cast<std::uint64_t>(time.tv_sec * aSecond + time.tv_nsec);
    };
    std::string tag;
    for (const std::uint64_t part :
         {std::uint64_t(state.st_dev), std::uint64_t(state.st_ino), std::uint64_t(state.st_size),
          nanoseconds(state.st_mtim), nanoseconds(state.st_ctim)})
        tag += (tag.empty() ? "" : "-") + hexadecimal(part);
    return "\"" + tag + "\"";
}

Error cannotLook(int error)
{
    return {ErrorKind::OutOfResource,
            Message::say("The server cannot read its models now: %1. Ask again.", systemErrorText(error))};
}

} // namespace

bool ServedFile::read(std::uint64_t offset, std::span<char> to) const
{
    while (!to.empty()) {
        const ssize_t count = ::pread(*descriptor, to.data(), to.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        offset += static_cast<std::uint64_t>(count);
        to = to.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

std::optional<std::filesystem::path> ServedFile::path() const
{
    std::error_code problem;
    const auto path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(*descriptor), problem);
    struct stat there {
    }, here{};
    if (problem || ::stat(path.c_str(), &there) != 0 || ::fstat(*descriptor, &here) != 0 || tagOf(there) != tag ||
        tagOf(here) != tag)
        return {};
    return path;
}

Result<ServedFolder> ServedFolder::open(const std::filesystem::path& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return Error{ErrorKind::BadInput, Message::say("The folder '%1' cannot be served: %2. Check its name.",
                                                       folder.native(), systemErrorText(errno))};
    ServedFolder served;
    served.path_ = folder;
    served.descriptor_ = owned(descriptor);
    return served;
}

Result<std::optional<ServedFile>> ServedFolder::find(std::string_view name) const
{
    if (!mayBeNamed(name))
        return std::optional<ServedFile>();
    const int descriptor = openBeneath(*descriptor_, std::string(name));
    if (descriptor < 0) {
        if (const int error = errno; isLackOfResources(error))
            return cannotLook(error);
        return std::optional<ServedFile>();
    }
    ServedFile file;
    file.descriptor = owned(descriptor);
    struct stat state {};
    if (::fstat(descriptor, &state) != 0 || !S_ISREG(state.st_mode))
        return std::optional<ServedFile>();
    file.name = name;
    file.size = static_cast<std::uint64_t>(state.st_size);
    file.changed = state.st_mtim.tv_sec;
    file.tag = tagOf(state);
    return std::optional(std::move(file));
}

Result<std::vector<std::string>> ServedFolder::names(std::size_t most) const
{
    namespace fs = std::filesystem;
    std::vector<std::string> found;
    std::vector<std::string> folders = {""}; // still to be looked into: names that end with '/', and the folder itself
    while (!folders.empty() && found.size() < most) {
        const std::string folder = std::move(folders.back());
        folders.pop_back();
        std::error_code problem, gone;
        for (const fs::path& path : pathsIn(path_ / folder, problem)) {
            const std::string name = path.filename().native();
            if (name.starts_with('.'))
                continue;
            if (fs::symlink_status(path, gone).type() == fs::file_type::directory)
                folders.push_back(folder + name + '/');
            else if (mayBeNamed(folder + name) && found.size() < most)
                found.push_back(folder + name);
        }
        // Another folder within may have gone meanwhile, or be for others.
        if (problem && (folder.empty() || isLackOfResources(problem.value())))
            return cannotLook(problem.value());
    }
    std::ranges::sort(found);
    return found;
}

} // namespace tetra
