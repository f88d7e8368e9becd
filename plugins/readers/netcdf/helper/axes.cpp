// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/axes.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <sstream>

namespace tetra {
namespace {

using Words = std::initializer_list<std::string_view>;

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

bool isOneOf(std::string_view text, Words words)
{
    return std::ranges::find(words, text) != words.end();
}

bool countsTime(const std::string& units)
{
    return lowered(units).find(" since ") != std::string::npos;
}

AxisRole roleByUnits(const std::string& units)
{
    if (countsTime(units))
        return AxisRole::Time;
    if (isOneOf(units, {"degrees_east", "degree_east", "degree_E", "degrees_E", "degreeE", "degreesE"}))
        return AxisRole::X;
    if (isOneOf(units, {"degrees_north", "degree_north", "degree_N", "degrees_N", "degreeN", "degreesN"}))
        return AxisRole::Y;
    return isOneOf(lowered(units), {"pa", "hpa", "mb", "mbar", "millibar", "millibars", "bar", "pascal", "decibar",
                                    "dbar", "level", "layer", "sigma_level"})
               ? AxisRole::Z
               : AxisRole::Unknown;
}

AxisRole roleByStandardName(const std::string& name)
{
    if (isOneOf(name, {"longitude", "grid_longitude", "projection_x_coordinate"}))
        return AxisRole::X;
    if (isOneOf(name, {"latitude", "grid_latitude", "projection_y_coordinate"}))
        return AxisRole::Y;
    if (name == "time")
        return AxisRole::Time;
    return isOneOf(name, {"height", "altitude", "depth", "air_pressure", "model_level_number", "geopotential_height",
                          "height_above_geopotential_datum", "height_above_reference_ellipsoid",
                          "height_above_mean_sea_level"}) ||
                   name.starts_with("atmosphere_") || name.starts_with("ocean_s") || name.starts_with("ocean_d")
               ? AxisRole::Z
               : AxisRole::Unknown;
}

AxisRole roleByName(const std::string& name)
{
    if (isOneOf(name, {"x", "xc", "lon", "long", "longitude", "rlon", "nav_lon", "xlong", "xlong_u", "xlong_v",
                       "easting", "west_east", "west_east_stag"}))
        return AxisRole::X;
    if (isOneOf(name, {"y", "yc", "lat", "latitude", "rlat", "nav_lat", "xlat", "xlat_u", "xlat_v", "northing",
                       "south_north", "south_north_stag"}))
        return AxisRole::Y;
    if (isOneOf(name, {"z", "zc", "lev", "level", "levels", "plev", "depth", "height", "altitude", "pressure_level",
                       "deptht", "isobaric", "bottom_top", "bottom_top_stag"}))
        return AxisRole::Z;
    return name == "time" ? AxisRole::Time : AxisRole::Unknown;
}

AxisRole roleByAxis(const std::string& axis)
{
    constexpr std::array<std::string_view, 4> names = {"x", "y", "z", "t"};
    const auto found = std::ranges::find(names, lowered(axis));
    return found == names.end() ? AxisRole::Unknown : static_cast<AxisRole>(found - names.begin());
}

} // namespace

std::vector<std::string> wordsOf(const std::string& list)
{
    std::istringstream stream(list);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

AxisRole roleOf(const NetCdfFile& file, const NetCdfVariable& coordinate)
{
    const std::array says = {roleByAxis(file.text(coordinate, "axis")),
                             roleByStandardName(file.text(coordinate, "standard_name")),
                             roleByUnits(file.text(coordinate, "units")),
                             file.text(coordinate, "positive").empty() ? AxisRole::Unknown : AxisRole::Z,
                             roleByName(lowered(coordinate.name))};
    const auto known = std::ranges::find_if(says, [](AxisRole role) { return role != AxisRole::Unknown; });
    return known == says.end() ? AxisRole::Unknown : *known;
}

const NetCdfVariable* coordinateOf(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension)
{
    const NetCdfVariable* found = file.findFrom(from, file.dimensions()[dimension].name);
    const bool isCoordinate = found != nullptr && NetCdfFile::isNumeric(*found) && found->dimensions.size() == 1 &&
                              found->dimensions[0] == dimension;
    return isCoordinate ? found : nullptr;
}

const NetCdfVariable* timesAlong(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension)
{
    if (const NetCdfVariable* own = coordinateOf(file, from, dimension))
        return own;
    const auto found = std::ranges::find_if(file.variables(), [&](const NetCdfVariable& variable) {
        return variable.dimensions.size() == 1 && variable.dimensions[0] == dimension &&
               NetCdfFile::isNumeric(variable) && countsTime(file.text(variable, "units"));
    });
    return found == file.variables().end() ? nullptr : &*found;
}

AxisRole roleOf(const NetCdfFile& file, const NetCdfVariable& from, std::size_t dimension)
{
    const NetCdfVariable* coordinate = timesAlong(file, from, dimension);
    return coordinate != nullptr ? roleOf(file, *coordinate) : roleByName(lowered(file.dimensions()[dimension].name));
}

} // namespace tetra
