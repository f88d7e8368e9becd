// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/exchange.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What the program tan-read-hdf5 is asked for.
struct Hdf5Request {
    bool contentsOnly = false; ///< probe() instead of read()
    std::string path;
    std::string array; ///< its path in the file, its name alone, or a number from 1; empty or "automatic"
    std::string component;
    bool componentIsGiven = false;    ///< by the user
    std::int64_t timeStep = 1;        ///< from 1
    bool timeIsGiven = false;         ///< by the user
    std::string channel;              ///< a number from 1; empty: the first
    std::string index;                ///< of further dimensions: "d2=3"; empty: the first
    std::vector<std::string> given{}; ///< givenPlacement()
};

/// Whether the user leaves the array to the reader.
inline bool isAutomatic(const Hdf5Request& request)
{
    return request.array.empty() || request.array == "automatic";
}

template <class Archive> void exchange(Archive& archive, Hdf5Request& request)
{
    exchangeAll(archive, request.contentsOnly, request.path, request.array, request.component, request.componentIsGiven,
                request.timeStep, request.timeIsGiven, request.channel, request.index, request.given);
}

} // namespace tetra
