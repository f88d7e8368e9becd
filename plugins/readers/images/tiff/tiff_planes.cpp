// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/tiff/tiff_planes.h"

#include "plugins/api/time_steps.h"
#include "plugins/readers/images/slice_names.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace tetra {
namespace {

namespace fs = std::filesystem;

std::string quotedList(const std::vector<std::string>& names)
{
    constexpr std::size_t mostNamed = 20;
    std::string list;
    for (std::size_t at = 0; at < std::min(mostNamed, names.size()); ++at)
        list += (at == 0 ? "'" : ", '") + printable(names[at]) + "'";
    return names.size() > mostNamed ? list + " ..." : list;
}

/// The number from 0 of what is asked for by a number from 1 or a name.
Result<std::uint64_t> chosenOf(const std::string& wanted, std::uint64_t count, const std::vector<std::string>& names,
                               const char* parameter)
{
    const auto named = std::ranges::find(names, wanted);
    if (named != names.end())
        return static_cast<std::uint64_t>(named - names.begin());
    const auto number = parseNumber<std::uint64_t>(wanted);
    if (number && *number >= 1 && *number <= count)
        return *number - 1;
    if (count == 1)
        return Error{ErrorKind::WrongUsage, Message::say("it has no '%1' for '%2', and nothing to choose from. Leave "
                                                         "'%2' out.",
                                                         printable(wanted), parameter)};
    if (names.empty())
        return Error{ErrorKind::WrongUsage, Message::say("it has no '%1' for '%2'. Choose one from 1 to %3.",
                                                         printable(wanted), parameter, count)};
    return Error{ErrorKind::WrongUsage, Message::say("it has no '%1' for '%2'. Choose one from 1 to %3, or by its "
                                                     "name: %4.",
                                                     printable(wanted), parameter, count, quotedList(names))};
}

std::vector<std::string> namesOf(std::uint64_t count, const std::vector<std::string>& names)
{
    constexpr std::uint64_t mostNamed = 1000;
    std::vector<std::string> all;
    for (std::uint64_t number = 0; count > 1 && number < std::min(count, mostNamed); ++number)
        all.push_back(number < names.size() ? printable(names[number]) : std::to_string(number + 1));
    return all;
}

enum class ChosenBy : std::uint8_t { User, File, Nobody };

void tellChannel(std::uint64_t channel, std::uint64_t count, const std::vector<std::string>& names, ChosenBy by,
                 TiffPlanes& planes)
{
    if (count < 2)
        return;
    const Message which = Message::say("%1 of %2", channel + 1, count);
    planes.channels = namesOf(count, names);
    planes.taken.push_back({TakenPart::Channel,
                            channel < names.size() ? Message::say("%1, %2", which, printable(names[channel])) : which,
                            by == ChosenBy::Nobody});
    planes.leftOut.push_back(
        by == ChosenBy::User
            ? Message::say("It has %1 channels; the others are not read.", count)
            : Message::say("It has %1 channels; the others are not read. Choose one with 'channel'.", count));
}

/// "2 of 5, 30 s" where the time between two is told.
Message timeText(std::uint64_t time, std::uint64_t count, const PictureDescription& description)
{
    const Message which = Message::say("%1 of %2", time + 1, count);
    return description.betweenTimes ? Message::say("%1, %2 %3", which, formatNumber(description.atTime(time)),
                                                   printable(description.timeUnit))
                                    : which;
}

void tellTime(std::uint64_t time, std::uint64_t count, ChosenBy by, TiffPlanes& planes)
{
    planes.times = count;
    if (count < 2)
        return;
    planes.taken.push_back({TakenPart::TimeStep, timeText(time, count, planes.description), by == ChosenBy::Nobody});
    planes.leftOut.push_back(
        by == ChosenBy::User
            ? Message::say("It has %1 time steps; the others are not read.", count)
            : Message::say("It has %1 time steps; the others are not read. Choose one with '--time'.", count));
}

Result<std::uint64_t> chosenTime(std::int64_t wanted, std::uint64_t count)
{
    if (wanted > 0 && static_cast<std::uint64_t>(wanted) > count)
        return noSuchTimeStep(count, wanted);
    return wanted > 0 ? static_cast<std::uint64_t>(wanted - 1) : 0;
}

Error oneSlice(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("it holds one slice%1, and TAn reads volumes. Put the slices of one volume "
                         "as numbered files into a folder, or as pages into one file.",
                         what)};
}

/// Pictures that are called times and are as many as a volume has slices: programs that know no slices call them so.
void takeTimesAsSlices(TiffPlanes& planes)
{
    PictureDescription& description = planes.description;
    if (description.slices > 1 || description.times < 2)
        return;
    std::swap(description.slices, description.times);
    std::swap(description.sliceStep, description.timeStep);
    planes.taken.push_back({TakenPart::Frame, Message::say("its %1 times as slices", description.slices), true});
}

/// Where OME says that the planes lie which are asked for: page and file of each.
Status findOmePages(const fs::path& path, std::size_t pages, const std::vector<std::uint64_t>& wanted,
                    TiffPlanes& planes)
{
    constexpr std::size_t notFound = ~std::size_t(0);
    std::map<std::uint64_t, std::size_t> sliceOf;
    for (std::size_t slice = 0; slice < wanted.size(); ++slice)
        sliceOf[wanted[slice]] = slice;
    planes.slices.assign(wanted.size(), {notFound, 0});
    std::map<std::string, std::size_t> fileNumbers = {{"", 0}};
    std::uint64_t work = 0;
    for (const OmePlanes& part : planes.description.planes) {
        const std::uint64_t all = planes.description.planeCount() - part.firstPlane;
        const std::uint64_t count = std::min(part.count == 0 ? std::min<std::uint64_t>(all, pages) : part.count, all);
        work += count;
        if (work > mostPlanes)
            return Error{
                ErrorKind::BadInput,
                Message::say("its OME description lists each plane many times. The file is damaged: export it again.")};
        for (auto at = sliceOf.lower_bound(part.firstPlane); at != sliceOf.end() && at->first < part.firstPlane + count;
             ++at) {
            const auto [file, isNew] = fileNumbers.emplace(part.file, planes.files.size());
            if (isNew)
                planes.files.push_back(path.parent_path() / part.file);
            planes.slices[at->second] = {file->second, part.firstPage + (at->first - part.firstPlane)};
        }
    }
    const auto lacking = std::ranges::find(planes.slices, notFound, &TiffPlane::file);
    if (lacking != planes.slices.end())
        return Error{ErrorKind::BadInput,
                     Message::say("its OME description does not tell where slice %1 is. Export the file again.",
                                  lacking - planes.slices.begin() + 1)};
    return {};
}

/// The planes of the channel and the time that are asked for.
Result<std::vector<std::uint64_t>> choosePlanes(const ImagesRequest& request, TiffPlanes& planes)
{
    takeTimesAsSlices(planes);
    const std::vector<Taken> frame = std::exchange(planes.taken, {});
    const PictureDescription& description = planes.description;
    if (description.slices < 2)
        return oneSlice(description.channels > 1 ? Message::say(" of each of its %1 channels", description.channels)
                                                 : Message());
    const auto channel = request.channel.empty()
                             ? Result<std::uint64_t>(0)
                             : chosenOf(request.channel, description.channels, description.channelNames, "channel");
    if (!channel)
        return channel.error();
    const auto time = chosenTime(request.time, description.times);
    if (!time)
        return time.error();
    tellChannel(*channel, description.channels, description.channelNames,
                request.channel.empty() ? ChosenBy::Nobody : ChosenBy::User, planes);
    tellTime(*time, description.times, request.time == 0 ? ChosenBy::Nobody : ChosenBy::User, planes);
    planes.taken.insert(planes.taken.end(), frame.begin(), frame.end());
    std::vector<std::uint64_t> wanted;
    for (std::uint64_t slice = 0; slice < description.slices; ++slice)
        wanted.push_back(description.plane(*channel, slice, *time));
    return wanted;
}

Result<TiffPlanes> omePlanes(const fs::path& path, const TiffFile& file, const ImagesRequest& request)
{
    TiffPlanes planes;
    planes.files = {path};
    planes.hasDescription = true;
    const std::string name = path.filename().string();
    auto description = omeDescription(file.texts().description, 0, name);
    if (!description)
        return description.error();
    std::uint64_t image = 0;
    if (!request.series.empty()) {
        const auto chosen = chosenOf(request.series, description->images.size(), description->images, "series");
        if (!chosen)
            return chosen.error();
        image = *chosen;
        if (description = omeDescription(file.texts().description, image, name); !description)
            return description.error();
    }
    planes.description = *std::move(description);
    const auto wanted = choosePlanes(request, planes);
    if (!wanted)
        return wanted.error();
    if (const auto& images = planes.description.images; images.size() > 1) {
        planes.series = namesOf(images.size(), images);
        planes.taken.insert(planes.taken.begin(),
                            {TakenPart::Series,
                             Message::say("%1 of %2: %3", image + 1, images.size(), printable(images[image])),
                             request.series.empty()});
        planes.leftOut.push_back(
            request.series.empty()
                ? Message::say("It holds %1 images; the others are not read. Choose one with 'series'.", images.size())
                : Message::say("It holds %1 images; the others are not read.", images.size()));
    }
    if (planes.description.planes.empty())
        for (const std::uint64_t plane : *wanted)
            planes.slices.push_back({0, plane});
    else if (const Status found = findOmePages(path, file.pages().size(), *wanted, planes); !found)
        return found.error();
    return planes;
}

/// ImageJ writes one page for all slices where the file would be larger than 4 GB.
Result<TiffPlanes> imageJPlanes(const fs::path& path, const TiffFile& file, const ImagesRequest& request,
                                TiffPlanes planes)
{
    const TiffPage& first = file.pages().front();
    const std::uint64_t count = planes.description.planeCount(), pages = file.pages().size();
    if (pages == 1 && count > 1) {
        const std::uint64_t pageBytes =
            std::uint64_t(first.samples.width) * first.samples.height * (first.samples.bits / 8);
        if (!first.pixelsAt || *first.pixelsAt > file.bytes() ||
            count > (file.bytes() - *first.pixelsAt) / std::max<std::uint64_t>(1, pageBytes))
            return Error{ErrorKind::BadInput, Message::say("ImageJ's description claims %1 slices, but some of their "
                                                           "pixels are missing. It is cut short: copy the file again.",
                                                           count)};
    } else if (count != pages) {
        planes.leftOut.push_back(Message::say(
            "ImageJ's description lists %1 planes, and there are %2 pages; each is read as a slice.", count, pages));
        planes.description.channels = planes.description.times = 1;
        planes.description.slices = pages;
        planes.description.sliceStep = 1;
    }
    planes.files = {path};
    const auto wanted = choosePlanes(request, planes);
    if (!wanted)
        return wanted.error();
    for (const std::uint64_t plane : *wanted)
        planes.slices.push_back({0, plane});
    return planes;
}

/// Where the numbers of files lack some: the gaps stay, by the heights of the others.
void keepGaps(const SliceFiles& stack, TiffPlanes& planes)
{
    constexpr std::size_t mostTold = 12;
    std::uint64_t step = 0;
    for (std::size_t slice = 1; slice < stack.numbers.size(); ++slice)
        step = std::gcd(step, stack.numbers[slice] - stack.numbers[slice - 1]);
    const std::uint64_t missing =
        (stack.numbers.back() - stack.numbers.front()) / std::max<std::uint64_t>(1, step) + 1 - stack.numbers.size();
    if (missing == 0)
        return;
    if (missing > stack.numbers.size()) { // numbers that count something else
        planes.leftOut.push_back(Message::say(
            "The numbers of its files, from %1 to %2, are not consecutive; the slices are taken to be evenly spaced.",
            stack.numbers.front(), stack.numbers.back()));
        return;
    }
    std::string told;
    std::size_t count = 0;
    for (std::size_t slice = 0; slice < stack.numbers.size(); ++slice) {
        planes.heights.push_back(static_cast<double>((stack.numbers[slice] - stack.numbers.front()) / step));
        for (std::uint64_t number = slice == 0 ? stack.numbers[0] : stack.numbers[slice - 1] + step;
             number < stack.numbers[slice]; number += step)
            if (count++ < mostTold)
                told += (told.empty() ? "" : ", ") + std::to_string(number);
    }
    if (count > mostTold)
        told += " ...";
    planes.remarks.push_back(Message::say("Slices are missing among its numbered files: %1 (%2). The gaps stay, and "
                                          "values are interpolated over them.",
                                          missing, told));
}

Result<TiffPlanes> filePlanes(const fs::path& path, const ImagesRequest& request, TiffPlanes planes)
{
    SliceFiles stack = sliceFiles(path);
    std::optional<std::size_t> channel, time;
    if (!request.channel.empty()) {
        const auto chosen =
            chosenOf(request.channel, std::max<std::size_t>(1, stack.channels.size()), stack.channels, "channel");
        if (!chosen)
            return chosen.error();
        channel = *chosen;
    }
    if (request.time > 0) {
        const auto chosen = chosenTime(request.time, std::max<std::size_t>(1, stack.times.size()));
        if (!chosen)
            return chosen.error();
        time = *chosen;
    }
    if (channel || time)
        stack = sliceFiles(path, channel, time);
    if (stack.files.size() < 2)
        return oneSlice(Message());
    tellChannel(stack.channel, stack.channels.size(), stack.channels, channel ? ChosenBy::User : ChosenBy::File,
                planes);
    tellTime(stack.time, stack.times.size(), time ? ChosenBy::User : ChosenBy::File, planes);
    planes.files = std::move(stack.files);
    for (std::size_t file = 0; file < planes.files.size(); ++file)
        planes.slices.push_back({file, 0});
    keepGaps(stack, planes);
    return planes;
}

} // namespace

Result<TiffPlanes> tiffPlanes(const fs::path& path, const TiffFile& file, const ImagesRequest& request)
{
    const std::string& text = file.texts().description;
    if (isOmeDescription(text))
        return omePlanes(path, file, request);
    TiffPlanes planes;
    planes.hasDescription = isImageJDescription(text);
    if (planes.hasDescription)
        planes.description = imageJDescription(text, file.texts().pixelsPerUnit, file.texts().resolutionUnit != 1);
    if (planes.hasDescription && (planes.description.planeCount() > 1 || file.pages().size() > 1))
        return imageJPlanes(path, file, request, std::move(planes));
    for (std::size_t page = 0; page < file.pages().size(); ++page)
        if (!file.pages()[page].isReduced)
            planes.slices.push_back({0, page});
    if (planes.slices.size() < 2) {
        planes.slices.clear();
        return filePlanes(path, request, std::move(planes));
    }
    planes.files = {path};
    if (const std::size_t beside = sliceFiles(path).files.size(); beside > 1)
        planes.leftOut.push_back(Message::say(
            "It has pages of its own; the %1 files next to it with the same kind of number are not read.", beside - 1));
    return planes;
}

} // namespace tetra
