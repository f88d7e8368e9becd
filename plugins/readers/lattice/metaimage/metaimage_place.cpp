// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/metaimage/metaimage_place.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <array>

namespace tetra {

namespace {

const std::vector<std::string_view> spacingNames{"ElementSize", "ElementSpacing"};
const std::vector<std::string_view> originNames{"Position", "Offset", "Origin"};
const std::vector<std::string_view> matrixNames{"Orientation", "Rotation", "TransformMatrix"};

Eigen::Vector3d vectorOf(const std::optional<std::vector<double>>& numbers, double otherwise)
{
    return numbers ? Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(numbers->data()))
                   : Eigen::Vector3d::Constant(otherwise);
}

/// Those of the first three axes in space; each stands in a row.
Result<Eigen::Matrix3d> directionsOf(const std::optional<std::vector<double>>& numbers, std::size_t dimensions)
{
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
    for (std::size_t row = 0; numbers && row < dimensions; ++row)
        for (std::size_t column = 0; column < dimensions; ++column) {
            const double number = (*numbers)[row * dimensions + column];
            if (row < 3 && column < 3)
                directions(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(row)) = number;
            else if (row != column && number != 0)
                return Error{ErrorKind::BadInput,
                             Message::say("its matrix turns space into its further axes. Write one volume of it.")};
        }
    return directions;
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

void remarkOnOrientation(const MetaHeader& header, StoredVolume& volume)
{
    const std::string_view stated = header.text("AnatomicalOrientation").substr(0, 3);
    const bool isKnown = stated.size() == 3 && stated.find_first_not_of("RLAPIS") == std::string_view::npos;
    const auto found = orientationOf(volume.lattice);
    if (isKnown && std::ranges::find(found, stated) == found.end())
        volume.remarks.push_back(
            Message::say("Its header calls its orientation '%1', but by its matrix it is '%2'. The matrix was used.",
                         stated, found[0]));
}

/// Of several names for one thing, those that say something else than the one that counts.
void tellOthers(const MetaHeader& header, const std::vector<std::string_view>& names, StoredVolume& volume)
{
    std::string_view taken;
    for (const std::string_view name : names)
        if (header.has(name))
            taken = name;
    for (const std::string_view name : names)
        if (header.has(name) && header.text(name) != header.text(taken))
            volume.leftOut.push_back(Message::say("Its header gives the same quantity under two names, with different "
                                                  "values: %1 was used, and %2 (%3) was not.",
                                                  taken, name, printable(header.text(name))));
}

} // namespace

Status placeMetaImage(const MetaHeader& header, std::size_t dimensions, StoredVolume& volume)
{
    const auto spacing = metaNumbers(header, spacingNames, 3);
    if (!spacing)
        return spacing.error();
    const auto origin = metaNumbers(header, originNames, 3);
    if (!origin)
        return origin.error();
    const auto matrix = metaNumbers(header, matrixNames, dimensions * dimensions);
    if (!matrix)
        return matrix.error();
    const auto directions = directionsOf(*matrix, dimensions);
    if (!directions)
        return directions.error();
    placeByDirections(volume.lattice, *directions, vectorOf(*spacing, 1), vectorOf(*origin, 0));
    volume.space = "LPS";
    remarkOnOrientation(header, volume);
    tellOthers(header, originNames, volume);
    tellOthers(header, matrixNames, volume);
    if (const auto unit = header.text("DistanceUnits"); unit == "um" || unit == "mm" || unit == "cm")
        volume.lengthUnit = unit;
    volume.untold = untoldPlacement(spacing->has_value(), origin->has_value(), !volume.lengthUnit.empty());
    return {};
}

Result<std::vector<double>> metaTimes(const MetaHeader& header, std::uint64_t steps)
{
    const auto spacing = metaNumbers(header, spacingNames, 4);
    if (!spacing)
        return spacing.error();
    const auto origin = metaNumbers(header, originNames, 4);
    if (!origin)
        return origin.error();
    std::vector<double> times;
    for (std::uint64_t step = 0; *spacing && steps > 1 && steps <= mostTimes && step < steps; ++step)
        times.push_back((*origin ? (**origin)[3] : 0) + static_cast<double>(step) * (**spacing)[3]);
    return times;
}

} // namespace tetra
