// SPDX-License-Identifier: GPL-3.0-or-later
// ImageJ's text: https://imagej.net/ij/developer/source/ij/io/FileSaver.java.html and TiffDecoder. OME's:
// https://docs.openmicroscopy.org/ome-model/6.2.0/ome-tiff/specification.html
#include "plugins/readers/images/tiff/image_description.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace tetra {
namespace {

std::string_view stripped(std::string_view text)
{
    constexpr std::string_view filling(" \t\r\n\0", 5);
    text.remove_prefix(std::min(text.find_first_not_of(filling), text.size()));
    return text.substr(0, text.find_last_not_of(filling) + 1);
}

std::optional<double> positive(std::string_view text)
{
    const auto number = parseNumber<double>(stripped(text));
    return number && std::isfinite(*number) && *number > 0 ? number : std::nullopt;
}

/// In metres; nothing for what is no unit of length, or none that is known.
std::optional<double> metres(std::string_view unit)
{
    static const std::map<std::string_view, double> units = {{"pm", 1e-12},  {"Å", 1e-10}, {"nm", 1e-9}, {"µm", 1e-6},
                                                             {"mm", 1e-3},   {"cm", 1e-2}, {"dm", 0.1},  {"m", 1},
                                                             {"in", 0.0254}, {"km", 1e3}};
    const auto found = units.find(unit);
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::map<std::string, std::string, std::less<>> linesOf(std::string_view text)
{
    std::map<std::string, std::string, std::less<>> lines;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size()));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const auto equals = line.find('=');
        if (equals != std::string_view::npos)
            lines.emplace(stripped(line.substr(0, equals)), stripped(line.substr(equals + 1)));
    }
    return lines;
}

/// The name of an element without its namespace.
std::string_view localName(const pugi::xml_node& node)
{
    const std::string_view name = node.name();
    return name.substr(name.rfind(':') + 1);
}

std::vector<pugi::xml_node> childrenOf(const pugi::xml_node& node, std::string_view name)
{
    std::vector<pugi::xml_node> children;
    for (const pugi::xml_node& child : node.children())
        if (localName(child) == name)
            children.push_back(child);
    return children;
}

std::uint64_t wholeOf(const pugi::xml_node& node, const char* name, std::uint64_t ifMissing)
{
    return parseNumber<std::uint64_t>(stripped(node.attribute(name).value())).value_or(ifMissing);
}

Error omeError(const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("its OME description is not understood: %1. Export it again, or as NRRD.", what)};
}

/// The steps between planes, in the order that the letters behind XY say, the fastest first.
bool setOrder(std::string_view order, PictureDescription& description)
{
    if (order.size() != 5 || !order.starts_with("XY"))
        return false;
    std::uint64_t step = 1;
    std::string seen;
    for (const char axis : order.substr(2)) {
        if (seen.find(axis) != std::string::npos)
            return false;
        seen += axis;
        if (axis == 'C') {
            description.channelStep = step;
            step *= description.channels;
        } else if (axis == 'Z') {
            description.sliceStep = step;
            step *= description.slices;
        } else if (axis == 'T') {
            description.timeStep = step;
            step *= description.times;
        } else {
            return false;
        }
    }
    return true;
}

void readOmeSpacing(const pugi::xml_node& pixels, PictureDescription& description)
{
    constexpr std::array names = {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string name = names[axis];
        const pugi::xml_attribute said = pixels.attribute((name + "Unit").c_str());
        const std::string unit = lengthUnitText(said.empty() ? "µm" : said.value());
        const auto length = positive(pixels.attribute(name.c_str()).value());
        const auto own = metres(unit);
        if (!length || !own) // "pixel", "reference frame"
            continue;
        if (description.unit.empty())
            description.unit = unit;
        description.spacing[axis] = description.unit == unit ? *length : *length * *own / *metres(description.unit);
    }
}

/// Of a channel with several samples, as of colours, the planes hold all.
Status readOmeChannels(const pugi::xml_node& pixels, PictureDescription& description)
{
    const std::uint64_t samples = wholeOf(pixels, "SizeC", 1);
    std::uint64_t counted = 0;
    std::vector<std::string> names;
    bool isNamed = false;
    for (const pugi::xml_node& channel : childrenOf(pixels, "Channel")) {
        counted += std::max<std::uint64_t>(1, wholeOf(channel, "SamplesPerPixel", 1));
        const std::string_view name = stripped(channel.attribute("Name").value());
        isNamed = isNamed || !name.empty();
        names.emplace_back(name.empty() ? std::string_view("-") : name);
    }
    if (counted > samples)
        return omeError(Message::say("it has %1 channels and describes %2", samples, counted));
    description.channels = counted == samples && !names.empty() ? names.size() : samples;
    if (isNamed && names.size() == description.channels)
        description.channelNames = std::move(names);
    return {};
}

Status readOmePlanes(const pugi::xml_node& pixels, std::string_view file, PictureDescription& description)
{
    for (const pugi::xml_node& data : childrenOf(pixels, "TiffData")) {
        const bool tellsPage = !data.attribute("IFD").empty();
        const std::uint64_t channel = wholeOf(data, "FirstC", 0), slice = wholeOf(data, "FirstZ", 0),
                            time = wholeOf(data, "FirstT", 0);
        if (slice >= description.slices || time >= description.times)
            return omeError(
                Message::say("a plane lies beyond its %1 slices and %2 times", description.slices, description.times));
        if (channel >= description.channels)
            continue; // one of the samples of a channel that has several
        OmePlanes planes;
        planes.firstPage = wholeOf(data, "IFD", 0);
        planes.firstPlane = description.plane(channel, slice, time);
        planes.count = wholeOf(data, "PlaneCount", tellsPage ? 1 : 0);
        for (const pugi::xml_node& identity : childrenOf(data, "UUID"))
            planes.file = stripped(identity.attribute("FileName").value());
        if (planes.file == file)
            planes.file.clear();
        if (planes.file.find('/') != std::string::npos || planes.file == "..")
            return omeError(Message::say("it names a file of another folder, '%1'", printable(planes.file)));
        description.planes.push_back(std::move(planes));
    }
    return {};
}

} // namespace

std::string lengthUnitText(std::string_view unit)
{
    unit = stripped(unit);
    for (const std::string_view name :
         {"um", "\xc2\xb5m", "\xce\xbcm", "\\u00B5m", "\xb5m", "micron", "microns", "micrometer", "micrometre"})
        if (unit == name)
            return "µm";
    return unit == "inch" ? std::string("in") : std::string(unit);
}

bool isImageJDescription(std::string_view text)
{
    return text.starts_with("ImageJ=") || text.find("\nImageJ=") != std::string_view::npos;
}

bool isOmeDescription(std::string_view text)
{
    const auto element = text.find("OME");
    return stripped(text).starts_with('<') && element != std::string_view::npos && element > 0 &&
           text.find("Pixels") != std::string_view::npos;
}

PictureDescription imageJDescription(std::string_view text, const std::array<std::optional<double>, 2>& pixelsPerUnit,
                                     bool hasOtherUnit)
{
    const auto lines = linesOf(text);
    const auto value = [&](std::string_view key) {
        const auto found = lines.find(key);
        return found == lines.end() ? std::string_view() : std::string_view(found->second);
    };
    const auto count = [&](std::string_view key) {
        const std::uint64_t number = parseNumber<std::uint64_t>(value(key)).value_or(1);
        return number >= 1 && number <= mostPlanes ? number : 1;
    };
    PictureDescription description;
    description.isImageJ = true;
    description.channels = count("channels");
    description.slices = count("slices");
    description.times = count("frames");
    const std::uint64_t images = count("images");
    if (description.channels * description.slices > mostPlanes || description.planeCount() != images) {
        description.channels = description.times = 1;
        description.slices = images;
    }
    setOrder("XYCZT", description);
    const std::string unit = lengthUnitText(value("unit"));
    const bool isMeasured = !unit.empty() && unit != "pixel" && unit != "pixels";
    if (isMeasured)
        description.unit = unit;
    const bool isScaled = !hasOtherUnit && (pixelsPerUnit[0] != 1.0 || pixelsPerUnit[1] != 1.0);
    if ((isMeasured || isScaled) && pixelsPerUnit[0] && pixelsPerUnit[1]) {
        description.spacing[0] = 1 / *pixelsPerUnit[0];
        description.spacing[1] = 1 / *pixelsPerUnit[1];
    }
    const auto depth = parseNumber<double>(value("spacing"));
    if (depth && std::isfinite(*depth) && *depth != 0)
        description.spacing[2] = std::abs(*depth);
    description.betweenTimes = positive(value("finterval"));
    description.timeUnit = value("tunit").empty() ? "s" : value("tunit");
    const auto c0 = parseNumber<double>(value("c0")), c1 = parseNumber<double>(value("c1"));
    if (value("cf") == "0" && c0 && c1 && *c1 == 1 && std::isfinite(*c0))
        description.offset = *c0;
    else
        description.hasCurve = !value("cf").empty();
    description.valueUnit = value("vunit");
    return description;
}

Result<PictureDescription> omeDescription(std::string_view text, std::size_t image, std::string_view file)
{
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed)
        return omeError(Message::say("%1", parsed.description()));
    const pugi::xml_node root = document.document_element();
    const auto images = childrenOf(root, "Image");
    if (images.empty())
        return omeError(Message::say("it has no images; they may be in another file"));
    PictureDescription description;
    for (const pugi::xml_node& each : images) {
        const std::string_view name = stripped(each.attribute("Name").value());
        description.images.emplace_back(name.empty() ? each.attribute("ID").value() : name);
    }
    if (image >= images.size())
        return omeError(Message::say("it has %1 images", images.size()));
    const auto pixels = childrenOf(images[image], "Pixels");
    if (pixels.empty())
        return omeError(Message::say("its image %1 has no pixels", image + 1));
    description.slices = wholeOf(pixels[0], "SizeZ", 1);
    description.times = wholeOf(pixels[0], "SizeT", 1);
    if (const Status read = readOmeChannels(pixels[0], description); !read)
        return read.error();
    for (const std::uint64_t count : {description.channels, description.slices, description.times})
        if (count < 1 || count > mostPlanes)
            return omeError(Message::say("it has %1 slices, channels or times", count));
    if (description.channels * description.slices > mostPlanes || description.planeCount() > mostPlanes)
        return omeError(Message::say("it has more than %1 planes", mostPlanes));
    const std::string_view order = pixels[0].attribute("DimensionOrder").value();
    if (!setOrder(order, description))
        return omeError(Message::say("its order of dimensions is '%1'", printable(order)));
    readOmeSpacing(pixels[0], description);
    description.betweenTimes = positive(pixels[0].attribute("TimeIncrement").value());
    const std::string_view timeUnit = stripped(pixels[0].attribute("TimeIncrementUnit").value());
    description.timeUnit = timeUnit.empty() ? "s" : timeUnit;
    if (const Status read = readOmePlanes(pixels[0], file, description); !read)
        return read.error();
    return description;
}

} // namespace tetra
