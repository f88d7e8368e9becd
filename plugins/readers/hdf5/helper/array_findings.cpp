// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/array_findings.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/process_limits.h"
#include "plugins/readers/hdf5/helper/array_axes.h"
#include "plugins/readers/hdf5/helper/array_places.h"
#include "plugins/readers/hdf5/helper/array_values.h"
#include "plugins/readers/hdf5/helper/attributes.h"
#include "plugins/readers/hdf5/helper/hdf5_arrays.h"
#include "plugins/readers/hdf5/helper/imaris_picture.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace tetra {
namespace {

/// An array with all that is taken of it but its values.
struct PlacedArray {
    Hdf5Array array;
    ArrayAxes axes{};
    ArrayPart part{};
    StoredMeaning meaning{};
    ArrayPlaces places{};
    std::optional<ImarisPicture> imaris{}; ///< of which it is one array
    std::vector<Taken> taken{};
    std::vector<Message> leftOut{};
};

/// From here on this process may take what the array needs, if the machine has it.
Status allowMemory(const Hdf5Array& array, const ArrayPart& part, std::uint64_t bytes)
{
    constexpr std::uint64_t usualPacking = 20; // times more that packed data become, at most
    const std::uint64_t needed = neededBytes(array, part);
    const WorkLimits limits = limitsFor(bytes, std::max(usualPacking * bytes, needed), physicalBytes());
    if (needed > limits.memory)
        return Error{ErrorKind::OutOfResource,
                     Message::say("its array %1 needs %2 of memory, and this machine can spare %3. Write a part of "
                                  "it, or one with fewer points.",
                                  arrayText(array), neededBytesText(needed), neededBytesText(limits.memory))};
    limitWork(limits);
    return {};
}

std::string unitOf(hid_t file, const Hdf5Array& array)
{
    return attributeText(openArray(file, array.path), "units");
}

/// Attributes of the array, or of its group, that change what its numbers mean, and that nothing is done about.
void tellUnused(hid_t file, const Hdf5Array& array, std::vector<Message>& leftOut)
{
    constexpr std::array<const char*, 7> ofArray = {"valid_range", "valid_min",      "valid_max", "MissingValue",
                                                    "ScaleFactor", "scaling_factor", "_Unsigned"};
    const std::string parent = array.path.substr(0, std::max<std::size_t>(1, array.path.rfind('/')));
    const Hdf5Id opened = openArray(file, array.path), group = openGroup(file, parent);
    for (const char* name : ofArray)
        if ((opened && hasAttribute(opened, name)) || (group && hasAttribute(group, name)))
            leftOut.push_back(Message::say("It has an attribute '%1', which is not used.", name));
}

void tellChoices(hid_t file, const Hdf5Listing& listing, bool isGuess, PlacedArray& placed)
{
    std::vector<const Hdf5Array*> others;
    for (const Hdf5Array& array : listing.arrays)
        if (isVolume(array) && array.path != placed.array.path && !(placed.imaris && imarisPlace(array.path)))
            others.push_back(&array);
    if (!others.empty()) {
        placed.taken.push_back({TakenPart::Array, Message(printable(placed.array.path)), isGuess});
        placed.leftOut.push_back(Message::say("It holds other arrays, which are not read: %1.", arraysText(others)));
    }
    const auto add = [&](const std::vector<Taken>& taken) {
        placed.taken.insert(placed.taken.end(), taken.begin(), taken.end());
    };
    add(placed.part.taken);
    add(placed.places.taken);
    if (const std::string unit = unitOf(file, placed.array); !unit.empty() && unit != "1")
        placed.taken.push_back({TakenPart::Unit, Message(printable(unit)), false});
    if (placed.meaning.fill)
        placed.taken.push_back(*placed.meaning.fill);
    std::ranges::stable_sort(placed.taken, {}, &Taken::part);
    placed.leftOut.insert(placed.leftOut.end(), placed.places.leftOut.begin(), placed.places.leftOut.end());
    tellUnused(file, placed.array, placed.leftOut);
    placed.leftOut.insert(placed.leftOut.end(), listing.leftOut.begin(), listing.leftOut.end());
}

Result<PlacedArray> placedArray(hid_t file, const Hdf5Listing& listing, std::uint64_t bytes, const Hdf5Request& request)
{
    const auto imaris = imarisPictureOf(listing);
    const auto asked = imaris ? requestInImaris(*imaris, request) : Result<Hdf5Request>(request);
    if (!asked)
        return asked.error();
    const auto chosen = chooseArray(file, listing, *asked);
    if (!chosen)
        return chosen.error();
    PlacedArray placed{.array = *chosen->array};
    if (imarisPlace(placed.array.path))
        placed.imaris = imaris;
    auto meaning = storedMeaning(file, placed.array);
    if (!meaning)
        return meaning.error();
    placed.array.size = imarisSize(file, placed.array);
    auto axes = axesOf(file, placed.array);
    if (!axes)
        return axes.error();
    auto part = partOf(placed.array, *axes, *asked);
    if (!part)
        return part.error();
    if (const Status allowed = allowMemory(placed.array, *part, bytes); !allowed)
        return allowed.error();
    auto places = placesOf(file, placed.array, *axes);
    if (!places)
        return places.error();
    if (const Status fits = checkUntold(request.given, places->untold); !fits)
        return fits.error();
    placed.meaning = *std::move(meaning);
    placed.axes = *std::move(axes);
    placed.part = *std::move(part);
    placed.places = *std::move(places);
    if (placed.imaris)
        tellImaris(file, *placed.imaris, placed.array, request, placed.taken, placed.leftOut);
    tellChoices(file, listing, chosen->isGuess, placed);
    return placed;
}

} // namespace

Result<FileFindings> arrayFindings(hid_t file, std::uint64_t bytes, const Hdf5Request& request,
                                   const std::function<void(double)>& progress)
{
    auto placed = placedArray(file, listingOf(file), bytes, request);
    if (!placed)
        return placed.error();
    auto samples = readSamples(file, placed->array, placed->axes, placed->part, placed->meaning, progress);
    if (!samples)
        return samples.error();
    ArrayPlaces& places = placed->places;
    FileFindings found;
    found.kind = places.isLattice ? FoundKind::Lattice : FoundKind::Grid;
    found.lattice = places.lattice;
    found.space = places.space;
    found.lengthUnit = places.lengthUnit;
    found.untold = std::move(places.untold);
    if (!places.isLattice)
        found.positions = positionsOf(places);
    found.type = samples->type;
    found.samples = std::move(samples->samples);
    found.arrayName = placed->array.path;
    found.remarks = std::move(places.remarks);
    std::ranges::move(samples->remarks, std::back_inserter(found.remarks));
    found.taken = std::move(placed->taken);
    found.leftOut = std::move(placed->leftOut);
    return found;
}

Result<FileContents> arrayContents(hid_t file, std::uint64_t bytes, const Hdf5Request& request)
{
    const Hdf5Listing listing = listingOf(file);
    auto placed = placedArray(file, listing, bytes, request);
    if (!placed)
        return placed.error();
    const ArrayAxes& axes = placed->axes;
    FileContents contents;
    contents.domain = placed->places.isLattice ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    contents.lattice = placed->places.lattice;
    contents.points = contents.lattice.pointCount();
    contents.type = sampleTypeOf(placed->meaning, placed->array, placed->part);
    for (const Hdf5Array& array : listing.arrays)
        if (isVolume(array)) {
            const bool isTaken = array.path == placed->array.path;
            contents.arrays.push_back(
                {.name = array.path,
                 .components = static_cast<int>(isTaken ? placed->part.components : array.element.components),
                 .unit = unitOf(file, array)});
        }
    constexpr std::uint64_t mostListed = 100'000;
    const bool isImaris = placed->imaris.has_value();
    const std::uint64_t steps = isImaris ? placed->imaris->times : axes.time ? placed->array.size[*axes.time] : 0;
    for (std::uint64_t step = 0; step < std::min(steps, mostListed); ++step)
        contents.timeSteps.push_back(axes.time && axes.says[*axes.time].values ? (*axes.says[*axes.time].values)[step]
                                                                               : static_cast<double>(step));
    const std::uint64_t channels = isImaris       ? placed->imaris->channels
                                   : axes.channel ? placed->array.size[*axes.channel]
                                                  : 0;
    for (std::uint64_t channel = 0; channel < std::min(channels, mostListed); ++channel)
        contents.channels.push_back(std::to_string(channel + 1));
    contents.untold = std::move(placed->places.untold);
    contents.taken = std::move(placed->taken);
    contents.leftOut = std::move(placed->leftOut);
    return contents;
}

} // namespace tetra
