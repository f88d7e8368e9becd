// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/opening_folder.h"

#include <random>
#include <string>
#include <utility>

namespace tetra {

namespace {

constexpr std::string_view ownStart = "tan-opening-";

Result<std::uint64_t> limitOf(const OpenOptions& options)
{
    if (options.cacheFolder.empty())
        return CacheFolder::standardLimit();
    return options.cacheBytes > 0 ? options.cacheBytes : CacheFolder::defaultLimit;
}

} // namespace

Result<OpeningFolder> openingFolder(const OpenOptions& options)
{
    const Result<std::uint64_t> limit = limitOf(options);
    if (!limit)
        return limit.error();
    auto cache = options.cacheFolder.empty() ? CacheFolder::standard() : CacheFolder::open(options.cacheFolder, *limit);
    if (cache)
        return OpeningFolder{*std::move(cache), {}};
    if (cache.error().kind == ErrorKind::CannotWrite)
        if (auto own = folderOfItsOwn(options))
            return own;
    return cache.error();
}

Result<OpeningFolder> folderOfItsOwn(const OpenOptions& options)
{
    const Result<std::uint64_t> limit = limitOf(options);
    if (!limit)
        return limit.error();
    std::error_code problem;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(problem);
    if (problem)
        return Error{ErrorKind::CannotWrite,
                     Message::say("There is no folder for temporary files: %1.", systemErrorText(problem.value()))};
    WorkFolder::removeLeft(parent, ownStart);
    std::random_device random;
    std::string name(ownStart);
    name += std::to_string(random()) + '-' + std::to_string(random());
    auto made = WorkFolder::open(parent / name, WorkFolder::Leftovers::Remove);
    if (!made)
        return made.error();
    const auto own = std::make_shared<const WorkFolder>(*std::move(made));
    auto folder = CacheFolder::open(own->path() / "cache", *limit); // for this user alone
    if (!folder)
        return folder.error();
    return OpeningFolder{*std::move(folder), own};
}

} // namespace tetra
