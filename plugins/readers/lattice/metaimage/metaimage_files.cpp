// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/metaimage/metaimage_files.h"

#include "plugins/readers/lattice/headers/data_file_names.h"
#include "plugins/readers/lattice/headers/header_text.h"

#include <array>
#include <cstdlib>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

std::vector<std::string> wordsOf(std::string_view text)
{
    const auto words = split(text, " \t\r\n\v\f");
    return {words.begin(), words.end()};
}

Error tooMany(std::uint64_t files)
{
    return {ErrorKind::BadInput, Message::say("its header names %1 files. Put the samples into fewer.", files)};
}

/// Below the header, one a line, each for a part of so many dimensions; usually all but the last.
Result<Names> namesOfList(std::string_view list, std::string_view lines, std::span<const std::uint64_t> sizes)
{
    const auto words = wordsOf(list);
    const auto last = static_cast<std::int64_t>(sizes.size()) - 1;
    std::int64_t dimensions = words.size() > 1 ? metaWholeNumber(words[1]).value_or(last) : last;
    if (dimensions <= 0 || dimensions > last + 1)
        dimensions = last;
    std::uint64_t files = 1;
    for (const std::uint64_t size : sizes.subspan(static_cast<std::size_t>(dimensions)))
        files = cappedProduct(files, size);
    if (files > mostDataFiles)
        return tooMany(files);
    Names names;
    while (names.size() < files) {
        const auto end = lines.find('\n');
        if (end == std::string_view::npos) // a last line that does not end may be cut short
            return Error{ErrorKind::BadInput, Message::say("it should name %1 data files, each on a line of its own, "
                                                           "and names %2. It is cut short: copy the file again.",
                                                           files, names.size())};
        names.emplace_back(trimmed(lines.substr(0, end)));
        lines.remove_prefix(end + 1);
    }
    return names;
}

/// "slice%03d.raw FIRST LAST STEP": a file for each layer.
Result<Names> namesOfSeries(std::string_view series, std::uint64_t layerCount)
{
    constexpr std::int64_t farthest = 1'000'000'000;
    if (layerCount > mostDataFiles)
        return tooMany(layerCount);
    const auto layers = static_cast<std::int64_t>(layerCount);
    auto words = wordsOf(series);
    while (words.size() > 4) { // blanks in the name
        words[0] += " " + words[1];
        words.erase(words.begin() + 1);
    }
    std::array<std::int64_t, 3> numbers{1, layers, 1};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto number = metaWholeNumber(words[i]);
        if (!number || std::abs(*number) > farthest)
            return wrongMetaHeader(Message::say("its ElementDataFile is '%1'.", printable(series)));
        numbers[i - 1] = *number;
    }
    if (words.size() == 2)
        numbers[1] = numbers[0] + layers - 1;
    if (words.size() == 3)
        numbers[2] = (numbers[1] - numbers[0]) / layers;
    const auto [first, end, step] = numbers;
    if (step < 1 || 1 + (end - first) / step < layers)
        return Error{ErrorKind::BadInput,
                     Message::say("its ElementDataFile '%1' does not name a file for each of its %2 layers. Write the "
                                  "numbers of the first, the last and the step after the name.",
                                  printable(series), layers)};
    const auto pattern = numberedName(words[0]);
    if (!pattern)
        return wrongMetaHeader(
            Message::say("its ElementDataFile '%1' is not a name with a number such as '%03d'.", printable(series)));
    Names names;
    for (std::int64_t layer = 0; layer < layers; ++layer)
        names.push_back(pattern->name(first + layer * step));
    return names;
}

Result<StoredFile> fileOf(const fs::path& header, const std::string& name, StoredPacking packing)
{
    const fs::path path = header.parent_path() / name;
    std::error_code ignored;
    if (!name.empty() && fs::exists(path, ignored))
        return StoredFile{path, packing};
    for (const char* ending : {".gz", ".Z"})
        if (const fs::path packed = path.string() + ending; !name.empty() && fs::exists(packed, ignored))
            return StoredFile{packed, StoredPacking::Zlib};
    return Error{ErrorKind::BadInput,
                 Message::say("its data file %1 is missing. Copy it into the same folder: the two belong together.",
                              "'" + printable(name) + "'")};
}

} // namespace

bool isLocalMetaImage(const MetaHeader& header)
{
    const std::string_view name = header.text("ElementDataFile");
    return name == "LOCAL" || name == "Local" || name == "local";
}

Result<Names> metaDataFileNames(const MetaHeader& header, std::string_view text, std::span<const std::uint64_t> sizes)
{
    const std::string_view name = header.text("ElementDataFile");
    if (isLocalMetaImage(header))
        return Names();
    auto names = name.starts_with("LIST")                   ? namesOfList(name, text.substr(header.end), sizes)
                 : name.find('%') != std::string_view::npos ? namesOfSeries(name, sizes.back())
                                                            : Result<Names>(Names{std::string(name)});
    if (!names)
        return names;
    if (const Status usable = checkDataFileNames(*names); !usable)
        return usable.error();
    return names;
}

Result<std::vector<StoredFile>> metaDataFiles(const MetaHeader& header, std::string_view text,
                                              std::span<const std::uint64_t> sizes, const fs::path& path,
                                              StoredPacking packing)
{
    if (isLocalMetaImage(header))
        return std::vector<StoredFile>{{path, packing}};
    const auto names = metaDataFileNames(header, text, sizes);
    if (!names)
        return names.error();
    std::vector<StoredFile> files;
    for (const std::string& name : *names) {
        auto file = fileOf(path, name, packing);
        if (!file)
            return file.error();
        files.push_back(*std::move(file));
    }
    return files;
}

} // namespace tetra
