// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/exchange.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What the program tan-read-zarr is asked for.
struct ZarrRequest {
    bool contentsOnly = false; ///< probe() instead of read()
    std::string folder;        ///< of the array or group
    std::string array;         ///< the path of an array or of an image inside the folder; empty or "automatic": chosen
    std::string series;        ///< of several images: the path of one, or its number from 1; empty: the first
    std::string part;          ///< the level: its path, or its number from 0; empty: the finest
    std::string channel;       ///< a name, or a number from 1; empty: the first
    std::int64_t time = 0;     ///< from 1; 0: the first
    std::string index;         ///< of further axes: "angle=2,type=1"; empty: the first of each
    std::vector<std::string> given{}; ///< givenPlacement(), which is refused for what the file tells
};

template <class Archive> void exchange(Archive& archive, ZarrRequest& request)
{
    exchangeAll(archive, request.contentsOnly, request.folder, request.array, request.series, request.part,
                request.channel, request.time, request.index, request.given);
}

} // namespace tetra
