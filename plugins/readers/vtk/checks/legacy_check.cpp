// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

/// The next line that is not blank, in upper case; moves `text` behind it.
std::string nextLegacyLine(std::string_view& text)
{
    constexpr std::size_t longest = 256;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, std::min(end, longest)));
        text.remove_prefix(std::min(end + 1, text.size()));
        line.erase(0, std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (line.empty())
            continue;
        std::ranges::transform(line, line.begin(),
                               [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
        return line;
    }
    return {};
}

} // namespace

Result<CheckedFile> checkLegacy(const std::filesystem::path& path)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    CheckedFile checked{.bytes = text.size()};
    std::string_view rest = text;
    for (int line = 0; line < 2; ++line) // its signature, and its title, which may be blank
        rest.remove_prefix(rest.find('\n') == std::string_view::npos ? rest.size() : rest.find('\n') + 1);
    const bool isText = nextLegacyLine(rest).starts_with("ASCII");
    const std::string content = nextLegacyLine(rest);
    const std::string shown = printable(content.substr(0, content.find_last_not_of(" \t\r") + 1));
    const auto beginsWithOne = [&](std::initializer_list<std::string_view> kinds) {
        return std::ranges::any_of(kinds, [&](std::string_view kind) { return content.starts_with(kind); });
    };
    if (beginsWithOne({"FIELD", "DATASET TABLE", "DATASET TREE", "DATASET DIRECTED_GRAPH", "DATASET UNDIRECTED_GRAPH",
                       "DATASET MOLECULE"}))
        return Error{ErrorKind::BadInput, Message::say("it holds '%1': values alone, without the points or the grid "
                                                       "that they belong to. Write them with their grid.",
                                                       shown)};
    if (!content.empty() &&
        !beginsWithOne({"DATASET STRUCTURED_POINTS", "DATASET STRUCTURED_GRID", "DATASET RECTILINEAR_GRID",
                        "DATASET UNSTRUCTURED_GRID", "DATASET POLYDATA", "DATASET MULTI", "DATASET HIERARCHICAL",
                        "DATASET OVERLAPPING", "DATASET NON_OVERLAPPING"}))
        return Error{ErrorKind::BadInput,
                     Message::say("it has '%1' where DATASET and a type such as STRUCTURED_POINTS or UNSTRUCTURED_GRID "
                                  "should be. It is damaged, or was written by a faulty program.",
                                  shown)};
    if (isText && !text.empty() && static_cast<unsigned char>(text.back()) > ' ')
        checked.remarks.push_back(
            Message::say("The file ends without an end of line: if it was cut short there, its last number is wrong."));
    return checked;
}

} // namespace tetra
