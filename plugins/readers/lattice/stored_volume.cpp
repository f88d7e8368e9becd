// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored_volume.h"

#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tetra {

namespace {

/// Empty if the text can be a component: "magnitude" or a whole number from 0.
Message componentMistake(const std::string& text)
{
    const bool isNumber = !text.empty() && text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
    return text == "magnitude" || isNumber
               ? Message()
               : Message::say("Give '%1', or the number of a component from 0.", "magnitude");
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

std::vector<Parameter> volumeParameters()
{
    Parameter component, time;
    component.id = "component";
    component.label = Message::marked("Component");
    component.explanation =
        Message::marked("Of arrays with several components: the number of one, from 0, or 'magnitude'.");
    component.defaultValue = std::string("magnitude");
    component.mistake = componentMistake;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Of files with several time steps: which one, from 1.");
    time.defaultValue = std::int64_t(1);
    time.minimum = 1;
    time.maximum = 1e9;
    return {component, time};
}

VolumeChoice volumeChoice(const ParameterValues& values)
{
    const auto parameters = volumeParameters();
    return {parameterValue<std::int64_t>(parameters, values, "time"),
            parameterValue<std::string>(parameters, values, "component")};
}

Status setStoredSize(StoredVolume& volume, const std::array<std::uint64_t, 3>& size, std::uint64_t steps)
{
    if (const Status fits = checkLatticeSize(size); !fits)
        return fits;
    for (std::size_t axis = 0; axis < 3; ++axis)
        volume.lattice.size[axis] = static_cast<std::uint32_t>(size[axis]);
    const std::uint64_t ofStep = cappedProduct(volume.lattice.pointCount(), volume.components);
    volume.numbers = cappedProduct(cappedProduct(ofStep, steps), storedSize(volume.type));
    if (volume.numbers == ~std::uint64_t(0))
        return Error{ErrorKind::BadInput, Message::say("its header asks for more samples than any file holds. It is "
                                                       "damaged: copy or export it again.")};
    volume.numbers /= storedSize(volume.type);
    return {};
}

Status takeTimeStep(StoredVolume& volume, const VolumeChoice& choice, std::uint64_t steps, std::uint64_t numbersOfStep)
{
    if (choice.time < 1 || static_cast<std::uint64_t>(choice.time) > steps)
        return Error{ErrorKind::WrongUsage,
                     steps == 1 ? Message::say("it has one time step, and number %1 was asked for. Leave '--time' out.",
                                               choice.time)
                                : Message::say("it has %1 time steps, and number %2 was asked for. Give one from 1 to "
                                               "%1.",
                                               steps, choice.time)};
    if (steps == 1)
        return {};
    const auto step = static_cast<std::uint64_t>(choice.time) - 1;
    volume.first += step * numbersOfStep;
    const bool tellsTimes = step < volume.timeSteps.size();
    volume.taken.push_back({TakenPart::TimeStep, tellsTimes ? Message::say("%1 of %2, time %3", choice.time, steps,
                                                                           formatNumber(volume.timeSteps[step]))
                                                            : Message::say("%1 of %2", choice.time, steps)});
    for (std::uint64_t number = 1; !tellsTimes && steps <= mostTimes && number <= steps; ++number)
        volume.timeSteps.push_back(static_cast<double>(number)); // something to choose from
    volume.leftOut.push_back(Message::say("It holds %1 volumes; the others are not read.", steps));
    return {};
}

Status takeComponent(StoredVolume& volume, const VolumeChoice& choice)
{
    const bool wantsMagnitude = choice.component.empty() || choice.component == "magnitude";
    const auto number = wantsMagnitude ? std::optional<std::uint32_t>(0) : parseNumber<std::uint32_t>(choice.component);
    if (!number || *number >= volume.components)
        return Error{ErrorKind::WrongUsage,
                     volume.components == 1
                         ? Message::say("it has one number for each sample, and component '%1' was asked for. Leave "
                                        "'--component' out.",
                                        printable(choice.component))
                         : Message::say("it has no component '%1'. Choose one from 0 to %2, or 'magnitude'.",
                                        printable(choice.component), volume.components - 1)};
    if (!wantsMagnitude)
        volume.component = number;
    if (volume.components == 1)
        return {};
    volume.taken.push_back({TakenPart::Component,
                            wantsMagnitude ? Message::say("magnitude of %1", volume.components)
                                           : Message::say("%1 of %2, counted from 0", *number, volume.components),
                            wantsMagnitude});
    if (!wantsMagnitude)
        volume.leftOut.push_back(
            Message::say("Each sample has %1 components; the others are not read.", volume.components));
    return {};
}

Status placeStored(const ParameterValues& values, StoredVolume& volume)
{
    Lattice& lattice = volume.lattice;
    const Eigen::Vector3d assumed = lattice.spacing;
    if (const Status placed = placeByUser(values, volume.untold, lattice, volume.lengthUnit); !placed)
        return placed;
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
