// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/model_cache.h"

#include "core/base/memory.h"
#include "core/opening/served_model.h"
#include "core/remote/cache_folder.h"
#include "ui/session/files.h"

#include <QSettings>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr const char* folderKey = "cache/folder";
constexpr const char* gigabytesKey = "cache/gigabytes";
constexpr double gigabyte = 1e9;

Result<CacheFolder> chosenFolder()
{
    const OpenOptions options = cacheOptions();
    return options.cacheFolder.empty() ? CacheFolder::standard()
                                       : CacheFolder::open(options.cacheFolder, options.cacheBytes);
}

} // namespace

CacheChoice cacheChoice()
{
    const QSettings settings;
    return {filePath(settings.value(folderKey).toString()), std::max(0, settings.value(gigabytesKey).toInt())};
}

void setCacheChoice(const CacheChoice& choice)
{
    QSettings settings;
    settings.setValue(folderKey, pathText(choice.folder));
    settings.setValue(gigabytesKey, choice.gigabytes);
}

CacheChoice usualCache()
{
    const auto usual = CacheFolder::standard();
    const std::uint64_t limit = usual ? usual->limit() : CacheFolder::defaultLimit;
    return {usual ? usual->path() : std::filesystem::path(),
            std::max(1, static_cast<int>(std::lround(static_cast<double>(limit) / gigabyte)))};
}

bool fitsHere(const ServerOffer& offer)
{
    constexpr std::uint64_t bytesPerSite = 600; // of the mesh while a packed lattice is built again
    const auto folder = chosenFolder();
    const std::uint64_t room = folder ? folder->limit() : CacheFolder::defaultLimit;
    const std::uint64_t needed = offer.form == ModelForm::Packed ? bytesPerSite * offer.sites : 0;
    const std::uint64_t memory = usableBytes();
    return offer.unpackedBytes <= room && (memory == 0 || needed <= memory);
}

OpenOptions cacheOptions()
{
    const CacheChoice choice = cacheChoice();
    if (choice.folder.empty() && choice.gigabytes == 0)
        return {};
    const CacheChoice usual = usualCache();
    OpenOptions options;
    options.cacheFolder = choice.folder.empty() ? usual.folder : choice.folder;
    options.cacheBytes =
        static_cast<std::uint64_t>(gigabyte * (choice.gigabytes > 0 ? choice.gigabytes : usual.gigabytes));
    return options;
}

Result<std::uint64_t> cachedBytes()
{
    const auto folder = chosenFolder();
    return folder ? Result<std::uint64_t>(folder->bytes()) : folder.error();
}

Status clearCache()
{
    const auto folder = chosenFolder();
    if (folder)
        folder->clear();
    return folder ? Status() : folder.error();
}

} // namespace tetra
