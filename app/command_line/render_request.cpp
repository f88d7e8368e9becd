// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/render_request.h"

#include "app/command_line/camera_option.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/query_options.h"
#include "core/base/text.h"
#include "core/picture/picture_file.h"
#include "core/picture/session_document.h"
#include "core/render/scene_checks.h"
#include "plugins/host/colour_text.h"
#include "plugins/host/output_check.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

constexpr std::string_view defaultBackend = "cpu";
constexpr std::string_view defaultSize = "1024x768";
constexpr double centimetresPerInch = 2.54;
constexpr double usualRatio = 4.0 / 3; ///< of width and height
constexpr int mostSamples = 4;
const int defaultSamples = PictureOptions().samplesPerAxis;

/// "1024x768", or "1024" if the height is to follow; with "cm" behind it in centimetres.
struct SizeText {
    double width = 0;
    std::optional<double> height{};
    bool inCentimetres = false;
};

std::optional<SizeText> readSize(std::string_view text)
{
    SizeText size;
    constexpr std::string_view unit = "cm";
    size.inCentimetres = text.ends_with(unit);
    if (size.inCentimetres)
        text.remove_suffix(unit.size());
    const auto cross = text.find('x');
    const auto numberIn = [&](std::string_view part) -> std::optional<double> {
        if (size.inCentimetres)
            return parseNumber<double>(part);
        const auto pixels = parseNumber<int>(part);
        return pixels ? std::optional<double>(*pixels) : std::nullopt;
    };
    const auto width = numberIn(text.substr(0, cross));
    if (cross != std::string_view::npos)
        size.height = numberIn(text.substr(cross + 1));
    if (!width || (cross != std::string_view::npos && !size.height))
        return std::nullopt;
    size.width = *width;
    return size;
}

bool isPictureSide(double pixels)
{
    return pixels >= 1 && pixels <= largestPictureSide;
}

Status parseSize(const std::string& text, RenderRequest& request)
{
    const auto size = readSize(text);
    const auto pixelsOf = [&](double side) {
        return size->inCentimetres ? std::round(side / centimetresPerInch * request.dotsPerInch) : side;
    };
    request.heightFollows = size && !size->height;
    if (!size || !isPictureSide(pixelsOf(size->width)) || (size->height && !isPictureSide(pixelsOf(*size->height))))
        return Error{ErrorKind::WrongUsage,
                     "'" + text + "' does not fit '--size': it takes WIDTHxHEIGHT in pixels, each from 1 to " +
                         std::to_string(largestPictureSide) + ", like " + std::string(defaultSize) +
                         ", or in centimetres, like 16x12cm with '--dpi', or WIDTH alone, like 16cm."};
    request.picture.width = static_cast<int>(pixelsOf(size->width));
    if (size->height)
        request.picture.height = static_cast<int>(pixelsOf(*size->height));
    return {};
}

/// For printing: as asked for, or as good as prints are where the size is that of a print.
Status parseResolution(const Arguments& arguments, RenderRequest& request)
{
    constexpr int usualDotsPerInch = 300;
    constexpr int mostDotsPerInch = 2400;
    const bool inCentimetres = arguments.value("size").value_or("").ends_with("cm");
    if (!arguments.has("dpi")) {
        request.dotsPerInch = inCentimetres ? usualDotsPerInch : 0;
        return {};
    }
    const auto given = wholeNumberOption(arguments, "dpi", usualDotsPerInch, 1, mostDotsPerInch);
    if (!given)
        return given.error();
    request.dotsPerInch = static_cast<int>(*given);
    return {};
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

Status parsePicture(const Arguments& arguments, RenderRequest& request)
{
    if (const Status resolution = parseResolution(arguments, request); !resolution)
        return resolution;
    if (const Status size = parseSize(arguments.value("size").value_or(std::string(defaultSize)), request); !size)
        return size;
    PictureOptions& picture = request.picture;
    if (const Status colour = parseBackground(arguments.value("background").value_or("white"), picture); !colour)
        return colour;
    picture.depth = arguments.has("depth");
    return parseNumberOptions(arguments, picture);
}

Status checkPicture(const RenderRequest& request)
{
    if (const Status good = checkPictureFormat(request.output, request.picture.transparentBackground); !good)
        return good;
    return checkOutput(request.output, std::array{request.input});
}

/// Of depths, which need 16 bits.
Status checkPng(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs)
{
    if (output.extension() != ".png")
        return Error{ErrorKind::WrongUsage,
                     "'" + output.string() + "' does not end in .png, the one format in which depths are written."};
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
    if (const Status good = checkPicture(request); !good)
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
         .explanation = "Size of the picture, in pixels, or in centimetres: 16x12cm. Of a width alone (16cm, or 2400) "
                        "the height follows: that of a session's view, or three quarters of the width.",
         .byDefault = std::string(defaultSize)},
        {.name = "dpi",
         .placeholder = "N",
         .explanation = "Resolution for printing, in pixels per inch (2.54 cm), 1 to 2400; the file says it.",
         .byDefault = "300 if the size is in centimetres"},
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
                        "colours stay as they are, but are spread over the range of another array, and the camera "
                        "stays if the domain is the same."},
        {.name = "bookmark",
         .placeholder = "NAME",
         .explanation = "For a session: draws the view of its bookmark with this name in place of the one that it was "
                        "saved with."},
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
        outputOption("FILE.png",
                     "The picture to write: PNG, TIFF (.tif), JPEG (.jpg) or PDF (.pdf), in which what is written over "
                     "the picture is text and lines.")};
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
    if (const Status picture = parsePicture(arguments, request); !picture)
        return picture.error();
    request.backend = arguments.value("backend").value_or(std::string(defaultBackend));
    if (request.backend != "cpu" && request.backend != "gl")
        return Error{ErrorKind::WrongUsage, "'" + request.backend + "' does not fit '--backend': it takes cpu or gl."};
    if (const Status files = checkFiles(request); !files)
        return files.error();
    return request;
}

Status followWidth(RenderRequest& request)
{
    if (!request.heightFollows)
        return {};
    double ratio = usualRatio;
    if (isSessionFile(request.input) || isPictureFile(request.input)) {
        const auto session = readSession(request.input);
        if (!session)
            return session.error();
        if (session->viewSize[0] > 0 && session->viewSize[1] > 0)
            ratio = static_cast<double>(session->viewSize[0]) / session->viewSize[1];
    }
    const double height = std::round(request.picture.width / ratio);
    request.picture.height = static_cast<int>(std::clamp(height, 1.0, static_cast<double>(largestPictureSide)));
    return {};
}

} // namespace tetra
