// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://imaris.oxinst.com/support/imaris-file-format
#include "plugins/readers/hdf5/helper/imaris_picture.h"

#include "plugins/api/time_steps.h"
#include "plugins/readers/hdf5/helper/array_axes.h"
#include "plugins/readers/hdf5/helper/attributes.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

constexpr const char* imarisImage = "/DataSetInfo/Image";

std::string imarisPath(const ImarisPlace& place)
{
    return "/DataSet/ResolutionLevel " + std::to_string(place.level) + "/TimePoint " + std::to_string(place.time) +
           "/Channel " + std::to_string(place.channel) + "/Data";
}

std::optional<double> imarisNumber(hid_t object, const std::string& name)
{
    return parseNumber<double>(attributeLetters(object, name.c_str()));
}

/// "3 of 5, DAPI".
Message withName(std::uint64_t number, std::uint64_t count, const std::string& name)
{
    const Message which = Message::say("%1 of %2", number, count);
    return name.empty() ? which : Message::say("%1, %2", which, printable(name));
}

} // namespace

std::optional<ImarisPlace> imarisPlace(const std::string& path)
{
    std::string_view rest = path;
    const auto number = [&](std::string_view before) -> std::optional<std::uint64_t> {
        if (!rest.starts_with(before))
            return std::nullopt;
        rest.remove_prefix(before.size());
        const auto digits = rest.substr(0, rest.find('/'));
        rest.remove_prefix(digits.size());
        return parseNumber<std::uint64_t>(digits);
    };
    const auto level = number("/DataSet/ResolutionLevel ");
    const auto time = level ? number("/TimePoint ") : std::nullopt;
    const auto channel = time ? number("/Channel ") : std::nullopt;
    return channel && rest == "/Data" ? std::optional(ImarisPlace{*level, *time, *channel}) : std::nullopt;
}

std::optional<ImarisPicture> imarisPictureOf(const Hdf5Listing& listing)
{
    ImarisPicture picture;
    const auto most = std::uint64_t(listing.arrays.size()); // numbers that are larger count nothing
    for (const Hdf5Array& array : listing.arrays)
        if (const auto place = imarisPlace(array.path);
            place && place->level < most && place->time < most && place->channel < most) {
            picture.levels = std::max(picture.levels, place->level + 1);
            picture.times = std::max(picture.times, place->time + 1);
            picture.channels = std::max(picture.channels, place->channel + 1);
        }
    return picture.levels == 0 ? std::nullopt : std::optional(picture);
}

Result<Hdf5Request> requestInImaris(const ImarisPicture& picture, const Hdf5Request& request)
{
    if (!isAutomatic(request))
        return request;
    if (request.timeStep < 1 || std::uint64_t(request.timeStep) > picture.times)
        return noSuchTimeStep(picture.times, request.timeStep);
    const auto channel =
        request.channel.empty() ? std::optional<std::uint64_t>(1) : parseNumber<std::uint64_t>(request.channel);
    if (!channel || *channel < 1 || *channel > picture.channels)
        return noSuchNumber(Message::say("channels"), picture.channels, request.channel, "channel");
    Hdf5Request asked = request;
    asked.array = imarisPath({0, std::uint64_t(request.timeStep) - 1, *channel - 1});
    asked.timeStep = 1; // each is an array of its own
    asked.channel.clear();
    return asked;
}

std::vector<std::uint64_t> imarisSize(hid_t file, const Hdf5Array& array)
{
    std::vector<std::uint64_t> size = array.size;
    if (!imarisPlace(array.path) || size.size() != 3)
        return size;
    constexpr std::array<const char*, 3> names{"ImageSizeZ", "ImageSizeY", "ImageSizeX"};
    const Hdf5Id channel = openGroup(file, array.path.substr(0, array.path.rfind('/')));
    for (std::size_t dimension = 0; channel && dimension < 3; ++dimension) {
        const auto voxels = parseNumber<std::uint64_t>(attributeLetters(channel, names[dimension]));
        if (voxels && *voxels >= 1)
            size[dimension] = std::min(size[dimension], *voxels);
    }
    return size;
}

std::optional<ImarisFrame> imarisFrameOf(hid_t file, const Hdf5Array& array)
{
    const Hdf5Id image = openGroup(file, imarisImage);
    const std::vector<std::uint64_t> size = imarisSize(file, array);
    if (!imarisPlace(array.path) || !image || size.size() != 3)
        return std::nullopt;
    ImarisFrame frame{.origin = {}, .spacing = {}, .unit = attributeLetters(image, "Unit")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto first = imarisNumber(image, "ExtMin" + std::to_string(axis)),
                   last = imarisNumber(image, "ExtMax" + std::to_string(axis));
        if (!first || !last)
            return std::nullopt;
        const auto row = static_cast<Eigen::Index>(axis);
        frame.spacing[row] = (*last - *first) / static_cast<double>(size[2 - axis]);
        frame.origin[row] = *first + frame.spacing[row] / 2;
    }
    const bool isPlace = frame.spacing.allFinite() && frame.origin.allFinite() && frame.spacing.minCoeff() > 0;
    return isPlace ? std::optional(std::move(frame)) : std::nullopt;
}

void tellImaris(hid_t file, const ImarisPicture& picture, const Hdf5Array& array, const Hdf5Request& request,
                std::vector<Taken>& taken, std::vector<Message>& leftOut)
{
    const auto place = imarisPlace(array.path);
    if (!place)
        return;
    const bool isAsked = !isAutomatic(request);
    if (picture.levels > 1) {
        taken.push_back({TakenPart::Block, Message::say("%1 of 0 to %2", place->level, picture.levels - 1), false});
        leftOut.push_back(
            Message::say("It has %1 levels of detail, 0 being the finest; the others are not read. Choose "
                         "one by its array, such as '%2'.",
                         picture.levels, imarisPath({place->level == 1 ? 0U : 1U, 0, 0})));
    }
    if (picture.channels > 1) {
        const Hdf5Id channel = openGroup(file, "/DataSetInfo/Channel " + std::to_string(place->channel));
        const std::string name = channel ? attributeLetters(channel, "Name") : std::string();
        taken.push_back({TakenPart::Channel, withName(place->channel + 1, picture.channels, name),
                         !isAsked && request.channel.empty()});
    }
    if (picture.times > 1) {
        const Hdf5Id times = openGroup(file, "/DataSetInfo/TimeInfo");
        const std::string when =
            times ? attributeLetters(times, ("TimePoint" + std::to_string(place->time + 1)).c_str()) : std::string();
        taken.push_back(
            {TakenPart::TimeStep, withName(place->time + 1, picture.times, when), !isAsked && !request.timeIsGiven});
    }
}

} // namespace tetra
