// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/slice_names.h"

#include <tan/base.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

struct NumberedName {
    std::string before;
    std::string digits; ///< without leading zeros
    std::string after;
};

NumberedName split(const std::string& name)
{
    constexpr std::string_view numerals = "0123456789";
    const auto dot = name.rfind('.');
    const std::string stem = name.substr(0, dot);
    const auto last = stem.find_last_of(numerals);
    if (last == std::string::npos)
        return {name, "", ""};
    const auto beforeFirst = stem.find_last_not_of(numerals, last);
    const auto first = beforeFirst == std::string::npos ? 0 : beforeFirst + 1;
    std::string digits = stem.substr(first, last + 1 - first);
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    return {stem.substr(0, first), std::move(digits), name.substr(last + 1)};
}

} // namespace

std::vector<fs::path> numberedBeside(const fs::path& path)
{
    const NumberedName own = split(path.filename().string());
    std::vector<std::pair<std::string, fs::path>> found;
    std::error_code problem;
    for (fs::path& beside : pathsIn(path.parent_path(), problem)) {
        NumberedName other = split(beside.filename().string());
        if (!own.digits.empty() && !other.digits.empty() && other.before == own.before && other.after == own.after)
            found.emplace_back(std::move(other.digits), std::move(beside));
    }
    if (found.empty())
        return {path};
    std::ranges::sort(found, [](const auto& a, const auto& b) {
        return a.first.size() != b.first.size() ? a.first.size() < b.first.size() : a < b;
    });
    std::vector<fs::path> slices;
    for (auto& entry : found)
        slices.push_back(std::move(entry.second));
    return slices;
}

} // namespace tetra
