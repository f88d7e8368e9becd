// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/view_json.h"

#include "core/history/query_words.h"
#include <tan/render.h>
#include <tan/transfer.h>

#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

constexpr std::array shapeNames = {"none", "box", "sphere", "view", "isovalues", "opacity"};
constexpr std::array warpingNames = {"asError", "own", "none"};
constexpr std::array filmNames = {"turntable", "keyFrames"};
constexpr std::array axisNames = {"vertical", "horizontal"};

QJsonArray three(const Eigen::Vector3d& vector)
{
    return {vector[0], vector[1], vector[2]};
}

QJsonArray three(const Colour& colour)
{
    return {colour.red, colour.green, colour.blue};
}

Colour readColour(const JsonFields& fields, const QString& key, const Colour& usual)
{
    std::array<double, 3> channels{usual.red, usual.green, usual.blue};
    fields.readThree(key, channels);
    const auto clamped = [](double channel) { return static_cast<float>(std::clamp(channel, 0.0, 1.0)); };
    return {clamped(channels[0]), clamped(channels[1]), clamped(channels[2])};
}

void readBudget(const JsonFields& fields, std::uint64_t& budget)
{
    constexpr double mostTetrahedra = 1e15;
    auto wide = static_cast<double>(budget);
    fields.read("budget", wide);
    budget = static_cast<std::uint64_t>(std::clamp(wide, 0.0, mostTetrahedra));
}

QJsonArray toJson(const std::vector<MovableRegion>& regions)
{
    QJsonArray list;
    for (const MovableRegion& region : regions) {
        if (const Box* const box = std::get_if<Box>(&region))
            list.append(QJsonObject{{"least", three(box->least)}, {"largest", three(box->largest)}});
        else
            list.append(QJsonObject{{"centre", three(std::get<Sphere>(region).centre)},
                                    {"radius", std::get<Sphere>(region).radius}});
    }
    return list;
}

void readRegions(const JsonFields& fields, std::vector<MovableRegion>& regions)
{
    if (fields.has("others"))
        regions.clear();
    for (const JsonFields& one : fields.list("others")) {
        if (one.has("radius")) {
            Sphere sphere;
            one.readThree("centre", sphere.centre);
            one.read("radius", sphere.radius);
            regions.emplace_back(sphere);
        } else {
            Box box;
            one.readThree("least", box.least);
            one.readThree("largest", box.largest);
            regions.emplace_back(box);
        }
    }
}

QJsonObject toJson(const RangeState& range)
{
    return {{"on", range.enabled},          {"fine", range.fine},     {"coarse", range.coarse},
            {"bornAbove", range.bornAbove}, {"bornTo", range.bornTo}, {"diedFrom", range.diedFrom},
            {"diedTo", range.diedTo}};
}

void readRange(const JsonFields& fields, RangeState& range)
{
    fields.read("on", range.enabled);
    fields.read("fine", range.fine);
    fields.read("coarse", range.coarse);
    fields.read("bornAbove", range.bornAbove);
    fields.read("bornTo", range.bornTo);
    fields.read("diedFrom", range.diedFrom);
    fields.read("diedTo", range.diedTo);
}

QJsonObject toJson(const QueryState& query)
{
    const FocusState& focus = query.focus;
    const Window& window = query.window.window;
    return {
        {"error", query.error},
        {"warping",
         QJsonObject{{"limit", wordOf(warpingNames, query.warping.limit)}, {"percent", query.warping.percent}}},
        {"byBudget", query.byBudget},
        {"budget", static_cast<qint64>(query.budget)},
        {"focus", QJsonObject{{"shape", wordOf(shapeNames, focus.shape)},
                              {"centre", three(focus.centre)},
                              {"size", three(focus.size)},
                              {"radius", focus.radius},
                              {"error", focus.error},
                              {"falloff", focus.falloff},
                              {"distance", focus.distance},
                              {"valueFalloff", focus.valueFalloff},
                              {"others", toJson(focus.others)},
                              {"number", static_cast<qint64>(focus.number)}}},
        {"range", toJson(query.range)},
        {"window", QJsonObject{{"on", query.window.enabled},
                               {"least", three(window.box.least)},
                               {"largest", three(window.box.largest)},
                               {"border", wordOf(borderWords, window.border)}}},
        {"values",
         QJsonObject{{"on", query.values.enabled}, {"least", query.values.least}, {"largest", query.values.largest}}}};
}

void readQuery(const JsonFields& fields, QueryState& query)
{
    fields.read("error", query.error);
    const JsonFields warping = fields.fields("warping");
    readName(warping, "limit", warpingNames, query.warping.limit);
    warping.read("percent", query.warping.percent);
    fields.read("byBudget", query.byBudget);
    readBudget(fields, query.budget);
    const JsonFields focus = fields.fields("focus");
    readName(focus, "shape", shapeNames, query.focus.shape);
    focus.readThree("centre", query.focus.centre);
    focus.readThree("size", query.focus.size);
    focus.read("radius", query.focus.radius);
    focus.read("error", query.focus.error);
    focus.read("falloff", query.focus.falloff);
    focus.read("distance", query.focus.distance);
    focus.read("valueFalloff", query.focus.valueFalloff);
    readRegions(focus, query.focus.others);
    double number = query.focus.number;
    focus.read("number", number);
    query.focus.number = static_cast<std::uint32_t>(std::clamp(number, 0.0, static_cast<double>(mostFocusRegions)));
    readRange(fields.fields("range"), query.range);
    const JsonFields window = fields.fields("window");
    window.read("on", query.window.enabled);
    window.readThree("least", query.window.window.box.least);
    window.readThree("largest", query.window.window.box.largest);
    readName(window, "border", borderWords, query.window.window.border);
    const JsonFields values = fields.fields("values");
    values.read("on", query.values.enabled);
    values.read("least", query.values.least);
    values.read("largest", query.values.largest);
}

QJsonArray toJson(const std::vector<Isovalue>& isovalues);
QJsonObject parsed(const std::string& json);
void readTransfer(const JsonFields& fields, TransferFunction& transfer);
void readIsovalues(const JsonFields& fields, std::vector<Isovalue>& isovalues);

QJsonValue toJson(const ParameterValue& value)
{
    if (const bool* truth = std::get_if<bool>(&value))
        return *truth;
    if (const std::int64_t* integer = std::get_if<std::int64_t>(&value))
        return QJsonObject{{"integer", static_cast<qint64>(*integer)}};
    if (const double* number = std::get_if<double>(&value))
        return QJsonObject{{"number", *number}};
    if (const std::string* text = std::get_if<std::string>(&value))
        return QString::fromStdString(*text);
    if (const Colour* colour = std::get_if<Colour>(&value))
        return QJsonObject{{"colour", QJsonArray{colour->red, colour->green, colour->blue}}};
    if (const Eigen::Vector3d* vector = std::get_if<Eigen::Vector3d>(&value))
        return QJsonObject{{"vector", three(*vector)}};
    if (const OwnValue* own = std::get_if<OwnValue>(&value))
        return QJsonObject{{"type", QString::fromStdString(own->type)}, {"text", QString::fromStdString(own->text)}};
    if (const auto* isovalues = std::get_if<std::vector<Isovalue>>(&value))
        return QJsonObject{{"isovalues", toJson(*isovalues)}};
    return QJsonObject{{"transfer", parsed(transferFunctionToText(std::get<TransferFunction>(value)))}};
}

std::optional<ParameterValue> settingOf(const QJsonValue& value)
{
    if (value.isBool())
        return ParameterValue(value.toBool());
    if (value.isString())
        return ParameterValue(value.toString().toStdString());
    const QJsonObject tagged = value.toObject();
    if (tagged.value("integer").isDouble())
        return ParameterValue(static_cast<std::int64_t>(tagged.value("integer").toInteger()));
    if (tagged.value("number").isDouble())
        return ParameterValue(tagged.value("number").toDouble());
    const auto numberOf = [](const QJsonArray& list, int index) { return list.at(index).toDouble(); };
    if (const QJsonArray colour = tagged.value("colour").toArray(); colour.size() == 3)
        return ParameterValue(Colour{static_cast<float>(numberOf(colour, 0)), static_cast<float>(numberOf(colour, 1)),
                                     static_cast<float>(numberOf(colour, 2))});
    if (const QJsonArray vector = tagged.value("vector").toArray(); vector.size() == 3)
        return ParameterValue(Eigen::Vector3d(numberOf(vector, 0), numberOf(vector, 1), numberOf(vector, 2)));
    if (tagged.value("type").isString() && tagged.value("text").isString())
        return ParameterValue(
            OwnValue{tagged.value("type").toString().toStdString(), tagged.value("text").toString().toStdString()});
    std::optional<Error> error;
    const JsonFields fields(tagged, {}, error);
    ParameterValue setting;
    if (fields.has("isovalues"))
        readIsovalues(fields, setting.emplace<std::vector<Isovalue>>());
    else if (fields.has("transfer"))
        readTransfer(fields, setting.emplace<TransferFunction>());
    else
        return std::nullopt;
    return error ? std::nullopt : std::optional(setting);
}

/// Of a text that the core writes.
QJsonObject parsed(const std::string& json)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

std::string textOf(const QJsonValue& value)
{
    return QJsonDocument(value.toObject()).toJson().toStdString();
}

/// By a function of the core.
template <class Value, class Reader>
void readBy(const Reader& reader, const JsonFields& fields, const QString& key, Value& value)
{
    if (!fields.has(key))
        return;
    if (const auto read = reader(textOf(fields.object().value(key))))
        value = *read;
    else
        fields.refuse(read.error());
}

void readTransfer(const JsonFields& fields, TransferFunction& transfer)
{
    readBy([](const std::string& text) { return transferFunctionFromText(text); }, fields, "transfer", transfer);
}

void readCamera(const JsonFields& fields, Camera& camera)
{
    const Eigen::AlignedBox3d usual(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
    readBy([&](const std::string& text) { return cameraFromText(text, usual); }, fields, "camera", camera);
}

QJsonObject toJson(const Appearance& appearance)
{
    QJsonObject settings;
    for (const auto& [id, value] : appearance.settings)
        if (const QJsonValue json = toJson(value); !json.isNull())
            settings.insert(QString::fromStdString(id), json);
    return {{"mode", QString::fromStdString(appearance.mode)},
            {"transfer", parsed(transferFunctionToText(appearance.transfer))},
            {"settings", settings}};
}

void readAppearance(const JsonFields& fields, Appearance& appearance)
{
    fields.read("mode", appearance.mode);
    readTransfer(fields, appearance.transfer);
    const QJsonObject settings = fields.fields("settings").object();
    for (auto setting = settings.begin(); setting != settings.end(); ++setting)
        if (const auto value = settingOf(setting.value()))
            appearance.settings[setting.key().toStdString()] = *value;
}

QJsonArray toJson(const std::vector<Isovalue>& isovalues)
{
    QJsonArray list;
    for (const Isovalue& isovalue : isovalues)
        list.append(QJsonObject{{"value", isovalue.value},
                                {"colour", three(Colour{isovalue.red, isovalue.green, isovalue.blue})},
                                {"opacity", isovalue.opacity},
                                {"visible", isovalue.visible}});
    return list;
}

void readIsovalues(const JsonFields& fields, std::vector<Isovalue>& isovalues)
{
    if (fields.has("isovalues"))
        isovalues.clear();
    for (const JsonFields& one : fields.list("isovalues")) {
        Isovalue isovalue;
        one.read("value", isovalue.value);
        const Colour colour = readColour(one, "colour", {isovalue.red, isovalue.green, isovalue.blue});
        isovalue.red = colour.red;
        isovalue.green = colour.green;
        isovalue.blue = colour.blue;
        one.read("opacity", isovalue.opacity);
        one.read("visible", isovalue.visible);
        isovalues.push_back(isovalue);
    }
}

QJsonObject toJson(const AnnotationState& annotations)
{
    QJsonObject object;
    for (std::size_t i = 0; i < annotationCount; ++i)
        object[annotationNames[i]] = QJsonObject{{"shown", annotations.places[i].shown},
                                                 {"corner", wordOf(cornerNames, annotations.places[i].corner)}};
    if (annotations.barEnds)
        object["barEnds"] =
            QJsonObject{{"least", annotations.barEnds->least}, {"largest", annotations.barEnds->largest}};
    return object;
}

void readAnnotations(const JsonFields& fields, AnnotationState& annotations)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const JsonFields place = fields.fields(annotationNames[i]);
        place.read("shown", annotations.places[i].shown);
        readName(place, "corner", cornerNames, annotations.places[i].corner);
    }
    annotations.barEnds.reset();
    if (!fields.has("barEnds"))
        return;
    BarEnds ends;
    const JsonFields written = fields.fields("barEnds");
    written.read("least", ends.least);
    written.read("largest", ends.largest);
    if (isUsable(ends))
        annotations.barEnds = ends;
}

QJsonObject toJson(const LensState& lens)
{
    return {{"shape", wordOf(lensShapeNames, lens.shape)}, {"x", lens.x},        {"y", lens.y}, {"radius", lens.radius},
            {"magnification", lens.magnification},         {"error", lens.error}};
}

void readLens(const JsonFields& fields, LensState& lens)
{
    readName(fields, "shape", lensShapeNames, lens.shape);
    fields.read("x", lens.x);
    fields.read("y", lens.y);
    fields.read("radius", lens.radius);
    fields.read("magnification", lens.magnification);
    fields.read("error", lens.error);
}

QJsonObject toJson(const KeyFrame& key)
{
    return {{"time", key.time},
            {"camera", parsed(cameraToText(key.frame.camera))},
            {"transfer", parsed(transferFunctionToText(key.frame.transfer))},
            {"isovalues", toJson(key.frame.isovalues)},
            {"error", key.frame.error},
            {"byBudget", key.frame.byBudget},
            {"budget", static_cast<qint64>(key.frame.budget)}};
}

KeyFrame keyOf(const JsonFields& fields)
{
    KeyFrame key;
    fields.read("time", key.time);
    readCamera(fields, key.frame.camera);
    readTransfer(fields, key.frame.transfer);
    readIsovalues(fields, key.frame.isovalues);
    fields.read("error", key.frame.error);
    fields.read("byBudget", key.frame.byBudget);
    readBudget(fields, key.frame.budget);
    return key;
}

QJsonObject toJson(const Animation& animation)
{
    QJsonArray keys;
    for (const KeyFrame& key : animation.keys)
        keys.append(toJson(key));
    return {{"kind", wordOf(filmNames, animation.kind)},
            {"framesPerSecond", animation.framesPerSecond},
            {"turntable", QJsonObject{{"axis", wordOf(axisNames, animation.turntable.axis)},
                                      {"degrees", animation.turntable.degrees},
                                      {"frames", animation.turntable.frames}}},
            {"keys", keys}};
}

void readAnimation(const JsonFields& fields, Animation& animation)
{
    readName(fields, "kind", filmNames, animation.kind);
    fields.read("framesPerSecond", animation.framesPerSecond);
    const JsonFields turntable = fields.fields("turntable");
    readName(turntable, "axis", axisNames, animation.turntable.axis);
    turntable.read("degrees", animation.turntable.degrees);
    double frames = animation.turntable.frames;
    turntable.read("frames", frames);
    animation.turntable.frames = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(mostFrames)));
    if (fields.has("keys"))
        animation.keys.clear();
    for (const JsonFields& key : fields.list("keys"))
        animation.keys.push_back(keyOf(key));
    animation = corrected(std::move(animation));
}

} // namespace

QJsonObject toJson(const ViewValue& view)
{
    QJsonObject object{{"mesh", toJson(view.query)},          {"look", toJson(view.appearance)},
                       {"isovalues", toJson(view.isovalues)}, {"annotations", toJson(view.annotations)},
                       {"animation", toJson(view.animation)}, {"camera", parsed(cameraToText(view.camera))}};
    if (view.background)
        object["background"] = three(*view.background);
    object["lens"] = toJson(view.lens);
    return object;
}

void readView(const JsonFields& fields, ViewValue& view)
{
    readQuery(fields.fields("mesh"), view.query);
    readAppearance(fields.fields("look"), view.appearance);
    readIsovalues(fields, view.isovalues);
    readCamera(fields, view.camera);
    readAnnotations(fields.fields("annotations"), view.annotations);
    readAnimation(fields.fields("animation"), view.animation);
    if (fields.has("background"))
        view.background = readColour(fields, "background", {});
    readLens(fields.fields("lens"), view.lens);
}

} // namespace tetra
