// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/slice_names.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view numerals = "0123456789";

/// A name taken apart: texts between numbers, one more than these.
struct NumberedName {
    std::vector<std::string> texts{};
    std::vector<std::uint64_t> numbers{};
};

std::string lowered(std::string_view text)
{
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

/// Numbers of the ending (".mp4") are none; nor are those that have too many digits.
NumberedName split(const std::string& name)
{
    const std::size_t stem = std::min(name.rfind('.'), name.size());
    NumberedName parts;
    std::string text;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t end = std::min(name.find_first_not_of(numerals, at), name.size());
        const auto number = at < stem && end > at
                                ? parseNumber<std::uint64_t>(std::string_view(name).substr(at, end - at))
                                : std::nullopt;
        if (number) {
            parts.texts.push_back(std::move(text));
            parts.numbers.push_back(*number);
            text.clear();
            at = end;
        } else {
            text += name[at++];
        }
    }
    parts.texts.push_back(std::move(text));
    return parts;
}

enum class NumberKind { Slice, Channel, Time, Unknown };

/// The letters right before a number.
std::string wordBefore(const std::string& text)
{
    const std::string lower = lowered(text);
    std::size_t begin = lower.size();
    while (begin > 0 && lower[begin - 1] >= 'a' && lower[begin - 1] <= 'z')
        --begin;
    return lower.substr(begin);
}

NumberKind kindOf(const std::string& text)
{
    const std::string word = wordBefore(text);
    const auto isOneOf = [&](const auto& words) { return std::ranges::find(words, word) != words.end(); };
    constexpr std::array<std::string_view, 6> slice = {"z", "sl", "slice", "plane", "section", "zpos"};
    constexpr std::array<std::string_view, 4> channel = {"c", "ch", "chan", "channel"};
    constexpr std::array<std::string_view, 4> time = {"t", "time", "tp", "timepoint"};
    return isOneOf(slice)     ? NumberKind::Slice
           : isOneOf(channel) ? NumberKind::Channel
           : isOneOf(time)    ? NumberKind::Time
                              : NumberKind::Unknown;
}

struct NamedFile {
    fs::path path;
    std::vector<std::uint64_t> numbers;
};

/// All that have the texts of `path`, itself among them.
std::vector<NamedFile> alikeBeside(const fs::path& path, const NumberedName& own)
{
    std::vector<NamedFile> alike;
    std::error_code problem;
    for (fs::path& beside : pathsIn(path.parent_path(), problem)) {
        NumberedName other = split(beside.filename().string());
        std::error_code ignored;
        if (other.texts == own.texts && fs::is_regular_file(beside, ignored))
            alike.push_back({std::move(beside), std::move(other.numbers)});
    }
    return alike;
}

bool differOnlyIn(std::size_t place, const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b)
{
    for (std::size_t at = 0; at < a.size(); ++at)
        if (at != place && a[at] != b[at])
            return false;
    return true;
}

std::vector<NamedFile> stackAlong(std::size_t place, const std::vector<NamedFile>& alike,
                                  const std::vector<std::uint64_t>& own)
{
    std::vector<NamedFile> stack;
    std::ranges::copy_if(alike, std::back_inserter(stack),
                         [&](const NamedFile& file) { return differOnlyIn(place, file.numbers, own); });
    std::ranges::sort(stack, [&](const NamedFile& a, const NamedFile& b) {
        return std::tie(a.numbers[place], a.path) < std::tie(b.numbers[place], b.path);
    });
    const auto twice = std::ranges::unique(stack, {}, [&](const NamedFile& file) { return file.numbers[place]; });
    stack.erase(twice.begin(), twice.end()); // "a1.tif" and "a01.tif"
    return stack;
}

/// Which number counts slices; nothing if none differs. One behind "c" or "t" only where there is no other.
std::optional<std::size_t> slicePlace(const NumberedName& own, const std::vector<NamedFile>& alike)
{
    for (const auto& kinds : {std::vector{NumberKind::Slice}, std::vector{NumberKind::Unknown},
                              std::vector{NumberKind::Time, NumberKind::Channel}})
        for (std::size_t place = own.numbers.size(); place-- > 0;)
            if (std::ranges::find(kinds, kindOf(own.texts[place])) != kinds.end() &&
                stackAlong(place, alike, own.numbers).size() > 1)
                return place;
    return std::nullopt;
}

/// The numbers of a kind that occur, and which of them is meant: `wanted`, which is put into `own`, or the one there.
std::vector<std::string> namesAlong(NumberKind kind, std::size_t slices, const NumberedName& names,
                                    const std::vector<NamedFile>& alike, std::vector<std::uint64_t>& own,
                                    std::optional<std::size_t> wanted, std::size_t& chosen)
{
    for (std::size_t place = 0; place < own.size(); ++place) {
        if (place == slices || kindOf(names.texts[place]) != kind)
            continue;
        std::vector<std::uint64_t> numbers;
        for (const NamedFile& file : alike)
            numbers.push_back(file.numbers[place]);
        std::ranges::sort(numbers);
        const auto twice = std::ranges::unique(numbers);
        numbers.erase(twice.begin(), twice.end());
        if (numbers.size() < 2)
            continue;
        chosen = static_cast<std::size_t>(std::ranges::find(numbers, own[place]) - numbers.begin());
        if (wanted && *wanted < numbers.size())
            chosen = *wanted;
        own[place] = numbers[chosen];
        std::vector<std::string> found;
        for (const std::uint64_t number : numbers)
            found.push_back(wordBefore(names.texts[place]) + std::to_string(number));
        return found;
    }
    return {};
}

} // namespace

std::vector<fs::path> numberedBeside(const fs::path& path)
{
    const NumberedName own = split(path.filename().string());
    if (own.numbers.empty())
        return {path};
    std::vector<fs::path> files;
    for (NamedFile& file : stackAlong(own.numbers.size() - 1, alikeBeside(path, own), own.numbers))
        files.push_back(std::move(file.path));
    return files.empty() ? std::vector{path} : files;
}

SliceFiles sliceFiles(const fs::path& path, std::optional<std::size_t> channel, std::optional<std::size_t> time)
{
    const NumberedName own = split(path.filename().string());
    const std::vector<NamedFile> alike = alikeBeside(path, own);
    const auto place = slicePlace(own, alike);
    if (!place)
        return {.files = {path}, .numbers = {0}};
    SliceFiles found;
    std::vector<std::uint64_t> numbers = own.numbers;
    found.channels = namesAlong(NumberKind::Channel, *place, own, alike, numbers, channel, found.channel);
    found.times = namesAlong(NumberKind::Time, *place, own, alike, numbers, time, found.time);
    for (NamedFile& file : stackAlong(*place, alike, numbers)) {
        found.numbers.push_back(file.numbers[*place]);
        found.files.push_back(std::move(file.path));
    }
    return found;
}

} // namespace tetra
