// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://ngff.openmicroscopy.org (multiscales 0.1 to 0.5).
#include "plugins/readers/zarr/helper/ome_image.h"

#include "plugins/readers/zarr/helper/zarr_folder.h"
#include "plugins/readers/zarr/helper/zarr_json.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

namespace tetra {
namespace {

Error badImage(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("%1 Export the image again.", what)};
}

/// From version 0.5 all that OME says stands in an object of its own.
QJsonObject omeOf(const QJsonObject& attributes)
{
    const QJsonValue own = attributes.value("ome");
    return own.isObject() ? own.toObject() : attributes;
}

std::string inSmallLetters(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

Result<ZarrAxis> axisOf(const QJsonValue& value)
{
    if (const auto name = jsonText(value)) // version 0.3
        return zarrAxisOfName(*name);
    const QJsonObject object = value.toObject();
    const auto name = jsonText(object.value("name"));
    if (!name)
        return badImage(Message::say("one of its axes has no name."));
    ZarrAxis axis = zarrAxisOfName(*name);
    axis.unit = jsonText(object.value("unit")).value_or(std::string());
    const auto type = jsonText(object.value("type"));
    if (type == "space")
        axis.kind = ZarrAxis::Kind::Space;
    else if (type == "time")
        axis.kind = ZarrAxis::Kind::Time;
    else if (type == "channel")
        axis.kind = ZarrAxis::Kind::Channel;
    else if (type)
        axis.kind = ZarrAxis::Kind::Other;
    return axis;
}

/// The first versions have five axes and do not name them.
Status readAxes(const QJsonObject& multiscale, OmeImage& image)
{
    const QJsonArray list = multiscale.value("axes").toArray();
    for (const QJsonValue value : list) {
        auto axis = axisOf(value);
        if (!axis)
            return axis.error();
        image.axes.push_back(*std::move(axis));
    }
    for (const char* name : {"t", "c", "z", "y", "x"})
        if (list.isEmpty())
            image.axes.push_back(zarrAxisOfName(name));
    if (image.axes.size() > mostZarrAxes)
        return badImage(Message::say("it has %1 axes.", image.axes.size()));
    return {};
}

/// Numbers of one transformation, one an axis.
Result<std::vector<double>> numbersOf(const QJsonObject& transformation, const char* key, std::size_t axes)
{
    if (transformation.contains("path"))
        return badImage(Message::say("its transformation '%1' is in a separate array, which TAn does not read.", key));
    const auto numbers = jsonNumbers(transformation.value(key));
    if (!numbers || numbers->size() != axes)
        return badImage(
            Message::say("its transformation '%1' does not have one number for each of its %2 axes.", key, axes));
    return *numbers;
}

/// Applies transformations, one after the other.
Status transformBy(const QJsonValue& list, std::size_t axes, OmeLevel& level)
{
    for (const QJsonValue value : list.toArray()) {
        const QJsonObject transformation = value.toObject();
        const std::string type = jsonText(transformation.value("type")).value_or("?");
        if (type == "identity")
            continue;
        if (type != "scale" && type != "translation")
            return badImage(Message::say("its transformation is of the kind '%1', and TAn reads 'scale' and "
                                         "'translation'.",
                                         printable(type)));
        const auto numbers = numbersOf(transformation, type.c_str(), axes);
        if (!numbers)
            return numbers.error();
        if (level.scale.empty()) {
            level.scale.assign(axes, 1);
            level.translation.assign(axes, 0);
        }
        for (std::size_t axis = 0; axis < axes; ++axis) {
            if (type == "translation") {
                level.translation[axis] += (*numbers)[axis];
                continue;
            }
            level.scale[axis] *= (*numbers)[axis];
            level.translation[axis] *= (*numbers)[axis];
        }
    }
    return {};
}

Status readLevels(const QJsonObject& multiscale, OmeImage& image)
{
    for (const QJsonValue value : multiscale.value("datasets").toArray()) {
        const QJsonObject dataset = value.toObject();
        const auto name = jsonText(dataset.value("path"));
        if (!name)
            return badImage(Message::say("one of its levels has no path."));
        OmeLevel level{.path = zarrPath(image.path, *name), .name = *name};
        for (const QJsonObject& said : {dataset, multiscale})
            if (const Status placed = transformBy(said.value("coordinateTransformations"), image.axes.size(), level);
                !placed)
                return placed;
        image.levels.push_back(std::move(level));
    }
    return image.levels.empty() ? Status(badImage(Message::say("it names no levels."))) : Status();
}

void readChannelNames(const QJsonObject& ome, OmeImage& image)
{
    for (const QJsonValue channel : ome.value("omero").toObject().value("channels").toArray())
        image.channelNames.push_back(jsonText(channel.toObject().value("label")).value_or(std::string()));
    const bool isAny = std::ranges::any_of(image.channelNames, [](const std::string& name) { return !name.empty(); });
    if (!isAny)
        image.channelNames.clear();
}

struct NamedLength {
    std::string_view name, symbol, shown;
    double metres;
};
constexpr std::array<NamedLength, 11> namedLengths = {{{"picometer", "pm", "pm", 1e-12},
                                                       {"angstrom", "Å", "Å", 1e-10},
                                                       {"nanometer", "nm", "nm", 1e-9},
                                                       {"micrometer", "um", "µm", 1e-6},
                                                       {"micron", "µm", "µm", 1e-6},
                                                       {"millimeter", "mm", "mm", 1e-3},
                                                       {"centimeter", "cm", "cm", 1e-2},
                                                       {"meter", "m", "m", 1},
                                                       {"kilometer", "km", "km", 1e3},
                                                       {"inch", "in", "in", 0.0254},
                                                       {"foot", "ft", "ft", 0.3048}}};

} // namespace

ZarrAxis zarrAxisOfName(const std::string& name)
{
    const std::string small = inSmallLetters(name);
    ZarrAxis axis{.name = name};
    if (small == "x" || small == "y" || small == "z")
        axis.kind = ZarrAxis::Kind::Space;
    else if (small == "t" || small == "time")
        axis.kind = ZarrAxis::Kind::Time;
    else if (small == "c" || small == "ch" || small == "channel")
        axis.kind = ZarrAxis::Kind::Channel;
    return axis;
}

bool isOmeImage(const QJsonObject& attributes)
{
    return omeOf(attributes).value("multiscales").isArray();
}

Result<OmeImage> omeImage(const std::string& path, const QJsonObject& attributes)
{
    const QJsonObject ome = omeOf(attributes);
    const QJsonArray all = ome.value("multiscales").toArray();
    if (all.isEmpty())
        return badImage(Message::say("its list of images ('multiscales') is empty."));
    OmeImage image;
    image.path = path;
    const QJsonObject multiscale = all.first().toObject();
    if (const Status understood = readAxes(multiscale, image); !understood)
        return understood.error();
    if (const Status understood = readLevels(multiscale, image); !understood)
        return understood.error();
    readChannelNames(ome, image);
    if (all.size() > 1)
        image.leftOut.push_back(
            Message::say("Its group describes %1 images; only the first of them is read.", all.size()));
    return image;
}

LengthUnit lengthUnitOf(std::string_view name)
{
    std::string plain(name);
    if (plain.ends_with("metre"))
        plain.replace(plain.size() - 5, 5, "meter");
    for (const NamedLength& length : namedLengths)
        if (plain == length.name || plain == length.symbol)
            return {std::string(length.shown), length.metres};
    return {printable(name), 0};
}

} // namespace tetra
