// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/stage_json.h"

#include "ui/session/view_json.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr std::array kindNames = {"turntable", "keyFrames"};
constexpr std::array axisKeys = {"vertical", "horizontal"};

template <class Enumeration, std::size_t Count>
const char* nameOf(const std::array<const char*, Count>& names, Enumeration value)
{
    return names[static_cast<std::size_t>(value)];
}

QJsonObject toJson(const KeyFrame& key)
{
    return {{"time", key.time},
            {"camera", toJson(key.frame.camera)},
            {"transfer", toJson(key.frame.transfer)},
            {"isovalues", toJson(key.frame.isovalues)},
            {"error", key.frame.error},
            {"byBudget", key.frame.byBudget},
            {"budget", static_cast<qint64>(key.frame.budget)}};
}

KeyFrame keyOf(const JsonFields& fields, std::optional<Error>& error)
{
    KeyFrame key;
    fields.read("time", key.time);
    if (fields.has("camera"))
        readCamera(fields.object().value("camera"), key.frame.camera, error);
    if (fields.has("transfer"))
        readTransfer(fields.object().value("transfer"), key.frame.transfer, error);
    key.frame.isovalues = isovaluesOf(fields.object().value("isovalues").toArray(), error);
    fields.read("error", key.frame.error);
    fields.read("byBudget", key.frame.byBudget);
    double budget = static_cast<double>(key.frame.budget);
    fields.read("budget", budget);
    constexpr double mostTetrahedra = 1e15;
    key.frame.budget = static_cast<std::uint64_t>(std::clamp(budget, 0.0, mostTetrahedra));
    return key;
}

void readTurntable(const JsonFields& fields, Turntable& turntable)
{
    readName(fields, "axis", axisKeys, turntable.axis);
    fields.read("degrees", turntable.degrees);
    double frames = turntable.frames;
    fields.read("frames", frames);
    turntable.frames = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(mostFrames)));
}

} // namespace

QJsonObject toJson(const AnnotationState& annotations)
{
    QJsonObject object;
    for (std::size_t i = 0; i < annotationCount; ++i)
        object[annotationNames[i]] = QJsonObject{{"shown", annotations.places[i].shown},
                                                 {"corner", nameOf(cornerNames, annotations.places[i].corner)}};
    return object;
}

void readAnnotations(const JsonFields& fields, AnnotationState& annotations)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const JsonFields place = fields.fields(annotationNames[i]);
        place.read("shown", annotations.places[i].shown);
        readName(place, "corner", cornerNames, annotations.places[i].corner);
    }
}

QJsonObject toJson(const Animation& animation)
{
    QJsonArray keys;
    for (const KeyFrame& key : animation.keys)
        keys.append(toJson(key));
    return {{"kind", nameOf(kindNames, animation.kind)},
            {"framesPerSecond", animation.framesPerSecond},
            {"turntable", QJsonObject{{"axis", nameOf(axisKeys, animation.turntable.axis)},
                                      {"degrees", animation.turntable.degrees},
                                      {"frames", animation.turntable.frames}}},
            {"keys", keys}};
}

void readAnimation(const JsonFields& fields, Animation& animation, std::optional<Error>& error)
{
    readName(fields, "kind", kindNames, animation.kind);
    fields.read("framesPerSecond", animation.framesPerSecond);
    readTurntable(fields.fields("turntable"), animation.turntable);
    const QJsonArray keys = fields.object().value("keys").toArray();
    for (qsizetype i = 0; i < keys.size(); ++i)
        animation.keys.push_back(
            keyOf(JsonFields(keys[i].toObject(), QString("animation.keys[%1]").arg(i), error), error));
    animation = corrected(std::move(animation));
}

} // namespace tetra
