// SPDX-License-Identifier: GPL-3.0-or-later
// A series of pictures may hold overviews, echoes, times and copies beside the slices of one volume; what tells them
// apart differs from machine to machine. So pictures of one size and direction are put together, and where several lie
// on one place, they are told apart by the first mark that does it.
#include "plugins/readers/images/dicom/dicom_volumes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace tetra {
namespace {

constexpr double samePlace = 1e-3; ///< of the distance of pixels

const DicomFrame& frameOf(std::span<const DicomHeader> series, const DicomPicture& picture)
{
    return series[picture.file].frames[picture.frame];
}

std::string nameOf(const DicomHeader& header)
{
    return printable(header.path.filename().string());
}

bool isSameDirection(const DicomFrame& a, const DicomFrame& b)
{
    constexpr double roundingOfCosines = 2e-4;
    if (!a.axes || !b.axes)
        return !a.axes && !b.axes;
    return ((*a.axes)[0] - (*b.axes)[0]).cwiseAbs().maxCoeff() < roundingOfCosines &&
           ((*a.axes)[1] - (*b.axes)[1]).cwiseAbs().maxCoeff() < roundingOfCosines;
}

bool isSameSpacing(const DicomFrame& a, const DicomFrame& b)
{
    constexpr double rounding = 1e-4;
    if (!a.pixelSpacing || !b.pixelSpacing)
        return !a.pixelSpacing && !b.pixelSpacing;
    return (*a.pixelSpacing - *b.pixelSpacing).cwiseQuotient(*a.pixelSpacing).cwiseAbs().maxCoeff() < rounding;
}

/// Whether two pictures can be slices of one volume.
bool fitTogether(std::span<const DicomHeader> series, const DicomPicture& a, const DicomPicture& b)
{
    const DicomHeader &first = series[a.file], &second = series[b.file];
    const DicomFrame &one = frameOf(series, a), &other = frameOf(series, b);
    return first.rows == second.rows && first.columns == second.columns && first.samples == second.samples &&
           ((!first.areStacked && !second.areStacked) || a.file == b.file) && one.stack == other.stack &&
           isSameDirection(one, other) && isSameSpacing(one, other);
}

Eigen::Vector3d normalOf(const DicomFrame& frame)
{
    return frame.axes ? (*frame.axes)[0].cross((*frame.axes)[1]).normalized() : Eigen::Vector3d::UnitZ();
}

using Pictures = std::vector<DicomPicture>;

/// Pictures that lie on one place, from `first` on, in order of their places; by the machine's numbers within a place.
struct PlaceRuns {
    Pictures pictures{};
    std::vector<std::size_t> begins{}; ///< of each place in `pictures`

    std::size_t places() const { return begins.size(); }
    std::size_t end(std::size_t place) const { return place + 1 < begins.size() ? begins[place + 1] : pictures.size(); }
    std::size_t most() const
    {
        std::size_t count = 0;
        for (std::size_t place = 0; place < places(); ++place)
            count = std::max(count, end(place) - begins[place]);
        return count;
    }
    std::size_t surplus() const { return pictures.size() - places(); }
};

PlaceRuns runsOf(std::span<const DicomHeader> series, Pictures pictures)
{
    const Eigen::Vector3d normal = normalOf(frameOf(series, pictures.front()));
    const auto spacing = frameOf(series, pictures.front()).pixelSpacing;
    const double tolerance = samePlace * (spacing ? spacing->minCoeff() : 1);
    const auto height = [&](const DicomPicture& picture) { return normal.dot(*frameOf(series, picture).position); };
    const auto number = [&](const DicomPicture& picture) {
        return std::tuple(series[picture.file].number.value_or(0), picture.frame, picture.file);
    };
    std::ranges::sort(pictures, [&](const auto& a, const auto& b) {
        return std::tuple(height(a), number(a)) < std::tuple(height(b), number(b));
    });
    PlaceRuns runs{std::move(pictures)};
    for (std::size_t at = 0; at < runs.pictures.size(); ++at)
        if (at == 0 || height(runs.pictures[at]) - height(runs.pictures[runs.begins.back()]) > tolerance)
            runs.begins.push_back(at);
    for (std::size_t place = 0; place < runs.places(); ++place)
        std::ranges::sort(runs.pictures.begin() + static_cast<std::ptrdiff_t>(runs.begins[place]),
                          runs.pictures.begin() + static_cast<std::ptrdiff_t>(runs.end(place)), {}, number);
    return runs;
}

struct LessMark {
    bool operator()(const std::string& a, const std::string& b) const
    {
        const auto one = parseNumber<double>(a), other = parseNumber<double>(b);
        return one && other && *one != *other ? *one < *other : a < b;
    }
};

Message joined(const Message& name, const Message& more)
{
    return name.empty() ? more : Message::say("%1, %2", name, more);
}

/// The pictures told apart by one mark; nothing if that leaves as many on one place, or makes more volumes than lie on
/// any.
std::vector<DicomVolume> splitBy(std::span<const DicomHeader> series, const DicomVolume& volume, DicomMark mark)
{
    const PlaceRuns whole = runsOf(series, volume.pictures);
    std::map<std::string, Pictures, LessMark> parts;
    for (const DicomPicture& picture : volume.pictures)
        parts[frameOf(series, picture).marks[static_cast<std::size_t>(mark)]].push_back(picture);
    if (parts.size() < 2 || parts.size() > whole.most())
        return {};
    std::vector<DicomVolume> split;
    std::size_t surplus = 0;
    for (auto& [value, pictures] : parts) {
        surplus += runsOf(series, pictures).surplus();
        split.push_back(
            {std::move(pictures), joined(volume.name, Message::say("%1 %2", dicomMarkText(mark), printable(value)))});
    }
    return surplus < whole.surplus() ? split : std::vector<DicomVolume>();
}

/// Where no mark tells them apart, the first picture of each place is of the first volume, and so on.
Result<std::vector<DicomVolume>> dealt(std::span<const DicomHeader> series, const DicomVolume& volume)
{
    const PlaceRuns runs = runsOf(series, volume.pictures);
    const std::size_t count = runs.most();
    for (std::size_t place = 0; place < runs.places(); ++place)
        if (runs.end(place) - runs.begins[place] != count) {
            const auto many = std::ranges::find_if(runs.begins, [&](std::size_t begin) {
                const auto next = std::ranges::upper_bound(runs.begins, begin);
                return (next == runs.begins.end() ? runs.pictures.size() : *next) - begin > 1;
            });
            const DicomHeader &one = series[runs.pictures[*many].file], &other = series[runs.pictures[*many + 1].file];
            return Error{
                ErrorKind::BadInput,
                Message::say("%1 pictures of its series lie at one place, such as '%2' and '%3', and nothing tells "
                             "which of them belong together. Put the slices of one volume alone into a folder.",
                             count, nameOf(one), nameOf(other))};
        }
    std::vector<DicomVolume> volumes(count);
    for (std::size_t place = 0; place < runs.places(); ++place)
        for (std::size_t number = 0; number < count; ++number)
            volumes[number].pictures.push_back(runs.pictures[runs.begins[place] + number]);
    for (std::size_t number = 0; number < count; ++number) {
        volumes[number].name = joined(volume.name, Message::say("number %1 of each place", number + 1));
        volumes[number].isGuessed = true;
    }
    return volumes;
}

/// Pictures with positions, each volume along its normal.
Result<std::vector<DicomVolume>> placedVolumes(std::span<const DicomHeader> series, Pictures pictures)
{
    std::vector<DicomVolume> volumes = {{std::move(pictures)}};
    for (std::size_t mark = 0; mark < dicomMarks; ++mark) {
        std::vector<DicomVolume> next;
        for (DicomVolume& volume : volumes) {
            auto split = runsOf(series, volume.pictures).surplus() > 0
                             ? splitBy(series, volume, static_cast<DicomMark>(mark))
                             : std::vector<DicomVolume>();
            if (split.empty())
                split.push_back(std::move(volume));
            std::ranges::move(split, std::back_inserter(next));
        }
        volumes = std::move(next);
    }
    std::vector<DicomVolume> all;
    for (DicomVolume& volume : volumes) {
        PlaceRuns runs = runsOf(series, volume.pictures);
        if (runs.surplus() == 0) {
            volume.pictures = std::move(runs.pictures);
            all.push_back(std::move(volume));
            continue;
        }
        auto more = dealt(series, volume);
        if (!more)
            return more.error();
        std::ranges::move(*more, std::back_inserter(all));
    }
    return all;
}

/// Pictures without: by SliceLocation if each has its own, else in the order of their numbers.
DicomVolume unplacedVolume(std::span<const DicomHeader> series, Pictures pictures)
{
    std::set<double> heights;
    for (const DicomPicture& picture : pictures)
        if (const auto height = frameOf(series, picture).height)
            heights.insert(*height);
    const bool byHeight = heights.size() == pictures.size();
    const auto key = [&](const DicomPicture& picture) {
        return std::tuple(byHeight ? *frameOf(series, picture).height : 0, series[picture.file].number.value_or(0),
                          picture.frame, series[picture.file].path);
    };
    std::ranges::sort(pictures, {}, key);
    return {std::move(pictures)};
}

Result<std::vector<DicomVolume>> volumesOfClass(std::span<const DicomHeader> series, Pictures pictures)
{
    const auto isPlaced = [&](const DicomPicture& picture) {
        return !series[picture.file].areStacked && frameOf(series, picture).position.has_value();
    };
    if (std::ranges::all_of(pictures, isPlaced))
        return placedVolumes(series, std::move(pictures));
    if (const auto placed = std::ranges::find_if(pictures, isPlaced); placed != pictures.end()) {
        const auto unplaced = std::ranges::find_if_not(pictures, isPlaced);
        return Error{ErrorKind::BadInput,
                     Message::say("the file '%1' of its series does not say where it lies (ImagePositionPatient), and "
                                  "others do. Take it out of the folder, or export the series again.",
                                  nameOf(series[unplaced->file]))};
    }
    return std::vector<DicomVolume>{unplacedVolume(series, std::move(pictures))};
}

/// Files that are there twice are taken once.
std::vector<bool> copiesAmong(std::span<const DicomHeader> series, std::size_t opened)
{
    std::vector<bool> isCopy(series.size());
    std::map<std::string, std::size_t> first;
    if (!series[opened].instance.empty())
        first[series[opened].instance] = opened;
    for (std::size_t file = 0; file < series.size(); ++file)
        if (const std::string& instance = series[file].instance; !instance.empty())
            isCopy[file] = first.emplace(instance, file).first->second != file;
    return isCopy;
}

Error singlePicture(std::span<const DicomHeader> series, const std::vector<Pictures>& classes)
{
    const auto largest = std::ranges::max_element(classes, {}, &Pictures::size);
    if (largest->size() < 2)
        return {ErrorKind::BadInput,
                Message::say("it is a single picture, and no other slices of its series are next to it. TAn reads "
                             "volumes: put the files of the series into one folder and open one of them.")};
    return {ErrorKind::BadInput,
            Message::say("it is a single picture of another size or direction than the %1 slices of its series. Open "
                         "one of these, such as '%2'.",
                         largest->size(), nameOf(series[largest->front().file]))};
}

} // namespace

Result<DicomVolumes> volumesOf(std::span<const DicomHeader> series, std::size_t opened)
{
    DicomVolumes found;
    const std::vector<bool> isCopy = copiesAmong(series, opened);
    found.copies = static_cast<std::size_t>(std::ranges::count(isCopy, true));
    std::vector<Pictures> classes; // the opened file's first
    const auto add = [&](std::size_t file) {
        for (std::size_t frame = 0; frame < series[file].frames.size(); ++frame) {
            const DicomPicture picture{file, frame};
            const auto fitting = std::ranges::find_if(
                classes, [&](const Pictures& pictures) { return fitTogether(series, pictures.front(), picture); });
            if (fitting == classes.end())
                classes.push_back({picture});
            else
                fitting->push_back(picture);
        }
    };
    add(opened);
    for (std::size_t file = 0; file < series.size(); ++file)
        if (file != opened && !isCopy[file])
            add(file);
    if (classes.front().size() < 2)
        return singlePicture(series, classes);
    for (std::size_t number = 0; number < classes.size(); ++number) {
        const std::size_t count = classes[number].size();
        auto volumes = count < 2 ? Result<std::vector<DicomVolume>>(std::vector<DicomVolume>())
                                 : volumesOfClass(series, std::move(classes[number]));
        if (!volumes && number == 0)
            return volumes.error();
        if (!volumes || count < 2) {
            found.others += count;
            continue;
        }
        for (DicomVolume& volume : *volumes) {
            if (volume.pictures.size() < 2) {
                found.others += volume.pictures.size();
                continue;
            }
            if (number > 0)
                volume.name = joined(Message::say("of another size or direction"), volume.name);
            const bool isOpened = number == 0 && std::ranges::any_of(volume.pictures, [&](const DicomPicture& picture) {
                                      return picture.file == opened && picture.frame == 0;
                                  });
            if (isOpened)
                found.opened = found.volumes.size();
            found.volumes.push_back(std::move(volume));
        }
    }
    if (found.volumes.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("all pictures of its series lie at one place. TAn reads volumes: it needs slices.")};
    return found;
}

} // namespace tetra
