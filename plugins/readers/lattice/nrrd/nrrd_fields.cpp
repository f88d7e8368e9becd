// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_fields.h"

#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <optional>

namespace tetra {

namespace {

constexpr std::string_view magic = "NRRD000";
constexpr std::size_t longestHeader = std::size_t(1) << 20;

/// Every field of the format, in one spelling.
constexpr std::array<std::string_view, 30> knownFields = {"dimension",
                                                          "type",
                                                          "block size",
                                                          "encoding",
                                                          "endian",
                                                          "content",
                                                          "min",
                                                          "max",
                                                          "old min",
                                                          "old max",
                                                          "data file",
                                                          "line skip",
                                                          "byte skip",
                                                          "number",
                                                          "sample units",
                                                          "sizes",
                                                          "spacings",
                                                          "thicknesses",
                                                          "axis mins",
                                                          "axis maxs",
                                                          "centers",
                                                          "labels",
                                                          "units",
                                                          "kinds",
                                                          "space",
                                                          "space dimension",
                                                          "space units",
                                                          "space origin",
                                                          "space directions",
                                                          "measurement frame"};

/// Earlier spellings of a name that are still in use.
std::string presentDayName(std::string_view name)
{
    constexpr std::array<std::array<std::string_view, 2>, 10> synonyms = {{{"blocksize", "block size"},
                                                                           {"oldmin", "old min"},
                                                                           {"oldmax", "old max"},
                                                                           {"datafile", "data file"},
                                                                           {"lineskip", "line skip"},
                                                                           {"byteskip", "byte skip"},
                                                                           {"sampleunits", "sample units"},
                                                                           {"axismins", "axis mins"},
                                                                           {"axismaxs", "axis maxs"},
                                                                           {"centerings", "centers"}}};
    const std::string lower = lowerCase(trimmed(name));
    const auto found = std::ranges::find(synonyms, lower, [](const auto& pair) { return pair[0]; });
    return found != synonyms.end() ? std::string((*found)[1]) : lower;
}

Error inLine(std::size_t line, const Message& what)
{
    return {ErrorKind::BadInput, Message::say("line %1 of its header %2", line, what)};
}

Status checkMagic(std::string_view line)
{
    if (!looksLikeNrrd(line))
        return Error{ErrorKind::BadInput,
                     Message::say("it is not an NRRD file: it does not begin with 'NRRD0001' to 'NRRD0005'.")};
    const std::string_view version = trimmed(line.substr(magic.size()));
    if (version.size() != 1 || version[0] < '1' || version[0] > '5')
        return Error{ErrorKind::BadInput,
                     Message::say("it has the unknown NRRD version '%1'. Save it as NRRD0005 or earlier.",
                                  printable(trimmed(line)))};
    return {};
}

Status addField(NrrdFields& fields, std::string_view line, std::size_t number)
{
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
        return inLine(number, Message::say("is neither a field nor a comment: '%1'.", printable(line)));
    if (line.substr(colon).starts_with(":="))
        return {}; // a key and a value of the user's own
    const std::string name = presentDayName(line.substr(0, colon));
    if (std::ranges::find(knownFields, name) == knownFields.end())
        return inLine(
            number, Message::say("has the unknown field '%1'. Correct its name, or write ':=' for a note of your own.",
                                 printable(name)));
    if (!fields.values.emplace(name, trimmed(line.substr(colon + 1))).second)
        return inLine(number, Message::say("gives '%1' a second time. Remove one of them.", name));
    return {};
}

} // namespace

bool namesListOfFiles(std::string_view dataFile)
{
    const auto words = split(dataFile, " \t");
    return !words.empty() && words.size() <= 2 && words[0] == "LIST";
}

bool looksLikeNrrd(std::string_view firstBytes)
{
    return firstBytes.starts_with(magic);
}

Result<NrrdFields> parseNrrdFields(std::string_view file)
{
    NrrdFields fields;
    std::size_t position = 0;
    for (std::size_t number = 1; position < file.size(); ++number) {
        const std::size_t end = std::min(file.find('\n', position), file.size());
        if (end > longestHeader)
            return Error{ErrorKind::BadInput,
                         Message::say("its header does not end: there is no empty line in the first MiB.")};
        const std::string_view line = file.substr(position, end - position);
        position = std::min(end + 1, file.size());
        fields.headerBytes = position;
        if (number == 1) {
            if (const Status known = checkMagic(line); !known)
                return known.error();
        } else if (line.empty() || line == "\r") {
            return fields;
        } else if (namesListOfFiles(fields["data file"])) {
            fields.listedFiles.emplace_back(trimmed(line));
        } else if (!line.starts_with('#')) {
            if (const Status added = addField(fields, line, number); !added)
                return added.error();
        }
    }
    return fields;
}

} // namespace tetra
