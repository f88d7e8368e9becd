// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Which columns of a table are the positions and the values, counted from 0.
struct PointColumns {
    std::array<std::size_t, 3> position{0, 1, 2};
    std::size_t value = 3;
    std::vector<std::string> names; ///< of all columns; "column 3" where the table names none
};

/// What finds the columns by itself.
inline constexpr std::string_view automaticColumns = "automatic";

/// `names` are those that the table has, one for each column; `wantedPositions` three names or numbers from 1,
/// separated by commas, or "automatic": columns named x, y and z (units behind the letter do not matter), Points:0, 1
/// and 2 as ParaView writes them, else the first three. `wantedValue` a name, a number or "automatic": the first other
/// column.
Result<PointColumns> choosePointColumns(std::vector<std::string> names, std::string_view wantedPositions,
                                        std::string_view wantedValue);

} // namespace tetra
