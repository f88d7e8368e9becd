// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "plugins/host/plugin_host.h"

#include <tan/query.h>
#include <tan/render.h>
#include <tan/view.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What a picture is to be of, as far as it can be known without the model.
struct RenderRequest {
    std::filesystem::path input;
    std::filesystem::path output;
    std::optional<std::filesystem::path> depth;    ///< the file for the depths
    std::optional<std::filesystem::path> surfaces; ///< the file for the surfaces of the scene
    MeshQuery query;
    LensState lens;
    PictureOptions picture;
    bool heightFollows = false; ///< the size is a width alone
    int dotsPerInch = 0;        ///< for printing; 0 says nothing
    std::string backend;        ///< "cpu" or "gl"
};

/// --camera, --size, --dpi, --samples, --background, --backend, --threads, --depth, --lens, --faulty-cells, --output;
/// --surfaces has the endings of the writers.
std::vector<Option> pictureOptions(PluginHost& host);

/// What these and the options of query_options.h ask for. Errors (WrongUsage): values that do not fit, options that do
/// not go together, files that would replace the model or each other.
Result<RenderRequest> renderRequestOf(const Arguments& arguments);

/// Gives a picture of which the width alone was asked for its height: by the view of the session that is drawn, or as
/// usual. Errors: those of readSession().
Status followWidth(RenderRequest& request);

} // namespace tetra
