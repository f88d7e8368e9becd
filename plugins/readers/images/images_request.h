// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/process/exchange.h"
#include "plugins/readers/images/images_format.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// What the program that reads pictures is asked for.
struct ImagesRequest {
    bool contentsOnly = false; ///< probe() instead of read()
    ImagesFormat format = ImagesFormat::None;
    std::string path;
    std::string series;               ///< a number from 1, or the name that the file gives it; empty: the opened file's
    std::string channel;              ///< a name, or a number from 1; empty: the first
    std::string component;            ///< of pictures in colour: the number of one, from 0, or "magnitude"; empty: none
    std::int64_t time = 0;            ///< from 1; 0: the first, of DICOM files that of the opened one
    std::vector<std::string> given{}; ///< givenPlacement(), which is refused for what the file tells
};

template <class Archive> void exchange(Archive& archive, ImagesRequest& request)
{
    exchangeAll(archive, request.contentsOnly, request.format, request.path, request.series, request.channel,
                request.component, request.time, request.given);
}

} // namespace tetra
