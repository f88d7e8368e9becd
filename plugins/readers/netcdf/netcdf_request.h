// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/exchange.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What the program tan-read-netcdf is asked for.
struct NetCdfRequest {
    bool contentsOnly = false; ///< probe() instead of read()
    std::string path;
    std::string array;                ///< a name, or a number from 1; "automatic"
    std::string component;            ///< of Exodus files: empty: the user does not say it, and the magnitude is taken
    std::int64_t timeStep = 1;        ///< from 1
    bool timeIsGiven = false;         ///< by the user
    std::string index;                ///< of further dimensions: "member=2,type=1"; empty: the first
    std::string part;                 ///< of Exodus files: a block's name, number from 1, or id; empty: all
    bool displaced = false;           ///< of Exodus files: moves the nodes by their displacements
    std::vector<std::string> given{}; ///< givenPlacement()
};

/// Whether the user leaves the array to the reader.
inline bool isAutomatic(const NetCdfRequest& request)
{
    return request.array.empty() || request.array == "automatic";
}

template <class Archive> void exchange(Archive& archive, NetCdfRequest& request)
{
    exchangeAll(archive, request.contentsOnly, request.path, request.array, request.component, request.timeStep,
                request.timeIsGiven, request.index, request.part, request.displaced, request.given);
}

} // namespace tetra
