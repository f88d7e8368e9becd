// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_files.h"

#include "plugins/readers/lattice/headers/data_file_names.h"
#include "plugins/readers/lattice/headers/header_text.h"

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
    const auto pattern = numberedName(words[0]);
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
        return wrongDataFile(fields, Message::say("names %1 files, which is not the number that its sizes require. "
                                                  "Correct the numbers of the first and the last file.",
                                                  files));
    if (static_cast<std::uint64_t>(files) > mostDataFiles)
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
                                                  "its sizes require. Each is on a line of its own.",
                                                  fields.listedFiles.size()));
    return fields.listedFiles;
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
    if (const Status usable = checkDataFileNames(*names); !usable)
        return usable.error();
    return names;
}

} // namespace tetra
