// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/format_checks.h"

#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// Where the section that begins at `place` ends, as VTK finds its end: by its brackets, or of a binary one, which has
/// a longer number, by its last words.
std::size_t endOfSection(std::string_view text, std::size_t place, std::size_t longestTextNumber)
{
    const auto blank = text.find(' ', place);
    if (blank == std::string_view::npos)
        return blank;
    const std::string number(text.substr(place + 1, blank - place - 1));
    if (number.size() > longestTextNumber) {
        const auto words = text.find("End of Binary Section", blank);
        return words == std::string_view::npos ? words : text.find(')', words);
    }
    int depth = 0;
    for (; place < text.size(); ++place) {
        depth += text[place] == '(' ? 1 : text[place] == ')' ? -1 : 0;
        if (depth == 0)
            return place;
    }
    return std::string_view::npos;
}

/// Whether VTK takes the last digit of a section's values for what parts them from their bracket: of values in text it
/// leaves out the last letter.
bool losesDigit(std::string_view section)
{
    constexpr std::string_view valuesInText = "(300 ";
    const auto values = section.starts_with(valuesInText) ? section.find('(', valuesInText.size() + 2) : section.npos;
    const auto end = values == section.npos ? section.npos : section.find(')', values);
    return end != section.npos && end > values + 1 &&
           std::string_view(" \t\r\n").find(section[end - 1]) == section.npos;
}

Status checkSections(const Message& what, std::string_view text, std::size_t longestTextNumber)
{
    for (auto place = text.find('('); place != std::string_view::npos; place = text.find('(', place)) {
        const auto begin = place;
        place = endOfSection(text, begin, longestTextNumber);
        if (place == std::string_view::npos)
            return Error{ErrorKind::BadInput,
                         Message::say("%1 ends within a section. It is cut short: copy the file again.", what)};
        if (losesDigit(text.substr(begin, place - begin)))
            return Error{
                ErrorKind::BadInput,
                Message::say("%1 has values whose closing bracket directly follows the last one, of which VTK then "
                             "drops a digit. Put an end of line before the bracket, or export the file again.",
                             what)};
    }
    return {};
}

} // namespace

Result<CheckedFile> checkFluent(const fs::path& path)
{
    CheckedFile checked;
    fs::path data = path;
    data.replace_extension("dat");
    std::error_code ignored;
    if (!fs::exists(data, ignored))
        return Error{ErrorKind::BadInput,
                     Message::say("its file %1, which holds the values, is missing. Copy it into the same folder.",
                                  nameOf(data))};
    for (const fs::path& part : {path, data}) {
        const auto file = MappedFile::open(part);
        if (!file)
            return file.error();
        const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
        const bool isCase = part == path;
        if (text.find('(') == std::string_view::npos)
            return Error{ErrorKind::BadInput,
                         Message::say("%1 has no section. It is cut short, or of another format.",
                                      isCase ? Message::say("it") : Message::say("its file %1", nameOf(data)))};
        const Status ends = checkSections(isCase ? Message::say("it") : Message::say("its file %1", nameOf(data)), text,
                                          isCase ? 2 : 3);
        if (!ends)
            return ends.error();
        checked.bytes = boundedSum(checked.bytes, text.size());
    }
    return checked;
}

} // namespace tetra
