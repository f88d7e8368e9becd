// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/zarr_root.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> metadataNames = {"zarr.json", ".zarray", ".zattrs", ".zgroup"};

} // namespace

bool isZarrMetadataName(const fs::path& path)
{
    return std::ranges::find(metadataNames, path.filename().string()) != metadataNames.end();
}

bool isZarrFolder(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_directory(path, ignored) && std::ranges::any_of(metadataNames, [&](std::string_view name) {
               return fs::is_regular_file(path / name, ignored);
           });
}

fs::path zarrRootOf(const fs::path& path)
{
    std::error_code problem;
    fs::path whole = fs::absolute(path, problem).lexically_normal();
    if (whole.filename().empty())
        whole = whole.parent_path();
    if (isZarrFolder(whole))
        return whole;
    return isZarrMetadataName(whole) ? whole.parent_path() : fs::path();
}

} // namespace tetra
