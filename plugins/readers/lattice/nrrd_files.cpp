// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_files.h"

#include "plugins/readers/lattice/field_text.h"

#include <algorithm>
#include <array>
#include <optional>

namespace tetra {

namespace {

constexpr std::string_view betweenWords = " \t";

Error wrongDataFile(const NrrdFields& fields, const Message& why)
{
    return {ErrorKind::BadInput, Message::say("'data file: %1' in its header %2", printable(fields["data file"]), why)};
}

/// "slice%03d.raw" with its one directive for whole numbers taken apart.
struct Pattern {
    std::string_view before, behind;
    std::size_t width = 0;
    char filler = ' ';

    std::string name(std::int64_t number) const
    {
        std::string digits = std::to_string(number);
        if (digits.size() < width)
            digits.insert(filler == '0' && number < 0 ? 1 : 0, width - digits.size(), filler);
        return std::string(before) + digits + std::string(behind);
    }
};

std::optional<Pattern> patternOf(std::string_view text)
{
    constexpr std::size_t mostDigits = 3;
    const auto percent = text.find('%');
    const auto end = text.find_first_not_of("0123456789", percent + 1);
    if (percent == std::string_view::npos || end == std::string_view::npos || end - percent - 1 > mostDigits ||
        (text[end] != 'd' && text[end] != 'i' && text[end] != 'u') || text.find('%', end) != std::string_view::npos)
        return std::nullopt;
    const std::string_view width = text.substr(percent + 1, end - percent - 1);
    return Pattern{text.substr(0, percent), text.substr(end + 1), parseNumber<std::size_t>(width).value_or(0),
                   width.starts_with('0') ? '0' : ' '};
}

/// Whether so many files can hold the samples, if each holds so many of the header's dimensions: one for each place
/// along the others, or a part of the last axis where it holds all.
bool fits(const NrrdFields& fields, std::uint64_t files, std::size_t dimensions)
{
    std::uint64_t wanted = 1;
    const auto sizes = split(fields["sizes"], betweenWords);
    for (std::size_t axis = dimensions; axis < sizes.size(); ++axis)
        wanted *= parseNumber<std::uint64_t>(sizes[axis]).value_or(1);
    if (dimensions < sizes.size())
        return files == wanted;
    return files > 0 && parseNumber<std::uint64_t>(sizes.back()).value_or(1) % files == 0;
}

/// What stands behind the other words: how many dimensions a file holds. Usually all but one.
Result<std::size_t> dimensionsOf(const NrrdFields& fields, const std::vector<std::string_view>& words,
                                 std::size_t others)
{
    const std::size_t all = split(fields["sizes"], betweenWords).size();
    if (words.size() <= others)
        return all - 1;
    const auto dimensions = parseNumber<std::size_t>(words.back());
    if (!dimensions || *dimensions < 1 || *dimensions > all)
        return wrongDataFile(fields, Message::say("must end with the number of dimensions that each file holds, from "
                                                  "1 to %1, or without it.",
                                                  all));
    return *dimensions;
}

Result<std::vector<std::string>> namesOfPattern(const NrrdFields& fields, const std::vector<std::string_view>& words)
{
    const auto pattern = patternOf(words[0]);
    std::array<std::int64_t, 3> numbers{};
    bool understood = pattern && words.size() <= 5;
    for (std::size_t i = 0; understood && i < 3; ++i) {
        constexpr std::int64_t farthest = 1'000'000'000;
        const auto number = parseNumber<std::int64_t>(words[i + 1]);
        understood = number && *number >= -farthest && *number <= farthest;
        numbers[i] = number.value_or(0);
    }
    const auto [first, last, step] = numbers;
    if (!understood || step == 0 || (last - first) / step < 0 || (last != first && (last > first) != (step > 0)))
        return wrongDataFile(fields, Message::say("must be a name with a number such as '%03d', and the number of the "
                                                  "first file, of the last, and the step."));
    const auto dimensions = dimensionsOf(fields, words, 4);
    if (!dimensions)
        return dimensions.error();
    const std::int64_t files = (last - first) / step + 1;
    if (!fits(fields, static_cast<std::uint64_t>(files), *dimensions))
        return wrongDataFile(fields, Message::say("names %1 files, which is not the number that its sizes ask for. "
                                                  "Correct the numbers of the first and the last file.",
                                                  files));
    constexpr std::int64_t mostFiles = 1 << 20; // their names alone take a hundred megabytes
    if (files > mostFiles)
        return wrongDataFile(fields, Message::say("names %1 files. Put the samples into fewer.", files));
    std::vector<std::string> names;
    for (std::int64_t file = 0; file < files; ++file)
        names.push_back(pattern->name(first + file * step));
    return names;
}

Result<std::vector<std::string>> namesOfList(const NrrdFields& fields)
{
    const auto dimensions = dimensionsOf(fields, split(fields["data file"], betweenWords), 1);
    if (!dimensions)
        return dimensions.error();
    if (!fits(fields, fields.listedFiles.size(), *dimensions))
        return wrongDataFile(fields, Message::say("is followed by the names of %1 files, which is not the number that "
                                                  "its sizes ask for. Each stands in a line of its own.",
                                                  fields.listedFiles.size()));
    return fields.listedFiles;
}

/// One with a zero byte would open another file than messages name.
Status checkNames(const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
            return Error{
                ErrorKind::BadInput,
                Message::say("its data file is called '%1', with characters that no name should have. Correct it.",
                             printable(name))};
    return {};
}

} // namespace

Result<std::vector<std::string>> nrrdDataFiles(const NrrdFields& fields)
{
    constexpr std::size_t wordsOfPattern = 4;
    const std::string_view text = fields["data file"];
    if (text.empty())
        return std::vector<std::string>();
    const auto words = split(text, betweenWords);
    const bool isPattern = words.size() >= wordsOfPattern && words[0].find('%') != std::string_view::npos;
    auto names = namesListOfFiles(text) ? namesOfList(fields)
                 : isPattern            ? namesOfPattern(fields, words)
                                        : Result<std::vector<std::string>>({std::string(text)});
    if (!names)
        return names;
    if (const Status usable = checkNames(*names); !usable)
        return usable.error();
    return names;
}

} // namespace tetra
