// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// The name of a column, taken apart: "Temperature [ K ]" is the quantity "Temperature" in the unit "K".
struct ColumnName {
    std::string whole;    ///< as the table has it
    std::string quantity; ///< never empty if `whole` is not
    std::string unit{};   ///< empty if the name tells none
};

ColumnName parseColumnName(std::string_view name);

/// What a column is by its name.
enum class ColumnKind {
    Quantity,     ///< as far as the name tells
    HeightOrTime, ///< belongs to the place as a rule, but is also what is measured at places
    Coordinate,   ///< "x", "lat", "Points_Magnitude"
    Counter       ///< "", "id", "Node Number"
};

ColumnKind kindOf(const ColumnName& name);

/// Whether it is a depth by its name, and not "minus depth".
bool isDepth(const ColumnName& name);

/// The three columns of a table that are x, y and z by their names.
struct NamedPlaces {
    std::array<std::size_t, 3> columns{};
    bool guessed = false; ///< others could be meant as well
};

/// Knows, in capital or small letters, by the first of these that all three of a kind are there:
/// - x, y, z with what people add to them: "X (m)", "x_mm", "x-coordinate", "X Location (mm)", "coord_x", "pos x",
///   "xcoord", "Node X", "[X]";
/// - numbered coordinates: "Points:0", "Points_0", "coordinates 2", from 0 or from 1;
/// - "easting", "northing"; "lon", "lat" and their longer forms;
/// - cx, cy, cz; xc, yc, zc; and x, y and z with one and the same word behind or before it, which is a guess, and none
///   where that word is of a vector, as in "x velocity".
/// The third of all but the numbered may be a "depth", "height", "altitude", "elevation" or "level".
std::optional<NamedPlaces> findPlaces(std::span<const ColumnName> names);

} // namespace tetra
