// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_choice.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/api/time_steps.h"
#include "plugins/readers/zarr/helper/ome_image.h"
#include "plugins/readers/zarr/helper/zarr_tree.h"
#include "plugins/readers/zarr/zarr_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace tetra {
namespace {

constexpr std::size_t mostListed = 1000, mostTimes = 1'000'000;

Error wrongChoice(const Message& what)
{
    return {ErrorKind::WrongUsage, what};
}

/// "a, b, c", the first of them.
std::string someOf(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t number = 0; number < std::min(names.size(), most); ++number)
        text += (number == 0 ? "" : ", ") + printable(names[number]);
    return names.size() > most ? text + " ..." : text;
}

// Which array.

/// What is read of a folder: an array, perhaps as a level of an image.
struct ZarrTarget {
    std::string path;
    std::optional<OmeImage> image{};
    std::size_t level = 0;
};

/// The level that is asked for, and what is told of it.
Result<ZarrTarget> levelOf(OmeImage image, const std::string& wanted, ZarrChoice& choice)
{
    const std::size_t count = image.levels.size();
    std::size_t level = 0;
    if (!wanted.empty()) {
        const auto named = std::ranges::find(image.levels, wanted, &OmeLevel::name);
        const auto number = parseNumber<std::size_t>(wanted);
        if (named != image.levels.end())
            level = static_cast<std::size_t>(named - image.levels.begin());
        else if (number && *number < count)
            level = *number;
        else
            return wrongChoice(Message::say("it has no level '%1'. Choose one from 0 to %2 with 'part'.",
                                            printable(wanted), count - 1));
    }
    for (const OmeLevel& one : image.levels)
        choice.levels.push_back(one.name);
    if (count > 1) {
        const std::string& name = image.levels[level].name;
        const Message which = Message::say("%1 of 0 to %2", level, count - 1);
        choice.taken.push_back({TakenPart::Block,
                                name == std::to_string(level) ? which : Message::say("%1, %2", which, printable(name)),
                                wanted.empty()});
        choice.leftOut.push_back(Message::say("It has %1 levels of detail, 0 being the finest; the others are not "
                                              "read. Choose one with 'part'.",
                                              count));
    }
    choice.leftOut.insert(choice.leftOut.end(), image.leftOut.begin(), image.leftOut.end());
    ZarrTarget target{image.levels[level].path, std::move(image), level};
    return target;
}

Result<ZarrTarget> imageAt(const ZarrFolder& folder, const std::string& path, const std::string& level,
                           ZarrChoice& choice)
{
    const auto node = zarrNode(folder, path);
    if (!node)
        return node.error();
    auto image = omeImage(path, node->attributes);
    if (!image)
        return image.error();
    return levelOf(*std::move(image), level, choice);
}

/// The array or the image that the user names.
Result<ZarrTarget> namedTarget(const ZarrFolder& folder, const ZarrRequest& request, const ZarrTree& tree,
                               ZarrChoice& choice)
{
    std::string path = request.array;
    auto node = zarrNode(folder, path);
    if (!node)
        return node.error();
    if (const auto number = parseNumber<std::size_t>(path);
        node->kind == ZarrNode::Kind::None && number && *number >= 1 && *number <= tree.arrays.size()) {
        path = tree.arrays[*number - 1];
        if (node = zarrNode(folder, path); !node)
            return node.error();
    }
    if (node->kind == ZarrNode::Kind::Array) {
        const auto slash = path.rfind('/');
        const std::string parent = slash == std::string::npos ? std::string() : path.substr(0, slash);
        const auto above = zarrNode(folder, parent);
        const auto image =
            above && isOmeImage(above->attributes) ? omeImage(parent, above->attributes) : Result<OmeImage>(Error{});
        if (image && std::ranges::find(image->levels, path, &OmeLevel::path) != image->levels.end())
            return levelOf(*image, std::ranges::find(image->levels, path, &OmeLevel::path)->name, choice);
        return ZarrTarget{path};
    }
    if (node->kind == ZarrNode::Kind::Group && isOmeImage(node->attributes))
        return imageAt(folder, path, request.part, choice);
    return wrongChoice(tree.arrays.empty() ? Message::say("it has no array '%1'.", printable(path))
                                           : Message::say("it has no array '%1'. Available: %2.", printable(path),
                                                          someOf(tree.arrays)));
}

/// Of several images the one that is asked for.
Result<ZarrTarget> chosenImage(const ZarrFolder& folder, const ZarrRequest& request, const ZarrTree& tree,
                               ZarrChoice& choice)
{
    const std::size_t count = tree.images.size();
    std::size_t image = 0;
    if (!request.series.empty()) {
        const auto named = std::ranges::find(tree.images, request.series);
        const auto number = parseNumber<std::size_t>(request.series);
        if (named != tree.images.end())
            image = static_cast<std::size_t>(named - tree.images.begin());
        else if (number && *number >= 1 && *number <= count)
            image = *number - 1;
        else
            return wrongChoice(Message::say("it has no '%1' for '%2'. Choose one from 1 to %3, or by its name.",
                                            printable(request.series), "series", count));
    }
    auto target = imageAt(folder, tree.images[image], request.part, choice);
    if (!target || count < 2)
        return target;
    choice.series = tree.images;
    choice.taken.push_back({TakenPart::Series,
                            Message::say("%1 of %2: %3", image + 1, count, printable(tree.images[image])),
                            request.series.empty()});
    choice.leftOut.push_back(
        Message::say("It holds %1 images; the others are not read. Choose one with 'series'.", count));
    return target;
}

void tellTree(const ZarrTree& tree, ZarrChoice& choice)
{
    if (tree.hasLabels)
        choice.leftOut.push_back(Message::say("Its labels, which number the parts of a picture, are not read."));
    if (!tree.images.empty() && !tree.arrays.empty())
        choice.leftOut.push_back(
            Message::say("It holds %1 other arrays (%2), which are not read. Choose one with 'array'.",
                         tree.arrays.size(), someOf(tree.arrays)));
    if (tree.damaged > 0)
        choice.leftOut.push_back(
            Message::say("%1 of its groups and arrays have metadata that cannot be read.", tree.damaged));
    if (tree.isCut)
        choice.leftOut.push_back(
            Message::say("It has more groups and arrays than are listed; 'array' takes any of them by its path."));
}

Result<ZarrTarget> chooseTarget(const ZarrFolder& folder, const ZarrRequest& request, ZarrChoice& choice)
{
    const auto tree = zarrTree(folder);
    if (!tree)
        return tree.error();
    const bool isNamed = !request.array.empty() && request.array != "automatic";
    tellTree(*tree, choice);
    choice.arrays = tree->images.empty() ? tree->arrays : std::vector<std::string>();
    if (isNamed)
        return namedTarget(folder, request, *tree, choice);
    if (!tree->images.empty())
        return chosenImage(folder, request, *tree, choice);
    if (!tree->arrays.empty())
        return ZarrTarget{tree->arrays.front()};
    const auto root = zarrNode(folder, "");
    if (root && root->kind == ZarrNode::Kind::Array) {
        const auto array = zarrArray("", *root);
        return array ? Error{ErrorKind::BadInput,
                             Message::say("it is an array with %1 axes, and TAn reads volumes, which have three.",
                                          array->shape.size())}
                     : array.error();
    }
    return Error{ErrorKind::BadInput,
                 tree->others > 0
                     ? Message::say("it holds %1 arrays, and none of numbers along three axes or more.", tree->others)
                     : Message::say("it holds no array. Open the folder that contains the arrays, or copy it again.")};
}

// Which volume of the array.

/// Sets the number along an axis that is no axis of the volume.
Status chooseAlong(std::size_t axis, std::uint64_t wanted, const std::string& option, ZarrChoice& choice)
{
    const std::uint64_t count = choice.array.shape[axis];
    if (wanted > count)
        return wrongChoice(Message::say("it has %1 of '%2', and number %3 was requested. Choose one from 1 to %1.",
                                        count, printable(option), wanted));
    choice.selection.numbers[axis] = wanted > 0 ? wanted - 1 : 0;
    return {};
}

Status chooseTime(std::optional<std::size_t> axis, const ZarrTarget& target, const ZarrAxis& description,
                  std::int64_t wanted, ZarrChoice& choice)
{
    const std::uint64_t count = axis ? choice.array.shape[*axis] : 1;
    if (wanted > 0 && static_cast<std::uint64_t>(wanted) > count)
        return noSuchTimeStep(count, wanted);
    if (count < 2)
        return {};
    if (const Status chosen = chooseAlong(*axis, static_cast<std::uint64_t>(wanted), "time", choice); !chosen)
        return chosen;
    const bool hasTimes = target.image && !target.image->levels[target.level].scale.empty();
    const double step = hasTimes ? target.image->levels[target.level].scale[*axis] : 1;
    const double start = hasTimes ? target.image->levels[target.level].translation[*axis] : 1;
    for (std::uint64_t number = 0; number < (count <= mostTimes ? count : 0); ++number)
        choice.timeSteps.push_back(start + step * static_cast<double>(number));
    const std::uint64_t number = choice.selection.numbers[*axis];
    const Message which = Message::say("%1 of %2", number + 1, count);
    const std::string time = formatNumber(start + step * static_cast<double>(number));
    choice.taken.push_back(
        {TakenPart::TimeStep,
         description.unit.empty() ? which : Message::say("%1, time %2 %3", which, time, printable(description.unit)),
         wanted == 0});
    choice.leftOut.push_back(
        Message::say("It has %1 time steps; the others are not read. Choose one with '--time'.", count));
    return {};
}

Status chooseChannel(std::optional<std::size_t> axis, const std::vector<std::string>& names, const std::string& wanted,
                     ZarrChoice& choice)
{
    const std::uint64_t count = axis ? choice.array.shape[*axis] : 1;
    std::uint64_t channel = 0;
    if (!wanted.empty()) {
        const auto named = std::ranges::find(names, wanted);
        const auto number = parseNumber<std::uint64_t>(wanted);
        if (named != names.end() && static_cast<std::uint64_t>(named - names.begin()) < count)
            channel = static_cast<std::uint64_t>(named - names.begin());
        else if (number && *number >= 1 && *number <= count)
            channel = *number - 1;
        else
            return wrongChoice(Message::say("it has no '%1' for '%2'. Choose one from 1 to %3, or by its name.",
                                            printable(wanted), "channel", count));
    }
    if (count < 2)
        return {};
    choice.selection.numbers[*axis] = channel;
    const auto nameOf = [&](std::uint64_t number) {
        return number < names.size() ? printable(names[number]) : std::string();
    };
    for (std::uint64_t number = 0; number < std::min<std::uint64_t>(count, mostListed); ++number)
        choice.channels.push_back(nameOf(number).empty() ? std::to_string(number + 1) : nameOf(number));
    const Message which = Message::say("%1 of %2", channel + 1, count);
    choice.taken.push_back({TakenPart::Channel,
                            nameOf(channel).empty() ? which : Message::say("%1, %2", which, nameOf(channel)),
                            wanted.empty()});
    choice.leftOut.push_back(
        Message::say("It has %1 channels; the others are not read. Choose one with 'channel'.", count));
    return {};
}

/// What an axis is called where it is asked for.
std::string axisName(const std::vector<ZarrAxis>& axes, std::size_t axis)
{
    return axes[axis].name.empty() ? std::to_string(axis + 1) : printable(axes[axis].name);
}

/// The axes that are neither of the volume nor time and channel.
Status chooseFurther(const std::vector<ZarrAxis>& axes, const std::vector<std::size_t>& further,
                     const std::string& wanted, ZarrChoice& choice)
{
    auto numbers = parseAxisNumbers(wanted);
    if (!numbers)
        return numbers.error();
    for (const std::size_t axis : further) {
        const std::string name = axisName(axes, axis);
        const auto found = numbers->find(name);
        if (const Status chosen = chooseAlong(axis, found == numbers->end() ? 0 : found->second, name, choice); !chosen)
            return chosen;
        if (found == numbers->end() && choice.array.shape[axis] > 1)
            choice.leftOut.push_back(Message::say("It has %1 volumes along its axis '%2', of which the first is read. "
                                                  "Choose one with 'index', as in %2=2.",
                                                  choice.array.shape[axis], printable(name)));
        if (found != numbers->end())
            numbers->erase(found);
    }
    if (!numbers->empty())
        return wrongChoice(
            Message::say("it has no further axis '%1' for 'index'.", printable(numbers->begin()->first)));
    return {};
}

/// The three axes of the volume: those that are called x, y and z, or else the last ones of space, x being the last.
/// Nothing if there are not as many.
std::optional<std::array<std::size_t, 3>> volumeAxes(const std::vector<ZarrAxis>& axes, bool areNamed,
                                                     const std::vector<std::uint64_t>& shape, bool& isGuessed)
{
    std::array<std::optional<std::size_t>, 3> named;
    std::vector<std::size_t> ofSpace;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const std::string& name = axes[axis].name;
        const bool isSpace = axes[axis].kind == ZarrAxis::Kind::Space;
        for (std::size_t letter = 0; letter < 3; ++letter)
            if (isSpace && (name == std::string(1, "xyz"[letter]) || name == std::string(1, "XYZ"[letter])))
                named[letter] = axis;
        const bool canBe = axes[axis].kind == ZarrAxis::Kind::Other && !areNamed;
        if (isSpace || (canBe && shape[axis] > 1))
            ofSpace.push_back(axis);
    }
    if (named[0] && named[1] && named[2])
        return std::array{*named[0], *named[1], *named[2]};
    isGuessed = true;
    if (ofSpace.size() < 3)
        return std::nullopt;
    return std::array{ofSpace[ofSpace.size() - 1], ofSpace[ofSpace.size() - 2], ofSpace[ofSpace.size() - 3]};
}

/// The volume's size, if it is one.
Status checkVolume(ZarrChoice& choice)
{
    const auto size = choice.selection.sizeIn(choice.array);
    if (const Status fits = checkLatticeSize(size); !fits)
        return fits;
    for (std::size_t axis = 0; axis < 3; ++axis)
        choice.lattice.size[axis] = static_cast<std::uint32_t>(size[axis]);
    return {};
}

std::string shapeText(const std::vector<std::uint64_t>& shape)
{
    std::string text;
    for (const std::uint64_t size : shape)
        text += (text.empty() ? "" : " x ") + std::to_string(size);
    return text;
}

Status chooseVolume(const ZarrRequest& request, const ZarrTarget& target, const std::vector<ZarrAxis>& axes,
                    ZarrChoice& choice)
{
    const auto& shape = choice.array.shape;
    if (std::ranges::find(shape, std::uint64_t(0)) != shape.end())
        return Error{ErrorKind::BadInput, Message::say("it holds no values: its size is %1.", shapeText(shape))};
    bool isGuessed = false;
    const auto volume = volumeAxes(axes, target.image.has_value(), shape, isGuessed);
    if (!volume)
        return Error{ErrorKind::BadInput,
                     Message::say("it holds pictures, not volumes: it has fewer than three axes of space (its size is "
                                  "%1).",
                                  shapeText(shape))};
    choice.selection.axes = *volume;
    choice.selection.numbers.assign(shape.size(), 0);
    if (const Status fits = checkVolume(choice); !fits)
        return fits;
    std::optional<std::size_t> time, channel;
    std::vector<std::size_t> further;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        if (std::ranges::find(*volume, axis) == volume->end()) {
            const ZarrAxis::Kind kind = axes[axis].kind;
            if (kind == ZarrAxis::Kind::Time && !time)
                time = axis;
            else if (kind == ZarrAxis::Kind::Channel && !channel)
                channel = axis;
            else
                further.push_back(axis);
        }
    if (isGuessed)
        choice.taken.push_back({TakenPart::Places,
                                Message::say("x, y and z along its axes %1, %2 and %3", axisName(axes, (*volume)[0]),
                                             axisName(axes, (*volume)[1]), axisName(axes, (*volume)[2])),
                                true});
    const std::vector<std::string> noNames;
    if (const Status chosen =
            chooseChannel(channel, target.image ? target.image->channelNames : noNames, request.channel, choice);
        !chosen)
        return chosen;
    const ZarrAxis none;
    if (const Status chosen = chooseTime(time, target, time ? axes[*time] : none, request.time, choice); !chosen)
        return chosen;
    return chooseFurther(axes, further, request.index, choice);
}

// Where it lies.

/// One unit for the three axes: that of x, into which the others are converted.
void chooseUnit(const std::vector<ZarrAxis>& axes, ZarrChoice& choice)
{
    std::array<LengthUnit, 3> units;
    for (std::size_t axis = 0; axis < 3; ++axis)
        units[axis] = lengthUnitOf(axes[choice.selection.axes[axis]].unit);
    const bool areOne = units[0].shown == units[1].shown && units[0].shown == units[2].shown;
    const bool areKnown = std::ranges::all_of(units, [](const LengthUnit& unit) { return unit.metres > 0; });
    if (areOne || areKnown)
        choice.lengthUnit = units[0].shown;
    if (areOne)
        return;
    const std::string all = units[0].shown + ", " + units[1].shown + ", " + units[2].shown;
    if (!areKnown) {
        choice.leftOut.push_back(
            Message::say("Its axes x, y and z have different units, or none (%1), which are not converted.", all));
        return;
    }
    for (std::size_t axis = 1; axis < 3; ++axis) {
        choice.lattice.spacing[static_cast<int>(axis)] *= units[axis].metres / units[0].metres;
        choice.lattice.origin[static_cast<int>(axis)] *= units[axis].metres / units[0].metres;
    }
    choice.remarks.push_back(
        Message::say("Its axes x, y and z have different units (%1): all are converted to %2.", all, units[0].shown));
}

Status placeImage(const ZarrTarget& target, ZarrChoice& choice)
{
    const OmeLevel& level = target.image->levels[target.level];
    const bool isPlaced = !level.scale.empty();
    for (std::size_t axis = 0; axis < 3 && isPlaced; ++axis) {
        const auto of = static_cast<int>(axis);
        const double scale = level.scale[choice.selection.axes[axis]];
        if (!(std::abs(scale) > 0))
            return Error{ErrorKind::BadInput, Message::say("its scale along an axis of space is 0. Export it again.")};
        choice.lattice.spacing[of] = std::abs(scale);
        choice.lattice.directions(of, of) = scale < 0 ? -1 : 1;
        choice.lattice.origin[of] = level.translation[choice.selection.axes[axis]];
    }
    chooseUnit(target.image->axes, choice);
    choice.untold = untoldPlacement(isPlaced, isPlaced, !choice.lengthUnit.empty());
    return checkLatticePlacement(choice.lattice);
}

// Attributes of arrays that say more than is used.

void tellAttributes(ZarrChoice& choice)
{
    std::string said;
    for (const char* name : {"scale_factor", "add_offset", "_FillValue", "missing_value", "valid_range", "coordinates"})
        if (choice.array.attributes.contains(QLatin1String(name)))
            said += (said.empty() ? "" : ", ") + std::string(name);
    if (!said.empty())
        choice.leftOut.push_back(Message::say("Its attributes %1 are not used: the stored values are.", said));
}

void tellLargeChunks(ZarrChoice& choice)
{
    constexpr std::uint64_t usual = std::uint64_t(256) << 20U, megabyte = 1'000'000;
    const std::uint64_t bytes = choice.array.chunks.numberCount() * storedSize(choice.array.number);
    if (bytes > usual)
        choice.leftOut.push_back(Message::say(
            "Its chunks are unpacked whole, however little of them is needed, which takes %1 MB of memory.",
            bytes / megabyte));
}

void tellArray(const ZarrRequest& request, ZarrChoice& choice)
{
    const std::string& path = choice.array.path;
    choice.arrayName = printable(path);
    if (path.empty())
        return;
    const bool isChosen = !request.array.empty() && request.array != "automatic";
    choice.taken.push_back({TakenPart::Array, printable(path), !isChosen && choice.arrays.size() > 1});
    if (choice.arrays.size() > 1)
        choice.leftOut.push_back(Message::say("It holds %1 arrays of volumes; the others are not read. Choose one "
                                              "with 'array'.",
                                              choice.arrays.size()));
}

/// The axes of the array, as the image or the array describes them.
Result<std::vector<ZarrAxis>> axesOf(const ZarrTarget& target, const ZarrArray& array)
{
    std::vector<ZarrAxis> axes(array.shape.size());
    if (target.image && target.image->axes.size() != axes.size())
        return Error{ErrorKind::BadInput, Message::say("its level '%1' has %2 axes, and it describes %3. Export it "
                                                       "again.",
                                                       printable(target.path), axes.size(), target.image->axes.size())};
    if (target.image)
        return target.image->axes;
    for (std::size_t axis = 0; axis < array.axisNames.size(); ++axis)
        axes[axis] = zarrAxisOfName(array.axisNames[axis]);
    return axes;
}

} // namespace

Result<ZarrChoice> chooseZarr(const ZarrFolder& folder, const ZarrRequest& request)
{
    ZarrChoice choice;
    const auto target = chooseTarget(folder, request, choice);
    if (!target)
        return target.error();
    const auto node = zarrNode(folder, target->path);
    if (!node)
        return node.error();
    if (node->kind != ZarrNode::Kind::Array)
        return Error{ErrorKind::BadInput, Message::say("its level '%1' is missing. The copy is not complete: copy the "
                                                       "folder again, or choose another level with 'part'.",
                                                       printable(target->path))};
    auto array = zarrArray(target->path, *node);
    if (!array)
        return array.error();
    choice.array = *std::move(array);
    const auto axes = axesOf(*target, choice.array);
    if (!axes)
        return axes.error();
    if (const Status chosen = chooseVolume(request, *target, *axes, choice); !chosen)
        return chosen.error();
    choice.untold = untoldPlacement(false, false, false);
    if (!target->image)
        tellArray(request, choice);
    else if (const Status placed = placeImage(*target, choice); !placed)
        return placed.error();
    tellAttributes(choice);
    tellLargeChunks(choice);
    if (const Status fits = checkUntold(request.given, choice.untold); !fits)
        return fits.error();
    std::ranges::stable_sort(choice.taken, {}, &Taken::part);
    return choice;
}

} // namespace tetra
