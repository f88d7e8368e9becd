// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/metaimage_header.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/vtk/checks/checked_file.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

/// The first so many numbers of the last of these fields that is there; nothing if none is.
Result<std::optional<std::vector<double>>> numbersOf(const MetaHeader& header,
                                                     std::initializer_list<std::string_view> names, std::size_t count)
{
    std::optional<std::vector<double>> numbers;
    for (const std::string_view name : names) {
        if (!header.fields.contains(name))
            continue;
        const auto words = metaWords(header.text(name));
        numbers.emplace();
        for (std::size_t i = 0; i < std::min(count, words.size()); ++i)
            if (const auto number = parseNumber<double>(words[i]); number && std::isfinite(*number))
                numbers->push_back(*number);
        if (numbers->size() != count)
            return wrongHeader(
                Message::say("its %1 is '%2' and not %3 finite numbers.", name, printable(header.text(name)), count));
    }
    return numbers;
}

Eigen::Vector3d vectorOf(const std::optional<std::vector<double>>& numbers, double otherwise)
{
    return numbers ? Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(numbers->data()))
                   : Eigen::Vector3d::Constant(otherwise);
}

/// "RAI" for axes that run from the right to the left, from the front to the back and from the feet to the head, as
/// the format names that, and "LPS" by the ends.
std::array<std::string, 2> orientationOf(const Lattice& lattice)
{
    constexpr std::string_view begins = "RAI", ends = "LPS";
    std::array<std::string, 2> letters;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::Index along = 0;
        lattice.directions.col(axis).cwiseAbs().maxCoeff(&along);
        const bool backwards = lattice.directions(along, axis) < 0;
        letters[0] += (backwards ? ends : begins)[static_cast<std::size_t>(along)];
        letters[1] += (backwards ? begins : ends)[static_cast<std::size_t>(along)];
    }
    return letters;
}

void remarkOnOrientation(const MetaHeader& header, MetaPlace& place)
{
    const std::string_view stated = header.text("AnatomicalOrientation");
    const bool isKnown = stated.size() == 3 && stated.find_first_not_of("RLAPIS") == std::string_view::npos;
    const auto found = orientationOf(place.lattice);
    if (isKnown && std::ranges::find(found, stated) == found.end())
        place.remarks.push_back(Message::say("Its header calls its orientation '%1', which by its matrix is '%2'. The "
                                             "matrix was taken.",
                                             stated, found[0]));
}

} // namespace

std::string_view strippedOfBlanks(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(metaBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(metaBlanks) + 1);
}

std::vector<std::string> metaWords(std::string_view text)
{
    std::vector<std::string> words;
    for (text = strippedOfBlanks(text); !text.empty(); text = strippedOfBlanks(text)) {
        words.emplace_back(text.substr(0, text.find_first_of(metaBlanks)));
        text.remove_prefix(words.back().size());
    }
    return words;
}

std::string_view MetaHeader::text(std::string_view name) const
{
    const auto field = fields.find(name);
    return field == fields.end() ? std::string_view() : std::string_view(field->second);
}

bool MetaHeader::isTrue(std::string_view name) const
{
    const std::string_view value = text(name);
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

Result<MetaHeader> metaHeaderOf(std::string_view bytes)
{
    constexpr std::size_t longest = 1 << 20; // real ones have some hundred bytes
    MetaHeader header;
    for (std::size_t place = 0; place < std::min(bytes.size(), longest);) {
        const auto end = bytes.find('\n', place);
        const std::string_view line = bytes.substr(place, end == std::string_view::npos ? end : end - place);
        place = end == std::string_view::npos ? bytes.size() : end + 1;
        const auto separator = line.find_first_of("=:");
        if (separator == std::string_view::npos)
            continue;
        const std::string name(strippedOfBlanks(line.substr(0, separator)));
        header.fields[name] = strippedOfBlanks(line.substr(separator + 1));
        if (name == "ElementDataFile") {
            header.end = place;
            return header;
        }
    }
    return Error{ErrorKind::BadInput, Message::say("its header has no line 'ElementDataFile = ...', so that it is cut "
                                                   "short or no MetaImage. Copy the file again.")};
}

Result<std::optional<MetaPlace>> metaImagePlace(const MetaHeader& header)
{
    if (parseNumber<double>(header.text("NDims")) != 3)
        return std::optional<MetaPlace>();
    // Of several names for one thing the last counts, as in MetaIO.
    const auto spacing = numbersOf(header, {"ElementSize", "ElementSpacing"}, 3);
    if (!spacing)
        return spacing.error();
    const auto origin = numbersOf(header, {"Position", "Offset", "Origin"}, 3);
    if (!origin)
        return origin.error();
    const auto matrix = numbersOf(header, {"Orientation", "Rotation", "TransformMatrix"}, 9);
    if (!matrix)
        return matrix.error();
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
    if (*matrix)
        directions = Eigen::Map<const Eigen::Matrix3d>((*matrix)->data()); // its rows are columns
    MetaPlace place;
    placeByDirections(place.lattice, directions, vectorOf(*spacing, 1), vectorOf(*origin, 0));
    remarkOnOrientation(header, place);
    if (const auto unit = header.text("DistanceUnits"); unit == "um" || unit == "mm" || unit == "cm")
        place.lengthUnit = unit;
    place.untold = untoldPlacement(spacing->has_value(), origin->has_value(), !place.lengthUnit.empty());
    return std::optional(place);
}

Result<std::optional<MetaPlace>> metaImagePlace(const std::filesystem::path& path)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto header = metaHeaderOf({reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size()});
    if (!header)
        return header.error();
    return metaImagePlace(*header);
}

} // namespace tetra
