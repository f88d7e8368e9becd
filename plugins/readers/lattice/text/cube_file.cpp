// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/text/cube_file.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

/// A whole number and the vector behind it, as four lines of the header have them.
struct CountedVector {
    std::int64_t count = 0;
    Eigen::Vector3d vector{0, 0, 0};
    std::string_view rest; ///< of the line
};

std::optional<CountedVector> countedVector(std::string_view line)
{
    CountedVector counted;
    const auto count = parseNumber<std::int64_t>(takeHeaderWord(line));
    if (!count)
        return {};
    counted.count = *count;
    for (double& part : counted.vector) {
        const auto number = parseHeaderNumber(takeHeaderWord(line));
        if (!number)
            return {};
        part = *number;
    }
    counted.rest = line;
    return counted;
}

/// 2^63 also for the least number, whose magnitude it is.
std::uint64_t magnitudeOf(std::int64_t number)
{
    return number < 0 ? ~static_cast<std::uint64_t>(number) + 1 : static_cast<std::uint64_t>(number);
}

struct CubeHeader {
    CountedVector atoms;               ///< and the first point
    std::array<CountedVector, 3> axes; ///< and the steps
    std::uint64_t values = 1;          ///< how many numbers each point has
    std::vector<std::string> orbitals; ///< which these are, if they are orbitals
    std::string_view numbers;          ///< the text that has them
};

/// The header, line by line.
class CubeLines {
public:
    explicit CubeLines(std::string_view text) : lines_(text) {}

    Result<CubeHeader> parse()
    {
        CubeHeader header;
        for (int title = 0; title < 2; ++title)
            if (const auto line = lines_.next(); !line)
                return ended();
        if (const Status atoms = takeCounted(Message::say("the number of atoms and the first point"), header.atoms);
            !atoms)
            return atoms.error();
        for (CountedVector& axis : header.axes)
            if (const Status taken = takeCounted(Message::say("a number of points and the step between them"), axis);
                !taken)
                return taken.error();
        if (const Status atoms = skipAtoms(magnitudeOf(header.atoms.count)); !atoms)
            return atoms.error();
        header.numbers = lines_.rest();
        const Status named = header.atoms.count < 0 ? takeOrbitals(header) : takeValueCount(header);
        return named ? Result<CubeHeader>(header) : named.error();
    }

private:
    Error ended() const
    {
        return {ErrorKind::BadInput,
                Message::say("it ends in its header, after line %1. It is cut short.", lines_.number())};
    }
    Error wrongLine(const Message& wanted) const
    {
        return {
            ErrorKind::BadInput,
            Message::say(
                "line %1 of it is not %2, which a Gaussian cube has there. Correct the line, or write the file again.",
                lines_.number(), wanted)};
    }
    Status takeCounted(const Message& wanted, CountedVector& counted)
    {
        const auto line = lines_.next();
        if (!line)
            return ended();
        const auto found = countedVector(*line);
        if (!found)
            return wrongLine(wanted);
        counted = *found;
        return {};
    }
    Status skipAtoms(std::uint64_t count)
    {
        constexpr int numbersOfAtom = 5;
        for (std::uint64_t atom = 0; atom < count; ++atom) {
            const auto line = lines_.next();
            if (!line)
                return ended();
            std::string_view rest = *line;
            for (int number = 0; number < numbersOfAtom; ++number)
                if (!parseHeaderNumber(takeHeaderWord(rest)))
                    return wrongLine(Message::say("an atom (its number, charge and position)"));
        }
        return {};
    }
    /// Behind the atoms: how many orbitals there are, and their numbers, over one or more lines.
    Status takeOrbitals(CubeHeader& header)
    {
        std::string_view& text = header.numbers;
        const auto count = parseNumber<std::uint64_t>(takeHeaderWord(text));
        if (!count || *count == 0 || *count > text.size())
            return Error{ErrorKind::BadInput,
                         Message::say("its number of atoms is negative, and no list of orbitals follows the atoms. "
                                      "Correct it, or write the file again.")};
        header.values = *count;
        for (std::uint64_t orbital = 0; orbital < *count; ++orbital) {
            const auto number = parseNumber<std::int64_t>(takeHeaderWord(text));
            if (!number)
                return Error{ErrorKind::BadInput, Message::say("the list after its atoms does not have the numbers of "
                                                               "%1 orbitals. Correct it, or write the file again.",
                                                               *count)};
            header.orbitals.push_back("orbital " + std::to_string(*number));
        }
        return {};
    }
    /// The fifth number of the line of atoms, which is often left out.
    static Status takeValueCount(CubeHeader& header)
    {
        std::string_view rest = header.atoms.rest;
        const std::string_view word = takeHeaderWord(rest);
        const auto count = parseNumber<std::uint64_t>(word);
        if (!word.empty() && (!count || *count == 0 || *count > header.numbers.size()))
            return Error{ErrorKind::BadInput, Message::say("line 3 of it ends with '%1', where a number of values at "
                                                           "each point is expected. Correct it, or leave it out.",
                                                           printable(word))};
        header.values = count.value_or(1);
        return {};
    }

    HeaderLines lines_;
};

/// The size; whether it is in angstrom, in `unit`.
Result<std::array<std::uint64_t, 3>> cubeSize(const CubeHeader& header, std::string& unit)
{
    const auto negative = std::ranges::count_if(header.axes, [](const auto& axis) { return axis.count < 0; });
    if (negative != 0 && negative != 3)
        return Error{ErrorKind::BadInput,
                     Message::say("its numbers of points are negative along some axes, as if some steps were in "
                                  "angstrom and others in bohr. Make all of them positive or all negative.")};
    unit = negative == 0 ? "bohr" : "angstrom";
    return std::array{magnitudeOf(header.axes[0].count), magnitudeOf(header.axes[1].count),
                      magnitudeOf(header.axes[2].count)};
}

void placeCube(const CubeHeader& header, StoredVolume& volume)
{
    Eigen::Matrix3d steps;
    for (std::size_t axis = 0; axis < 3; ++axis)
        steps.col(static_cast<Eigen::Index>(axis)) = header.axes[axis].vector;
    placeBySteps(volume.lattice, steps, header.atoms.vector);
}

void tellAtoms(std::uint64_t atoms, StoredVolume& volume)
{
    if (atoms == 1)
        volume.leftOut.push_back(Message::say("It names 1 atom, which is not shown."));
    else if (atoms > 1)
        volume.leftOut.push_back(Message::say("It names %1 atoms, which are not shown.", atoms));
}

/// Which of the numbers of each point is taken.
Status chooseValue(const VolumeRequest& request, const CubeHeader& header, StoredVolume& volume)
{
    constexpr std::uint64_t mostValues = 10'000;
    if (header.values > mostValues)
        return Error{ErrorKind::BadInput, Message::say("its header requires %1 values at each point, and at most %2 "
                                                       "are read. Write fewer orbitals into a file.",
                                                       header.values, mostValues)};
    for (const std::string& name : header.orbitals)
        volume.arrays.push_back({.name = name});
    for (std::uint64_t value = 1; header.orbitals.empty() && value <= header.values; ++value)
        volume.arrays.push_back({.name = header.values == 1 ? std::string() : "value " + std::to_string(value)});
    const auto chosen = takeArray(volume, request.values);
    if (!chosen)
        return chosen.error();
    if (const Status one = takeComponent(volume, request.values); !one)
        return one;
    volume.first = *chosen;
    setStrides(volume, header.values, true);
    if (header.values > 1)
        volume.leftOut.push_back(
            Message::say("It holds %1 values at each point; the others are not read.", header.values));
    return {};
}

/// A colour table of pictures has the same ending.
bool isColourTable(std::string_view text)
{
    return text.substr(0, 4096).find("LUT_3D_SIZE") != std::string_view::npos;
}

} // namespace

bool looksLikeCube(std::string_view beginning)
{
    HeaderLines lines(beginning);
    for (int title = 0; title < 2; ++title)
        if (!lines.next())
            return false;
    for (int vector = 0; vector < 4; ++vector)
        if (const auto line = lines.next(); !line || !countedVector(*line))
            return false;
    return true;
}

Result<StoredVolume> describeCube(const VolumeRequest& request)
{
    if (isColourTable(request.text()))
        return Error{ErrorKind::BadInput, Message::say("it is a table of colours for pictures, which has the same "
                                                       "ending as Gaussian cubes. It holds no volume.")};
    const auto header = CubeLines(request.text()).parse();
    if (!header)
        return header.error();
    StoredVolume volume;
    const auto size = cubeSize(*header, volume.lengthUnit);
    if (!size)
        return size.error();
    volume.type = StoredType::Float64;
    if (const Status set = setStoredSize(volume, *size, header->values); !set)
        return set.error();
    placeCube(*header, volume);
    tellAtoms(magnitudeOf(header->atoms.count), volume);
    if (const Status chosen = chooseValue(request, *header, volume); !chosen)
        return chosen.error();
    volume.files = {{request.path, StoredPacking::Text}};
    volume.offset = static_cast<std::uint64_t>(header->numbers.data() - request.text().data());
    volume.rest = StoredRest::Refused;
    return volume;
}

} // namespace tetra
