// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

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

/// Which of the five quantities an array is made of: a bit for each.
unsigned quantitiesOf(std::string_view name)
{
    constexpr std::array<unsigned, 4> stored = {1, 2, 4, 8};
    constexpr unsigned density = stored[0], momenta = stored[1] | stored[2] | stored[3], energy = 16;
    if (name == "density")
        return density;
    if (name == "energy")
        return energy;
    if (name == "velocity_magnitude")
        return density | momenta;
    if (name.starts_with("momentum_"))
        return momenta;
    return density | momenta | energy;
}

/// Of an array of a solution.
struct SolutionArray {
    std::string_view name;
    const Plot3dFile& solution;
    std::size_t grid;
};

/// Calls visit(first, values), which gives a Status, for some points at a time: a file may be larger than memory.
template <class Visit> Status forValues(const SolutionArray& source, const Progress& progress, const Visit& visit)
{
    std::array<std::vector<double>, 5> q;
    std::vector<double> values;
    const unsigned needed = quantitiesOf(source.name);
    const std::uint64_t points = pointCountOf(source.solution, source.grid);
    return forPieces(points, progress, [&](std::uint64_t first, std::uint64_t count) -> Status {
        for (std::size_t number = 0; number < q.size(); ++number) {
            q[number].resize(count);
            if ((needed >> number & 1) == 0)
                continue;
            if (const Status read = readComponent(source.solution, source.grid, number, first, q[number]); !read)
                return read;
        }
        values.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            values[i] = valueOf(source.name, {q[0][i], q[1][i], q[2][i], q[3][i], q[4][i]});
        return visit(first, std::span<const double>(values));
    });
}

/// Which points count.
using Blanked = std::span<const std::uint8_t>;

bool counts(Blanked blanked, std::size_t point)
{
    return blanked.empty() || blanked[point] == 0;
}

/// Whether there is something to see: two values of the grids, of those that are finite numbers. Errors: damaged,
/// cancelled.
Result<bool> varies(std::string_view name, const Plot3dFile& solution, std::span<const Plot3dGrid> grids,
                    const Progress& progress)
{
    std::optional<double> one;
    bool differ = false;
    for (const Plot3dGrid& grid : grids) {
        const Status read = forValues({name, solution, grid.number}, progress,
                                      [&](std::uint64_t first, std::span<const double> values) {
                                          for (std::size_t i = 0; i < values.size() && !differ; ++i)
                                              if (counts(grid.blanked, first + i) && std::isfinite(values[i])) {
                                                  differ = one && values[i] != *one;
                                                  one = values[i];
                                              }
                                          // enough was seen
                                          return differ ? Status(Error{ErrorKind::Cancelled, {}}) : Status();
                                      });
        if (differ)
            return true;
        if (!read)
            return read.error();
    }
    return false;
}

/// Whether any value is a finite number.
bool hasNumbers(std::string_view name, const Plot3dFile& solution, std::span<const Plot3dGrid> grids)
{
    bool any = false;
    for (const Plot3dGrid& grid : grids)
        (void)forValues({name, solution, grid.number}, {}, [&](std::uint64_t first, std::span<const double> values) {
            for (std::size_t i = 0; i < values.size() && !any; ++i)
                any = counts(grid.blanked, first + i) && std::isfinite(values[i]);
            return any ? Status(Error{ErrorKind::Cancelled, {}}) : Status(); // enough was seen
        });
    return any;
}

/// Arrays that can be taken, for messages.
Message usableNames(const Plot3dFile& solution, std::span<const Plot3dGrid> grids)
{
    std::string list;
    for (const std::string_view name : names)
        if (const auto usable = varies(name, solution, grids, {}); usable.ok() && *usable)
            list += (list.empty() ? "" : ", ") + std::string(name);
    return list.empty() ? Message::say("No array of this solution varies.")
                        : Message::say("Available arrays: %1.", list);
}

/// The values as T; none if one does not fit.
template <class T> Result<std::optional<ScalarField>> fieldAs(const SolutionArray& source, const Progress& progress)
{
    const std::uint64_t points = pointCountOf(source.solution, source.grid);
    auto samples = allocateSamples(sampleTypeOf<T>(), points);
    if (!samples)
        return samples.error();
    T* const to = reinterpret_cast<T*>(samples->get());
    bool fits = true;
    const Status read = forValues(source, progress, [&](std::uint64_t first, std::span<const double> values) {
        std::ranges::transform(values, to + first, [&](double value) {
            fits = fits && (!std::isfinite(value) || std::abs(value) <= std::numeric_limits<T>::max());
            return static_cast<T>(value);
        });
        return Status();
    });
    if (!read)
        return read.error();
    if (!fits)
        return std::optional<ScalarField>();
    return std::optional(ScalarField(sampleTypeOf<T>(), points, *std::move(samples)));
}

Result<Plot3dArray> arrayOf(std::string_view name, const Plot3dFile& solution, std::span<const Plot3dGrid> grids,
                            const Progress& progress)
{
    Plot3dArray array{.name = std::string(name), .values = {}};
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const SolutionArray source{name, solution, grids[i].number};
        const Progress part = progress.part(double(i) / double(grids.size()), double(i + 1) / double(grids.size()));
        Result<std::optional<ScalarField>> field = std::optional<ScalarField>();
        if (solution.layout.realBytes == 4)
            field = fieldAs<float>(source, part);
        if (field && !*field)
            field = fieldAs<double>(source, part);
        if (!field)
            return field.error();
        array.values.push_back(**std::move(field));
    }
    return array;
}

} // namespace

std::span<const std::string_view> plot3dArrayNames()
{
    return names;
}

Result<Plot3dArray> readPlot3dArray(const Plot3dFile& solution, std::span<const Plot3dGrid> grids,
                                    const std::string& name, const Progress& progress)
{
    for (const std::string_view candidate : names) {
        if (name != "automatic" && name != candidate)
            continue;
        const Result<bool> usable =
            varies(candidate, solution, grids, progress.withCallback([](double, const Message&) {}));
        if (!usable.ok())
            return usable.error();
        if (*usable)
            return arrayOf(candidate, solution, grids, progress);
        if (name != "automatic")
            return inPlot3dFile(
                solution.path(),
                hasNumbers(candidate, solution, grids)
                    ? Message::say("the array '%1' has the same value everywhere. %2", name,
                                   usableNames(solution, grids))
                    : Message::say(
                          "the array '%1' is not a number anywhere: it cannot be computed from this solution. %2", name,
                          usableNames(solution, grids)),
                ErrorKind::WrongUsage);
    }
    return inPlot3dFile(solution.path(), Message::say("none of its arrays varies, so there is nothing to see."));
}

} // namespace tetra
