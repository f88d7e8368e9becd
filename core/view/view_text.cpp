// SPDX-License-Identifier: GPL-3.0-or-later
// A view as a text and back: what is told in a place of its own (query_text.cpp, appearance_text.cpp), what is written
// over the picture, the film, the camera, all of it, and its bookmarks, which are views themselves.
#include "core/view/view_text.h"

#include "core/base/json_writer.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace tetra {
namespace {

constexpr std::array filmNames = {"turntable", "keyFrames"};
constexpr std::array turntableAxisNames = {"vertical", "horizontal"};

constexpr std::array annotationTexts{std::pair("titleText", &AnnotationState::title),
                                     std::pair("quantity", &AnnotationState::quantity),
                                     std::pair("unit", &AnnotationState::unit)};

constexpr std::array annotationNumbers{std::pair("numbers", &AnnotationState::numbers),
                                       std::pair("lengths", &AnnotationState::lengths)};

JsonValue annotationsToJson(const AnnotationState& annotations)
{
    JsonObject members;
    for (std::size_t i = 0; i < annotationCount; ++i)
        members.append(annotationNames[i], JsonObject{{"shown", annotations.places[i].shown},
                                                      {"corner", jsonName(cornerNames, annotations.places[i].corner)}});
    if (annotations.barEnds)
        members.append("barEnds",
                       JsonObject{{"least", annotations.barEnds->least}, {"largest", annotations.barEnds->largest}});
    for (const auto& [name, text] : annotationTexts)
        if (!(annotations.*text).empty())
            members.append(name, annotations.*text);
    for (const auto& [name, format] : annotationNumbers)
        if (annotations.*format != NumberFormat())
            members.append(name, JsonObject{{"style", jsonName(numberStyleNames, (annotations.*format).style)},
                                            {"decimals", (annotations.*format).decimals}});
    if (annotations.textSize != usualTextSize)
        members.append("textSize", annotations.textSize);
    if (annotations.boldText)
        members.append("boldText", true);
    return members;
}

NumberFormat readNumberFormat(const JsonFields& written)
{
    NumberFormat format;
    double decimals = format.decimals;
    written.readName("style", numberStyleNames, format.style);
    written.read("decimals", decimals);
    format.decimals = static_cast<int>(std::clamp(decimals, 0.0, static_cast<double>(mostDecimals)));
    return format;
}

/// What is left out is that of the data, or as usual.
void readAnnotationTexts(const JsonFields& fields, AnnotationState& annotations)
{
    for (const auto& [name, text] : annotationTexts) {
        (annotations.*text).clear();
        fields.read(name, annotations.*text);
    }
    for (const auto& [name, format] : annotationNumbers)
        annotations.*format = readNumberFormat(fields.fields(name));
    annotations.textSize = usualTextSize;
    fields.read("textSize", annotations.textSize);
    annotations.textSize = std::clamp(annotations.textSize, smallestTextSize, largestTextSize);
    annotations.boldText = false;
    fields.read("boldText", annotations.boldText);
}

void readAnnotations(const JsonFields& fields, AnnotationState& annotations)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const JsonFields place = fields.fields(annotationNames[i]);
        place.read("shown", annotations.places[i].shown);
        place.readName("corner", cornerNames, annotations.places[i].corner);
    }
    if (fields.members() != nullptr) {
        annotations.barEnds.reset(); // where they are left out, they are those of the data
        readAnnotationTexts(fields, annotations);
    }
    if (!fields.has("barEnds"))
        return;
    BarEnds ends;
    const JsonFields written = fields.fields("barEnds");
    written.read("least", ends.least);
    written.read("largest", ends.largest);
    if (isUsable(ends))
        annotations.barEnds = ends;
}

JsonValue lensToJson(const LensState& lens)
{
    return JsonObject{
        {"shape", jsonName(lensShapeNames, lens.shape)}, {"x", lens.x},        {"y", lens.y}, {"radius", lens.radius},
        {"magnification", lens.magnification},           {"error", lens.error}};
}

void readLens(const JsonFields& fields, LensState& lens)
{
    fields.readName("shape", lensShapeNames, lens.shape);
    fields.read("x", lens.x);
    fields.read("y", lens.y);
    fields.read("radius", lens.radius);
    fields.read("magnification", lens.magnification);
    fields.read("error", lens.error);
}

JsonValue cameraToJson(const Camera& camera)
{
    auto json = parseJson(cameraToText(camera));
    return json ? withOwnNumbers(*std::move(json)) : JsonObject(); // with numbers that are none it is no camera
}

void readCamera(const JsonFields& fields, Camera& camera)
{
    const JsonValue* const found = fields.find("camera");
    if (found == nullptr)
        return;
    const Eigen::AlignedBox3d usual(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
    if (const auto read = cameraFromText(compactJson(*found), usual))
        camera = *read;
    else
        fields.refuse(read.error());
}

JsonValue keyToJson(const KeyFrame& key)
{
    return JsonObject{{"time", key.time},
                      {"camera", cameraToJson(key.frame.camera)},
                      {"transfer", toJson(key.frame.transfer)},
                      {"isovalues", toJson(key.frame.isovalues)},
                      {"error", key.frame.error},
                      {"byBudget", key.frame.byBudget},
                      {"budget", key.frame.budget}};
}

KeyFrame readKey(const JsonFields& fields)
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

JsonValue filmToJson(const Animation& animation)
{
    JsonArray keys;
    for (const KeyFrame& key : animation.keys)
        keys.push_back(keyToJson(key));
    const Turntable& turntable = animation.turntable;
    return JsonObject{{"kind", jsonName(filmNames, animation.kind)},
                      {"framesPerSecond", animation.framesPerSecond},
                      {"turntable", JsonObject{{"axis", jsonName(turntableAxisNames, turntable.axis)},
                                               {"degrees", turntable.degrees},
                                               {"frames", turntable.frames}}},
                      {"keys", std::move(keys)}};
}

void readFilm(const JsonFields& fields, Animation& animation)
{
    fields.readName("kind", filmNames, animation.kind);
    fields.read("framesPerSecond", animation.framesPerSecond);
    const JsonFields turntable = fields.fields("turntable");
    turntable.readName("axis", turntableAxisNames, animation.turntable.axis);
    turntable.read("degrees", animation.turntable.degrees);
    double frames = animation.turntable.frames;
    turntable.read("frames", frames);
    animation.turntable.frames = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(mostFrames)));
    if (fields.has("keys"))
        animation.keys.clear();
    for (const JsonFields& key : fields.list("keys"))
        animation.keys.push_back(readKey(key));
    animation = corrected(std::move(animation));
}

JsonValue toolsToJson(const ToolValues& tools)
{
    JsonObject members;
    for (const auto& [id, text] : tools)
        if (!text.empty())
            members.append(id, text);
    return members;
}

void readTools(const JsonFields& fields, ToolValues& tools)
{
    if (fields.members() == nullptr)
        return;
    tools.clear(); // each is whole: none is what is missing
    for (const auto& [id, written] : *fields.members()) {
        std::string text;
        fields.read(id, text);
        if (!text.empty())
            tools[id] = std::move(text);
    }
}

/// All of a view but its bookmarks.
void readOneView(const JsonFields& fields, ViewValue& view)
{
    readQuery(fields.fields("mesh"), view.query);
    readAppearance(fields.fields("look"), view.appearance);
    readIsovalues(fields, view.isovalues);
    readCamera(fields, view.camera);
    readAnnotations(fields.fields("annotations"), view.annotations);
    readFilm(fields.fields("animation"), view.animation);
    if (fields.has("background"))
        view.background = readColour(fields, "background", {});
    readLens(fields.fields("lens"), view.lens);
    readTools(fields.fields("tools"), view.tools);
}

/// Without names they could not be told apart.
void readBookmarks(const JsonFields& fields, std::vector<Bookmark>& bookmarks)
{
    if (!fields.has("views"))
        return;
    bookmarks.clear();
    for (const JsonFields& written : fields.list("views")) {
        Bookmark bookmark;
        written.read("name", bookmark.name);
        readOneView(written, bookmark.view);
        bookmark.view.animation = {};
        if (!bookmark.name.empty() && bookmarks.size() < mostBookmarks)
            bookmarks.push_back(std::move(bookmark));
    }
}

/// All of a view but its film and its bookmarks.
JsonObject lookToJson(const ViewValue& view)
{
    JsonObject members{{"mesh", toJson(view.query)},          {"look", toJson(view.appearance)},
                       {"isovalues", toJson(view.isovalues)}, {"annotations", annotationsToJson(view.annotations)},
                       {"camera", cameraToJson(view.camera)}, {"lens", lensToJson(view.lens)}};
    if (view.background)
        members.append("background", toJson(*view.background));
    if (JsonValue tools = toolsToJson(view.tools); !tools.object()->empty())
        members.append("tools", std::move(tools));
    return members;
}

} // namespace

void readView(const JsonFields& fields, ViewValue& view)
{
    readOneView(fields, view);
    readBookmarks(fields, view.bookmarks);
}

std::string viewToText(const ViewValue& view)
{
    JsonObject members = lookToJson(view);
    members.append("animation", filmToJson(view.animation));
    JsonArray bookmarks;
    for (const Bookmark& bookmark : view.bookmarks) {
        JsonObject written = lookToJson(bookmark.view);
        written.append("name", bookmark.name);
        bookmarks.push_back(std::move(written));
    }
    if (!bookmarks.empty())
        members.append("views", std::move(bookmarks));
    return indentedJson(byName(std::move(members)));
}

Result<ViewValue> viewFromText(std::string_view text, const ViewValue& usual)
{
    const auto wrong = [](const Message& what) {
        return Error{ErrorKind::BadInput, Message::say("The view cannot be read: %1", what)};
    };
    const Result<JsonValue> root = parseJson(text);
    if (!root)
        return wrong(root.error().message);
    if (root->object() == nullptr)
        return wrong(Message::say("it must be an object, in braces."));
    std::optional<Error> error;
    ViewValue view = usual;
    readView(JsonFields(&*root, {}, error), view);
    if (error)
        return wrong(error->message);
    return view;
}

} // namespace tetra
