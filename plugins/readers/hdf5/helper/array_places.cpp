// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/array_places.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/hdf5/helper/attributes.h"
#include "plugins/readers/hdf5/helper/imaris_picture.h"
#include "plugins/readers/hdf5/helper/itk_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

/// Three numbers of an attribute, in the order of the dimensions of space.
struct FrameAttribute {
    std::string name{};
    std::array<double, 3> numbers{};
    bool isSame = false; ///< all three: whichever order is meant
};

/// Attributes that are frames by custom, and the unit that their names say.
struct FrameName {
    const char* name;
    const char* unit;
};
constexpr std::array<FrameName, 7> spacingNames = {{{"element_size_um", "um"},
                                                    {"spacing", ""},
                                                    {"Spacing", ""},
                                                    {"voxel_size", ""},
                                                    {"voxelsize", ""},
                                                    {"pixel_size", ""},
                                                    {"resolution", ""}}};
constexpr std::array<FrameName, 4> originNames = {
    {{"origin", ""}, {"Origin", ""}, {"offset", ""}, {"translation", ""}}};

/// Of one number for all axes, of one for each dimension of space, or of one for each dimension of the array.
std::optional<FrameAttribute> frameAttribute(hid_t object, const char* name, const Hdf5Array& array,
                                             const ArrayAxes& axes, bool isLength)
{
    const auto numbers = attributeNumbers(object, name);
    FrameAttribute found{.name = name};
    for (std::size_t place = 0; place < 3; ++place) {
        if (numbers.size() == 1 && isLength)
            found.numbers[place] = static_cast<double>(numbers[0]);
        else if (numbers.size() == 3)
            found.numbers[place] = static_cast<double>(numbers[place]);
        else if (!numbers.empty() && numbers.size() == array.size.size())
            found.numbers[place] = static_cast<double>(numbers[axes.space[place]]);
        else
            return std::nullopt;
        if (!std::isfinite(found.numbers[place]) || (isLength && found.numbers[place] <= 0))
            return std::nullopt;
    }
    found.isSame = found.numbers[0] == found.numbers[1] && found.numbers[1] == found.numbers[2];
    return found;
}

/// What the attributes of an array, or of the group around it, say.
class FrameAttributes {
public:
    FrameAttributes(hid_t file, const Hdf5Array& array, const ArrayAxes& axes)
    {
        const std::string parent = array.path.substr(0, std::max<std::size_t>(1, array.path.rfind('/')));
        const Hdf5Id opened = openArray(file, array.path), group = openGroup(file, parent);
        for (const hid_t object : {hid_t(opened), hid_t(group)}) {
            if (object < 0)
                continue;
            for (const FrameName& name : spacingNames)
                take(object, name, array, axes, true, spacing);
            for (const FrameName& name : originNames)
                take(object, name, array, axes, false, origin);
        }
    }

    std::optional<FrameAttribute> spacing{}, origin{};
    std::string unit{};
    std::vector<std::string> unused{};

private:
    void take(hid_t object, const FrameName& name, const Hdf5Array& array, const ArrayAxes& axes, bool isLength,
              std::optional<FrameAttribute>& taken)
    {
        if (!hasAttribute(object, name.name))
            return;
        const auto found = taken ? std::nullopt : frameAttribute(object, name.name, array, axes, isLength);
        if (!found) {
            unused.emplace_back(name.name);
            return;
        }
        taken = found;
        if (isLength)
            unit = name.unit;
    }
};

/// Whether coordinates are equal steps within the rounding of their type.
bool isEven(const AxisSays& says, double& first, double& step)
{
    const std::vector<double>& values = *says.values;
    first = values.front();
    step = (values.back() - first) / static_cast<double>(values.size() - 1);
    const double unit = says.areSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
    const double rounding = 4 * unit * std::max(std::abs(first), std::abs(values.back()));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!(std::abs(values[i] - (first + static_cast<double>(i) * step)) <= rounding))
            return false;
    return step != 0 && rounding < std::abs(step) / 100;
}

const AxisSays& saysOf(const ArrayAxes& axes, std::size_t place)
{
    return axes.says[axes.space[place]];
}

/// Along each dimension its coordinates, or numbers in the steps that attributes say.
void placeByCoordinates(const Hdf5Array& array, const ArrayAxes& axes, const FrameAttributes& attributes,
                        ArrayPlaces& places)
{
    Eigen::Matrix3d steps = Eigen::Matrix3d::Zero();
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    for (std::size_t place = 0; place < 3; ++place) {
        const auto row = static_cast<Eigen::Index>(axes.world[place]);
        double step = attributes.spacing ? attributes.spacing->numbers[place] : 1;
        first[row] = attributes.origin ? attributes.origin->numbers[place] : 0;
        if (saysOf(axes, place).values)
            places.isLattice &= isEven(saysOf(axes, place), first[row], step);
        steps(row, 2 - static_cast<Eigen::Index>(place)) = step;
    }
    if (places.isLattice) {
        placeBySteps(places.lattice, steps, first);
        return;
    }
    for (std::size_t place = 0; place < 3; ++place) {
        std::vector<double>& along = places.coordinates[place];
        along = saysOf(axes, place).values.value_or(std::vector<double>(array.size[axes.space[place]]));
        const auto row = static_cast<Eigen::Index>(axes.world[place]), column = 2 - static_cast<Eigen::Index>(place);
        for (std::size_t at = 0; !saysOf(axes, place).values && at < along.size(); ++at)
            along[at] = first[row] + static_cast<double>(at) * steps(row, column);
    }
}

/// The unit of coordinates, if all have one; told if they differ.
void takeUnits(const ArrayAxes& axes, ArrayPlaces& places)
{
    const std::string &slow = saysOf(axes, 0).unit, &middle = saysOf(axes, 1).unit, &fast = saysOf(axes, 2).unit;
    if (slow == middle && middle == fast)
        places.lengthUnit = fast;
    else
        places.remarks.push_back(
            Message::say("Its units differ from axis to axis: %1. Its numbers were used as they are, without a unit.",
                         printable(slow + ", " + middle + ", " + fast)));
}

Message namesOfAxes(const ArrayAxes& axes)
{
    std::array<std::string, 3> names;
    for (std::size_t place = 0; place < 3; ++place)
        names[axes.world[place]] = printable(axisName(axes, axes.space[place]));
    return Message::say("%1, %2, %3", names[0], names[1], names[2]);
}

/// "axes z, y, x: the last one runs fastest", with what says how far apart they are.
void tellPlaces(const ArrayAxes& axes, const FrameAttributes& attributes, std::size_t withCoordinates,
                ArrayPlaces& places)
{
    const bool isNamed = !axes.spaceIsGuessed || withCoordinates > 0;
    Message what = isNamed ? namesOfAxes(axes) : Message::say("axes z, y, x: the last one runs fastest");
    bool isGuess = axes.spaceIsGuessed;
    for (const auto& attribute : {attributes.spacing, attributes.origin})
        if (attribute && withCoordinates < 3) {
            what = Message::say("%1, '%2' in the order of the array's axes", what, attribute->name);
            isGuess |= !attribute->isSame;
        }
    places.taken.push_back({TakenPart::Places, what, isGuess});
    for (std::size_t place = 0; place < 3; ++place)
        if (saysOf(axes, place).areMiddles)
            places.remarks.push_back(
                Message::say("Its coordinates '%1' are the edges of bins: their midpoints were used.",
                             printable(saysOf(axes, place).name)));
    for (const std::string& unused : attributes.unused)
        places.leftOut.push_back(Message::say("It has an attribute '%1', which is not used.", printable(unused)));
}

void placeByItk(const ItkFrame& frame, ArrayPlaces& places)
{
    placeByDirections(places.lattice, frame.directions, frame.spacing, frame.origin);
    places.space = "LPS"; // ITK's own, whatever it was made from
    places.untold = untoldPlacement(true, true, false);
    places.taken.push_back({TakenPart::Places, Message::say("'Origin', 'Spacing' and 'Directions' of ITK"), false});
}

void placeByImaris(const ImarisFrame& frame, ArrayPlaces& places)
{
    placeByDirections(places.lattice, Eigen::Matrix3d::Identity(), frame.spacing, frame.origin);
    places.lengthUnit = frame.unit;
    places.untold = untoldPlacement(true, true, !frame.unit.empty());
    places.taken.push_back({TakenPart::Places, Message::say("'ExtMin' and 'ExtMax' of Imaris"), false});
}

} // namespace

Result<ArrayPlaces> placesOf(hid_t file, const Hdf5Array& array, const ArrayAxes& axes)
{
    ArrayPlaces places{.world = axes.world};
    const std::array<std::uint64_t, 3> size{array.size[axes.space[2]], array.size[axes.space[1]],
                                            array.size[axes.space[0]]};
    if (const Status fits = checkLatticeSize(size); !fits)
        return fits.error();
    for (std::size_t axis = 0; axis < 3; ++axis)
        places.lattice.size[axis] = static_cast<std::uint32_t>(size[axis]);
    std::size_t withCoordinates = 0;
    for (std::size_t place = 0; place < 3; ++place)
        withCoordinates += saysOf(axes, place).values.has_value();
    if (const auto frame = itkFrameOf(file, array, axes); frame && withCoordinates == 0) {
        placeByItk(*frame, places);
        return places;
    }
    if (const auto frame = imarisFrameOf(file, array); frame && withCoordinates == 0) {
        placeByImaris(*frame, places);
        return places;
    }
    const FrameAttributes attributes(file, array, axes);
    placeByCoordinates(array, axes, attributes, places);
    if (withCoordinates == 3)
        takeUnits(axes, places);
    else
        places.lengthUnit = attributes.unit;
    tellPlaces(axes, attributes, withCoordinates, places);
    places.untold = untoldPlacement(withCoordinates > 0 || attributes.spacing, withCoordinates > 0 || attributes.origin,
                                    !places.lengthUnit.empty());
    return places;
}

std::vector<Eigen::Vector3d> positionsOf(const ArrayPlaces& places)
{
    const auto& [slow, middle, fast] = places.coordinates;
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(slow.size() * middle.size() * fast.size());
    Eigen::Vector3d place;
    for (const double first : slow)
        for (const double second : middle)
            for (const double third : fast) {
                place[static_cast<Eigen::Index>(places.world[0])] = first;
                place[static_cast<Eigen::Index>(places.world[1])] = second;
                place[static_cast<Eigen::Index>(places.world[2])] = third;
                positions.push_back(place);
            }
    return positions;
}

} // namespace tetra
