// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

constexpr double specificHeats = 1.4; ///< their ratio, of a gas of molecules of two atoms

/// In the order in which "automatic" tries them.
constexpr std::array<std::string_view, 10> names = {
    Message::marked("density"),
    Message::marked("pressure"),
    Message::marked("energy"),
    Message::marked("velocity_magnitude"),
    Message::marked("momentum_magnitude"),
    Message::marked("momentum_x"),
    Message::marked("momentum_y"),
    Message::marked("momentum_z"),
    Message::marked("temperature"),
    Message::marked("mach"),
};

/// The five quantities of one point.
struct State {
    double density = 0;
    double momentumX = 0;
    double momentumY = 0;
    double momentumZ = 0;
    double energy = 0;

    double momentum() const { return std::sqrt(momentumX * momentumX + momentumY * momentumY + momentumZ * momentumZ); }
    double speed() const { return momentum() / density; }
    double pressure() const { return (specificHeats - 1) * (energy - 0.5 * momentum() * momentum() / density); }
    double temperature() const { return pressure() / density; }
    double mach() const { return speed() / std::sqrt(specificHeats * temperature()); }
};

double valueOf(std::string_view name, const State& state)
{
    if (name == "density")
        return state.density;
    if (name == "pressure")
        return state.pressure();
    if (name == "energy")
        return state.energy;
    if (name == "velocity_magnitude")
        return state.speed();
    if (name == "momentum_magnitude")
        return state.momentum();
    if (name == "momentum_x")
        return state.momentumX;
    if (name == "momentum_y")
        return state.momentumY;
    if (name == "momentum_z")
        return state.momentumZ;
    if (name == "temperature")
        return state.temperature();
    return state.mach();
}

using Quantities = std::array<std::vector<double>, 5>;

Result<Quantities> readQuantities(const Plot3dFile& solution, std::size_t grid, const Progress& progress)
{
    Quantities quantities;
    for (std::size_t number = 0; number < quantities.size(); ++number) {
        const double share = 1.0 / static_cast<double>(quantities.size());
        const double begin = share * static_cast<double>(number);
        auto component = readComponent(solution, grid, number, progress.part(begin, begin + share));
        if (!component)
            return component.error();
        quantities[number] = *std::move(component);
    }
    return quantities;
}

std::vector<double> evaluate(std::string_view name, const Quantities& q)
{
    std::vector<double> values(q[0].size());
    for (std::size_t point = 0; point < values.size(); ++point)
        values[point] = valueOf(name, {q[0][point], q[1][point], q[2][point], q[3][point], q[4][point]});
    return values;
}

/// Which points count.
using Blanked = std::span<const std::uint8_t>;

bool counts(Blanked blanked, std::size_t point)
{
    return blanked.empty() || blanked[point] == 0;
}

/// Whether there is something to see: two values, of those that are finite numbers.
bool varies(const std::vector<double>& values, Blanked blanked)
{
    const double* first = nullptr;
    for (std::size_t point = 0; point < values.size(); ++point)
        if (counts(blanked, point) && std::isfinite(values[point])) {
            if (first != nullptr && values[point] != *first)
                return true;
            first = &values[point];
        }
    return false;
}

/// Arrays that can be taken, for messages.
Message usableNames(const Quantities& quantities, Blanked blanked)
{
    std::string list;
    for (const std::string_view name : names)
        if (varies(evaluate(name, quantities), blanked))
            list += (list.empty() ? "" : ", ") + std::string(name);
    return list.empty() ? Message::say("No array of this solution varies.")
                        : Message::say("These can be taken: %1.", list);
}

Status checkUsable(const Plot3dArray& array, const Quantities& quantities, Blanked blanked, const Plot3dFile& solution)
{
    if (!varies(array.values, blanked))
        return inPlot3dFile(
            solution.path(),
            Message::say("the array '%1' has one value everywhere. %2", array.name, usableNames(quantities, blanked)),
            ErrorKind::WrongUsage);
    return {};
}

} // namespace

std::span<const std::string_view> plot3dArrayNames()
{
    return names;
}

Result<Plot3dArray> readPlot3dArray(const Plot3dFile& solution, std::size_t grid, const std::string& name,
                                    std::span<const std::uint8_t> blanked, const Progress& progress)
{
    const auto quantities = readQuantities(solution, grid, progress);
    if (!quantities)
        return quantities.error();
    if (name != "automatic") {
        Plot3dArray array{name, evaluate(name, *quantities)};
        if (const Status usable = checkUsable(array, *quantities, blanked, solution); !usable)
            return usable.error();
        return array;
    }
    for (const std::string_view candidate : names)
        if (auto values = evaluate(candidate, *quantities); varies(values, blanked))
            return Plot3dArray{std::string(candidate), std::move(values)};
    return inPlot3dFile(solution.path(), Message::say("none of its arrays varies, so there is nothing to see."));
}

} // namespace tetra
