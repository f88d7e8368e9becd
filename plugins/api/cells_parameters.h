// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/data.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// For readers of meshes of cells: "faulty", the share of cells that may be left out, and "polyhedra", how they are
/// cut.

inline std::optional<double> parseFaultyShare(std::string_view text)
{
    constexpr double most = 100;
    text = text.substr(0, text.find_last_not_of(" %") + 1);
    const auto percent = parseNumber<double>(text);
    return percent && *percent >= 0 && *percent <= most ? std::optional(*percent / 100) : std::nullopt;
}

inline std::vector<Parameter> cellsParameters()
{
    Parameter faulty;
    faulty.id = "faulty";
    faulty.label = Message::marked("Faulty cells");
    faulty.explanation =
        Message::marked("Meshes: the largest share of cells, or of their volume, that may be left out because they "
                        "overlap others or are inverted, as in 5%; a mesh with more of them is refused.");
    faulty.defaultValue = std::string("0.1%");
    faulty.mistake = [](const std::string& text) {
        return parseFaultyShare(text) ? Message() : Message::say("Give a share from 0% to 100%, as in 5%.");
    };
    Parameter polyhedra;
    polyhedra.id = "polyhedra";
    polyhedra.label = Message::marked("Polyhedra");
    polyhedra.explanation =
        Message::marked("Meshes with polyhedra: 'corners' cuts each into tetrahedra between its own points; 'centre' "
                        "adds a point in the middle of those that cannot be cut in that way.");
    polyhedra.defaultValue = std::string("corners");
    polyhedra.choices = {Message::marked("corners"), Message::marked("centre")};
    return {faulty, polyhedra};
}

/// Takes both over. The error (WrongUsage) says what is wrong with a value.
inline Status applyCellsParameters(const ParameterValues& values, CellComplex& complex)
{
    const std::vector<Parameter> parameters = cellsParameters();
    const auto text = parameterValue<std::string>(parameters, values, "faulty");
    const auto share = parseFaultyShare(text);
    if (!share)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' for 'faulty' is not understood. Give a share from 0% to 100%, as in 5%.",
                                  printable(text))};
    complex.mostFaulty = *share;
    complex.addsCentres = parameterValue<std::string>(parameters, values, "polyhedra") == "centre";
    return {};
}

} // namespace tetra
