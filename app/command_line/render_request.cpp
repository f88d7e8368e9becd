// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/render_request.h"

#include "app/command_line/camera_option.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/query_options.h"
#include "core/base/text.h"
#include "core/render/scene_checks.h"
#include "plugins/host/colour_text.h"
#include "plugins/host/output_check.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <utility>

namespace tetra {
namespace {

constexpr std::string_view defaultBackend = "cpu";
constexpr std::string_view defaultSize = "1024x768";
constexpr int mostSamples = 4;
const int defaultSamples = PictureOptions().samplesPerAxis;

Status parseSize(const std::string& text, PictureOptions& picture)
{
    const auto cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = parseNumber<int>(std::string_view(text).substr(0, cross));
        const auto height = parseNumber<int>(std::string_view(text).substr(cross + 1));
        if (width && height && *width > 0 && *height > 0 && *width <= largestPictureSide &&
            *height <= largestPictureSide) {
            picture.width = *width;
            picture.height = *height;
            return {};
        }
    }
    return Error{ErrorKind::WrongUsage, "'" + text +
                                            "' does not fit '--size': it takes WIDTHxHEIGHT in pixels, each from "
                                            "1 to " +
                                            std::to_string(largestPictureSide) + ", like " + std::string(defaultSize) +
                                            "."};
}

Status parseBackground(const std::string& text, PictureOptions& picture)
{
    if (text == "transparent") {
        picture.transparentBackground = true;
        return {};
    }
    const auto colour = parseColour(text);
    if (!colour)
        return colour.error();
    picture.background = *colour;
    return {};
}

Status parseNumberOptions(const Arguments& arguments, PictureOptions& picture)
{
    const auto samples = wholeNumberOption(arguments, "samples", defaultSamples, 1, mostSamples);
    if (!samples)
        return samples.error();
    picture.samplesPerAxis = static_cast<int>(*samples);
    const auto threads = threadsOf(arguments);
    if (!threads)
        return threads.error();
    picture.threads = *threads;
    return {};
}

Result<PictureOptions> pictureOf(const Arguments& arguments)
{
    PictureOptions picture;
    if (const Status size = parseSize(arguments.value("size").value_or(std::string(defaultSize)), picture); !size)
        return size.error();
    if (const Status colour = parseBackground(arguments.value("background").value_or("white"), picture); !colour)
        return colour.error();
    if (const Status numbers = parseNumberOptions(arguments, picture); !numbers)
        return numbers.error();
    picture.depth = arguments.has("depth");
    return picture;
}

Status checkPng(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs)
{
    if (output.extension() != ".png")
        return Error{ErrorKind::WrongUsage,
                     "'" + output.string() + "' does not end in .png, the one format in which pictures are written."};
    return checkOutput(output, inputs);
}

/// "x,y,radius,magnification[,error]", after "circle:" or "square:" if there is a word.
Result<LensState> lensOf(const std::string& text)
{
    const Error doesNotFit{
        ErrorKind::WrongUsage,
        "'" + text +
            "' does not fit '--lens': it takes X,Y,RADIUS,MAGNIFICATION or X,Y,RADIUS,MAGNIFICATION,ERROR. X and Y are "
            "fractions of the picture's width and height from its upper left corner, 0 to 1; RADIUS is a fraction of "
            "its shorter side, 0.05 to 0.5; MAGNIFICATION is 1 to 16; ERROR is in percent of the value range, 0 to "
            "100. With 'square:' before them the lens is a square."};
    LensState lens{.shape = LensState::Shape::Circle};
    std::string_view list = text;
    for (const auto& [word, shape] : {std::pair(std::string_view("circle:"), LensState::Shape::Circle),
                                      std::pair(std::string_view("square:"), LensState::Shape::Square)})
        if (list.starts_with(word)) {
            lens.shape = shape;
            list.remove_prefix(word.size());
        }
    std::vector<double LensState::*> members{&LensState::x, &LensState::y, &LensState::radius,
                                             &LensState::magnification};
    if (std::ranges::count(list, ',') == std::ssize(members))
        members.push_back(&LensState::error);
    for (const auto member : members) {
        const auto end = list.find(',');
        if ((end == std::string_view::npos) != (member == members.back()))
            return doesNotFit;
        const auto number = parseNumber<double>(list.substr(0, end));
        if (!number)
            return doesNotFit;
        lens.*member = *number;
        list.remove_prefix(std::min(list.size(), end == std::string_view::npos ? end : end + 1));
    }
    return corrected(lens, LensState{}) == lens ? Result<LensState>(lens) : Result<LensState>(doesNotFit);
}

bool isSamePlace(const std::filesystem::path& one, const std::filesystem::path& other)
{
    return std::filesystem::absolute(one).lexically_normal() == std::filesystem::absolute(other).lexically_normal();
}

Status checkFiles(const RenderRequest& request)
{
    if (const Status good = checkPng(request.output, std::array{request.input}); !good)
        return good;
    if (request.surfaces) {
        if (const Status good = checkOutput(*request.surfaces, std::array{request.input}); !good)
            return good;
        if (isSamePlace(*request.surfaces, request.output))
            return Error{ErrorKind::WrongUsage, "'--surfaces' and '--output' name the same file."};
        if (request.depth && isSamePlace(*request.surfaces, *request.depth))
            return Error{ErrorKind::WrongUsage, "'--surfaces' and '--depth' name the same file."};
    }
    if (!request.depth)
        return {};
    if (isSamePlace(*request.depth, request.output))
        return Error{ErrorKind::WrongUsage, "'--depth' and '--output' name the same file."};
    return checkPng(*request.depth, std::array{request.input});
}

} // namespace

std::vector<Option> pictureOptions(PluginHost& host)
{
    return {
        {.name = "camera",
         .placeholder = "VIEW or FILE",
         .explanation = "A view (" + cameraNames() +
                        "), or a JSON file with any of azimuth, elevation, roll, fieldOfView (in degrees), up (x, -x, "
                        "y, -y, z or -z), perspective (true or false), target ([x, y, z]) and distance.",
         .byDefault = "from the front, right and above"},
        {.name = "size",
         .placeholder = "WxH",
         .explanation = "Size of the picture, in pixels.",
         .byDefault = std::string(defaultSize)},
        {.name = "samples",
         .placeholder = "N",
         .explanation = "A pixel is the mean of N x N samples, N from 1 (coarse, quick) to 4 (smooth).",
         .byDefault = std::to_string(defaultSamples)},
        {.name = "background",
         .placeholder = "COLOUR",
         .explanation = "transparent, #rrggbb, or one of " + colourNames() + ".",
         .byDefault = "white, and dark behind a shaded volume"},
        {.name = "backend",
         .placeholder = "cpu|gl",
         .explanation = "Rendering back end: the CPU, or OpenGL 3.3.",
         .byDefault = std::string(defaultBackend)},
        threadsOption(),
        {.name = "model",
         .placeholder = "FILE",
         .explanation = "For a session: uses this model instead of its own, with the view of the session. Values and "
                        "colours stay as they are, and so does the camera if the domain is the same."},
        {.name = "strict",
         .placeholder = "",
         .explanation = "For a session: refuses to draw a picture that does not show all that the session specifies "
                        "because its model has changed. Without it, messages say what differs."},
        {.name = "depth",
         .placeholder = "FILE.png",
         .explanation = "Also writes the depth of each pixel, as a grey picture of 16 bits, dark where it is near and "
                        "white (65535) where there is nothing. --json gives the depths that the greys stand for."},
        {.name = "lens",
         .placeholder = "X,Y,R,M[,E]",
         .explanation = "Enlarges a part of the picture M times, as under a magnifying glass: around the place X,Y "
                        "(fractions of width and height from the upper left corner), out to R (a fraction of the "
                        "shorter side), with a mesh whose error there is E percent of the value range, or 0.25, if "
                        "that is smaller than the picture's. 'square:' before the numbers makes it a square."},
        {.name = "faulty-cells",
         .placeholder = "",
         .explanation =
             "Outlines, over the picture, the cells that the model lists as faulty: the cells of a mesh that were left "
             "out because something is wrong with them, and the cells of a grid that are folded or have no volume."},
        {.name = "surfaces",
         .placeholder = fileChoices(host, WrittenContent::Surface),
         .explanation =
             "Also writes the surfaces that are drawn, as the window's Save Surfaces does: those of isovalues, and "
             "others that a mode provides, with their values and colours where the format supports them."},
        outputOption("FILE.png", "The picture to write.")};
}

Result<RenderRequest> renderRequestOf(const Arguments& arguments)
{
    RenderRequest request;
    request.input = arguments.positionals[0];
    request.output = *arguments.value("output");
    if (const auto depth = arguments.value("depth"))
        request.depth = *depth;
    if (const auto surfaces = arguments.value("surfaces"))
        request.surfaces = *surfaces;
    auto query = queryOf(arguments, anyView()); // for good when the picture is known
    if (!query)
        return query.error();
    request.query = *std::move(query);
    if (const auto text = arguments.value("lens")) {
        const auto lens = lensOf(*text);
        if (!lens)
            return lens.error();
        request.lens = *lens;
    }
    const auto picture = pictureOf(arguments);
    if (!picture)
        return picture.error();
    request.picture = *picture;
    request.backend = arguments.value("backend").value_or(std::string(defaultBackend));
    if (request.backend != "cpu" && request.backend != "gl")
        return Error{ErrorKind::WrongUsage, "'" + request.backend + "' does not fit '--backend': it takes cpu or gl."};
    if (const Status files = checkFiles(request); !files)
        return files.error();
    return request;
}

} // namespace tetra
