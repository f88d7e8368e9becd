// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored/stored_volume.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/api/time_steps.h"
#include "plugins/readers/lattice/headers/header_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tetra {

namespace {

constexpr const char* magnitudeName = "magnitude";

/// Empty if the text can be a component: "magnitude" or a whole number from 0.
Message componentMistake(const std::string& text)
{
    const bool isNumber = !text.empty() && text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
    return text == magnitudeName || isNumber
               ? Message()
               : Message::say("Give '%1', or the number of a component from 0.", magnitudeName);
}

std::string choiceText(const ParameterValues& values, const std::string& id)
{
    return std::string(trimmed(parameterValue<std::string>(volumeChoices(), values, id)));
}

/// Names in a row, the first ten of them.
Message namesOf(const std::vector<FileArray>& arrays)
{
    constexpr std::size_t mostNames = 10;
    Message names;
    for (std::size_t i = 0; i < std::min(arrays.size(), mostNames); ++i) {
        const std::string name = printable(arrays[i].name);
        names = names.empty() ? Message(name) : Message::say("%1, %2", names, name);
    }
    return arrays.size() > mostNames ? Message::say("%1 ...", names) : names;
}

/// Whether floats cannot tell scaled numbers apart: those of wide types, and of others where the intercept is so large
/// that a step of the slope is lost beside it.
bool needsDouble(const StoredVolume& volume)
{
    constexpr double largestShort = 65535, roundingOfFloat = 1.0 / (1 << 24), partOfStep = 1.0 / 128;
    if (storedSize(volume.type) > sizeof(float) || volume.type == StoredType::UInt32 ||
        volume.type == StoredType::Int32)
        return true;
    const double step = std::abs(volume.slope), largest = step * largestShort + std::abs(volume.intercept);
    return volume.type < StoredType::Float32 && largest * roundingOfFloat > step * partOfStep;
}

} // namespace

std::string_view VolumeRequest::text() const
{
    return asText(file->bytes());
}

std::vector<Parameter> volumeChoices()
{
    Parameter array, component, time;
    array.id = "array";
    array.label = Message::marked("Array");
    array.explanation = Message::marked("Files with several sets of values (Gaussian cube, OpenDX): one of them, by "
                                        "name or by number from 1; by default the first.");
    array.defaultValue = std::string();
    component.id = "component";
    component.label = Message::marked("Component");
    component.explanation =
        Message::marked("Arrays with several components: the number of one, from 0, or 'magnitude'.");
    component.defaultValue = std::string(magnitudeName);
    component.mistake = componentMistake;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Files with several time steps: which one, from 1.");
    time.defaultValue = std::int64_t(1);
    time.minimum = 1;
    time.maximum = 1e9;
    return {array, component, time};
}

Status setStoredSize(StoredVolume& volume, const std::array<std::uint64_t, 3>& size, std::uint64_t steps)
{
    if (const Status fits = checkLatticeSize(size); !fits)
        return fits;
    for (std::size_t axis = 0; axis < 3; ++axis)
        volume.lattice.size[axis] = static_cast<std::uint32_t>(size[axis]);
    const std::uint64_t ofStep = cappedProduct(volume.lattice.pointCount(), volume.components);
    const std::uint64_t bytes = cappedProduct(cappedProduct(ofStep, steps), storedSize(volume.type));
    if (bytes == ~std::uint64_t(0))
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its header requires more samples than any file holds. It is damaged: copy or export it again.")};
    volume.numbers = bytes / storedSize(volume.type);
    setStrides(volume, volume.components, false);
    return {};
}

void setStrides(StoredVolume& volume, std::uint64_t ofPoint, bool lastFastest)
{
    std::uint64_t stride = ofPoint;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t axis = lastFastest ? 2 - i : i;
        volume.strides[axis] = stride;
        stride *= volume.lattice.size[axis];
    }
}

Result<std::size_t> takeArray(StoredVolume& volume, const ParameterValues& values)
{
    const std::vector<FileArray>& arrays = volume.arrays;
    const std::string wanted = choiceText(values, "array");
    std::size_t chosen = 0;
    if (!wanted.empty()) {
        const auto named = std::ranges::find(arrays, wanted, &FileArray::name);
        const auto number = parseNumber<std::uint64_t>(wanted);
        if (named != arrays.end())
            chosen = static_cast<std::size_t>(named - arrays.begin());
        else if (number && *number >= 1 && *number <= arrays.size())
            chosen = static_cast<std::size_t>(*number - 1);
        else
            return Error{ErrorKind::WrongUsage,
                         arrays.size() == 1 ? Message::say("it has only one array, and not '%1'. Leave '--array' out.",
                                                           printable(wanted))
                                            : Message::say("it has no array '%1'. It has %2: %3.", printable(wanted),
                                                           arrays.size(), namesOf(arrays))};
    }
    volume.valueName = arrays[chosen].name;
    if (arrays.size() > 1)
        volume.taken.push_back(
            {TakenPart::Array,
             Message::say("%1, number %2 of %3", printable(arrays[chosen].name), chosen + 1, arrays.size()),
             wanted.empty()});
    return chosen;
}

Status takeComponent(StoredVolume& volume, const ParameterValues& values)
{
    const std::string wanted = choiceText(values, "component");
    const bool wantsMagnitude = wanted.empty() || wanted == magnitudeName;
    const auto number = wantsMagnitude ? std::optional<std::uint32_t>(0) : parseNumber<std::uint32_t>(wanted);
    if (!number || *number >= volume.components || (!wantsMagnitude && volume.components == 1))
        return Error{
            ErrorKind::WrongUsage,
            volume.components == 1
                ? Message::say(
                      "it has one number for each sample, and component '%1' was requested. Leave '--component' out.",
                      printable(wanted))
                : Message::say("it has no component '%1'. Choose one from 0 to %2, or 'magnitude'.", printable(wanted),
                               volume.components - 1)};
    if (volume.components == 1)
        return {};
    std::string& name = volume.valueName;
    if (wantsMagnitude) {
        volume.taken.push_back(
            {TakenPart::Component, Message::say("magnitude of %1", volume.components), !values.contains("component")});
        name += name.empty() ? "" : " (magnitude)";
        return {};
    }
    volume.component = number;
    volume.taken.push_back(
        {TakenPart::Component, Message::say("%1 of %2, counted from 0", *number, volume.components)});
    volume.leftOut.push_back(
        Message::say("Each sample has %1 components; the others are not read.", volume.components));
    name += name.empty() ? "" : " (component " + std::to_string(*number) + ")";
    return {};
}

Status takeTimeStep(StoredVolume& volume, const ParameterValues& values, std::uint64_t steps,
                    std::uint64_t numbersOfStep)
{
    const auto wanted = parameterValue<std::int64_t>(volumeChoices(), values, "time");
    if (wanted < 1 || static_cast<std::uint64_t>(wanted) > steps)
        return noSuchTimeStep(steps, wanted);
    if (steps == 1)
        return {};
    const auto step = static_cast<std::uint64_t>(wanted) - 1;
    volume.first += step * numbersOfStep;
    const bool tellsTimes = step < volume.timeSteps.size();
    volume.taken.push_back({TakenPart::TimeStep,
                            tellsTimes
                                ? Message::say("%1 of %2, time %3", wanted, steps, formatNumber(volume.timeSteps[step]))
                                : Message::say("%1 of %2", wanted, steps),
                            !values.contains("time")});
    for (std::uint64_t number = 1; !tellsTimes && steps <= mostTimes && number <= steps; ++number)
        volume.timeSteps.push_back(static_cast<double>(number)); // something to choose from
    volume.leftOut.push_back(Message::say("It holds %1 volumes; the others are not read.", steps));
    return {};
}

Status placeStored(StoredVolume& volume, const ParameterValues& values)
{
    Lattice& lattice = volume.lattice;
    const Eigen::Vector3d assumed = lattice.spacing;
    if (const Status placed = placeByUser(values, volume.untold, lattice, volume.lengthUnit); !placed)
        return placed;
    if (placementText(values, "origin").empty()) // what the user says is the first point
        lattice.origin += lattice.directions * volume.stepsToOrigin.cwiseProduct(lattice.spacing - assumed);
    std::ranges::move(remarkOnSpacing(values, volume.untold, lattice), std::back_inserter(volume.remarks));
    return checkLatticePlacement(lattice);
}

std::optional<SampleType> storedSampleType(const StoredVolume& volume)
{
    if (volume.isMagnitude()) // as everywhere, of floats alone in single precision
        return volume.type == StoredType::Float32 || volume.type == StoredType::Float16 ? SampleType::Float32
                                                                                        : SampleType::Float64;
    if (volume.isScaled())
        return needsDouble(volume) ? SampleType::Float64 : SampleType::Float32;
    return volume.type == StoredType::Float16 ? std::optional(SampleType::Float32) : plainSampleType(volume.type);
}

} // namespace tetra
