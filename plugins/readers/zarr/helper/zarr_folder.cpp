// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_folder.h"

#include "plugins/readers/zarr/helper/zarr_json.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

bool isMissing(const std::error_code& problem)
{
    return problem == std::errc::no_such_file_or_directory || problem == std::errc::not_a_directory;
}

Error notReadable(const std::string& name, const std::error_code& problem)
{
    return {ErrorKind::BadInput, Message::say("its '%1' cannot be read (%2). Check its permissions.", printable(name),
                                              systemErrorText(problem.value()))};
}

/// Whether the name is a path that goes down only.
bool goesDown(std::string_view name)
{
    if (name.find('\0') != std::string_view::npos)
        return false;
    for (std::string_view rest = name; !name.empty();) {
        const auto end = rest.find('/');
        const std::string_view part = rest.substr(0, end);
        if (part.empty() || part == "." || part == "..")
            return false;
        if (end == std::string_view::npos)
            break;
        rest.remove_prefix(end + 1);
    }
    return true;
}

/// Whether a part of the name is a link to something that is not there.
bool hasLooseLink(const fs::path& root, const std::string& name)
{
    fs::path place = root;
    std::error_code ignored;
    for (const fs::path& part : fs::path(name)) {
        place /= part;
        if (fs::is_symlink(place, ignored) && !fs::exists(place, ignored))
            return true;
    }
    return false;
}

} // namespace

std::string zarrPath(const std::string& folder, const std::string& name)
{
    return folder.empty() || name.empty() ? folder + name : folder + '/' + name;
}

Result<ZarrFolder> ZarrFolder::open(const fs::path& path)
{
    ZarrFolder folder;
    std::error_code problem;
    folder.root_ = fs::canonical(path, problem);
    if (problem)
        return Error{ErrorKind::BadInput, Message::say("it cannot be read (%1). Check the name and the permissions.",
                                                       systemErrorText(problem.value()))};
    return folder;
}

/// Where a name leads, without links: empty if nothing is there.
Result<fs::path> ZarrFolder::placeOf(const std::string& name) const
{
    if (!goesDown(name))
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "it refers to '%1', which is not a path inside the folder. Only what is in the folder is read.",
                printable(name))};
    std::error_code problem;
    const fs::path place = fs::canonical(root_ / name, problem);
    if (problem && isMissing(problem)) {
        if (!hasLooseLink(root_, name))
            return fs::path();
        return Error{ErrorKind::BadInput, Message::say("its '%1' is a link to something that does not exist. Copy the "
                                                       "folder together with the targets of its links.",
                                                       printable(name))};
    }
    if (problem)
        return notReadable(name, problem);
    if (const auto [end, ignored] = std::ranges::mismatch(root_, place); end != root_.end())
        return Error{ErrorKind::BadInput, Message::say("its '%1' is a link that leads out of the folder. Only what is "
                                                       "in the folder is read: put a copy in its place.",
                                                       printable(name))};
    return place;
}

Result<std::optional<std::uint64_t>> ZarrFolder::fileSize(const std::string& name) const
{
    const auto place = placeOf(name);
    if (!place)
        return place.error();
    if (place->empty())
        return std::optional<std::uint64_t>();
    std::error_code problem;
    if (!fs::is_regular_file(*place, problem))
        return Error{ErrorKind::BadInput,
                     Message::say("its '%1' is not a file. Copy or export it again.", printable(name))};
    const std::uint64_t size = fs::file_size(*place, problem);
    return problem ? Result<std::optional<std::uint64_t>>(notReadable(name, problem)) : std::optional(size);
}

Result<std::shared_ptr<const MappedFile>> ZarrFolder::file(const std::string& name) const
{
    const auto place = placeOf(name);
    if (!place)
        return place.error();
    return place->empty() ? Result<std::shared_ptr<const MappedFile>>(nullptr) : MappedFile::open(*place);
}

Result<std::optional<QJsonObject>> ZarrFolder::json(const std::string& name) const
{
    constexpr std::uint64_t most = std::uint64_t(1) << 26U;
    const auto size = fileSize(name);
    if (!size)
        return size.error();
    if (!*size)
        return std::optional<QJsonObject>();
    if (**size > most)
        return Error{ErrorKind::BadInput,
                     Message::say("its '%1' is larger than metadata are (%2). It is damaged, or not Zarr.",
                                  printable(name), neededBytesText(**size))};
    const auto text = file(name);
    if (!text)
        return text.error();
    auto object = *text ? parseJsonObject((*text)->bytes()) : Result<QJsonObject>(QJsonObject());
    if (!object)
        return Error{object.error().kind, Message::say("its '%1' %2", printable(name), object.error().message)};
    return std::optional(*std::move(object));
}

std::vector<std::string> ZarrFolder::folders(const std::string& name) const
{
    std::vector<std::string> names;
    const auto place = placeOf(name);
    if (!place || place->empty())
        return names;
    std::error_code ignored;
    for (const fs::path& path : pathsIn(*place, ignored))
        if (fs::is_directory(fs::symlink_status(path, ignored)))
            names.push_back(path.filename().string());
    std::ranges::sort(names);
    return names;
}

} // namespace tetra
